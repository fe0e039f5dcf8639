// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_TEXT_DIAGNOSIS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_TEXT_DIAGNOSIS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Mesh_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Text_scanner.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Where is an OFF or OBJ file wrong that CGAL's reader has refused without a reason? Reads the file
// again, line by line, and lists what is no number, no index or missing. Linear time.
class Mesh_text_diagnosis
{
public:
  explicit Mesh_text_diagnosis(std::string_view text) : m_scanner(text) {}

  std::vector<Mesh_defect> of_off()
  {
    std::string_view word = next_filled_record();
    if(word.size() < 3 || word.substr(word.size() - 3) != "OFF") return {};
    word = m_scanner.next_word();
    if(word.empty()) word = next_filled_record();
    std::size_t vertices = 0, faces = 0;
    if(!parse_integer(word, vertices) || !parse_integer(m_scanner.next_word(), faces)) return {};
    for(std::size_t i = 0; i < vertices && !is_cut_off("vertex", i, vertices); ++i)
      read_coordinates(m_word);
    for(std::size_t i = 0; i < faces && !is_cut_off("face", i, faces); ++i) read_off_face(vertices);
    return std::move(m_defects);
  }

  std::vector<Mesh_defect> of_obj()
  {
    std::size_t vertices = 0;
    std::vector<std::pair<std::size_t, long long>> indices; // with their lines
    for(std::string_view word = next_filled_record(); !word.empty(); word = next_filled_record()) {
      if(word == "v") {
        read_coordinates(m_scanner.next_word());
        ++vertices;
      } else if(word == "f") {
        read_obj_face(static_cast<long long>(vertices), indices);
      }
    }
    for(const auto& [line, index] : indices)
      if(index < 1 || index > static_cast<long long>(vertices))
        m_defects.push_back(
            {Mesh_defect_kind::BAD_INDEX, "there is no vertex " + std::to_string(index), line});
    return std::move(m_defects);
  }

private:
  // goes to the next line that is not empty and returns its first word, an empty one at the end
  std::string_view next_filled_record()
  {
    if(m_has_begun) m_scanner.next_record();
    m_has_begun = true;
    for(;;) {
      const std::string_view word = m_scanner.next_word();
      if(!word.empty() || m_scanner.is_at_end()) return word;
      m_scanner.next_record();
    }
  }

  // goes to the record of the next item, of which there are i up to now
  bool is_cut_off(const char* item, std::size_t i, std::size_t announced)
  {
    if(m_is_cut_off) return true;
    m_word = next_filled_record();
    m_is_cut_off = m_word.empty();
    if(m_is_cut_off)
      m_defects.push_back({Mesh_defect_kind::TRUNCATED_FILE,
                           "the file ends after " + std::to_string(i) + " of " +
                               std::to_string(announced) +
                               (item[0] == 'v' ? " vertices" : " faces"),
                           m_scanner.line()});
    return m_is_cut_off;
  }

  void read_coordinates(std::string_view word)
  {
    for(int axis = 0; axis < 3; ++axis, word = m_scanner.next_word()) {
      double x = 0;
      if(!parse_number(word, x))
        return add(Mesh_defect_kind::UNPARSABLE_NUMBER, quoted(word) + " is no coordinate");
      if(!std::isfinite(x))
        return add(Mesh_defect_kind::NON_FINITE_COORDINATE, "a coordinate is not finite");
    }
  }

  void read_off_face(std::size_t vertices)
  {
    std::size_t corners = 0;
    if(!parse_integer(m_word, corners))
      return add(Mesh_defect_kind::UNPARSABLE_NUMBER, quoted(m_word) + " is no number of corners");
    for(std::size_t i = 0; i < corners; ++i) {
      const std::string_view word = m_scanner.next_word();
      long long index = 0;
      if(!parse_integer(word, index))
        return add(Mesh_defect_kind::BAD_INDEX,
                   word.empty() ? "a corner is missing" : quoted(word) + " is no vertex index");
      if(index < 0 || static_cast<std::size_t>(index) >= vertices)
        add(Mesh_defect_kind::BAD_INDEX,
            "there is no vertex " + std::to_string(index) + " (they count from 0)");
    }
  }

  // an index may be followed by those of a texture and a normal; negative ones count backwards
  void read_obj_face(long long vertices, std::vector<std::pair<std::size_t, long long>>& indices)
  {
    for(auto word = m_scanner.next_word(); !word.empty(); word = m_scanner.next_word()) {
      long long index = 0;
      if(!parse_integer(word.substr(0, word.find('/')), index))
        return add(Mesh_defect_kind::BAD_INDEX, quoted(word) + " is no vertex index");
      indices.push_back({m_scanner.line(), index < 0 ? vertices + 1 + index : index});
    }
  }

  void add(Mesh_defect_kind kind, std::string message)
  {
    m_defects.push_back({kind, std::move(message), m_scanner.line()});
  }

  Text_scanner m_scanner;
  std::string_view m_word; // the first one of the current record
  bool m_has_begun = false, m_is_cut_off = false;
  std::vector<Mesh_defect> m_defects;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_TEXT_DIAGNOSIS_H
