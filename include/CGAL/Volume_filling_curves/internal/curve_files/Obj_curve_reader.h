// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_OBJ_CURVE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_OBJ_CURVE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reader of curves in Wavefront OBJ files: vertices `v`, polylines `l`, and the pinned vertices
// `fixed`, a record of the authors of "Medial Sphere Preconditioning for Knot Untangling and
// Volume-Filling Curves" (2025). An `l` may precede its vertices; indices are resolved at the end
// of the file. All other records are ignored. Linear time.
class Obj_curve_reader
{
public:
  explicit Obj_curve_reader(std::string_view text) : m_readable(text), m_scanner(m_readable.text())
  {}

  Curve_draft run()
  {
    for(; !m_scanner.is_at_end(); m_scanner.next_record()) read_record();
    if(!m_readable.is_complete()) {
      add_defect(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
      m_file.is_complete = false;
    }
    if(m_file.is_complete && !has_lines()) take_face_for_line();
    for(const Index_list& list : m_lists) connect(list);
    if(m_file.is_complete && !has_lines())
      m_file.take_without_lines(m_first_face_line, m_scanner.line());
    return std::move(m_file);
  }

private:
  // the indices m_indices[first] .. m_indices[last - 1] of an `l` or `fixed` record
  struct Index_list
  {
    std::size_t line, first, last;
    bool is_line;
  };

  static constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);

  void read_record()
  {
    const std::string_view keyword = m_scanner.next_word();
    if(keyword == "v")
      read_vertex();
    else if(keyword == "l")
      read_indices(true);
    else if(keyword == "fixed")
      read_indices(false);
    else if(keyword == "f" || keyword == "fo")
      read_face();
    else if(!keyword.empty())
      check_keyword(keyword);
  }

  // Ignores weights and colors after the coordinates.
  void read_vertex()
  {
    const std::size_t line = m_scanner.line(), number = Curve_draft::number(m_file.points.size());
    Curve_draft::Point point;
    for(double& x : point) {
      const std::string_view word = m_scanner.next_word();
      if(word.empty())
        return m_file.add_unreadable_point({Curve_defect_kind::MISSING_COORDINATES,
                                            "a vertex needs three coordinates",
                                            line,
                                            {number}});
      if(!parse_number(word, x))
        return m_file.add_unreadable_point({Curve_defect_kind::UNPARSABLE_NUMBER,
                                            quoted(word) + " is not a number",
                                            line,
                                            {number}});
    }
    m_file.add_point(point, line);
  }

  // Keeps the corners of the first face, which matters only if it is the only one.
  void read_face()
  {
    if(++m_number_of_faces > 1) return;
    m_first_face_line = m_scanner.line();
    for(auto word = m_scanner.next_word(); !word.empty(); word = m_scanner.next_word())
      m_corners_of_face.push_back(word);
  }

  // Some programs write a loop as the only face of a file. A triangle or quadrangle is a mesh.
  void take_face_for_line()
  {
    if(m_number_of_faces != 1 || m_corners_of_face.size() <= 4) return;
    const std::size_t first = m_indices.size();
    for(const std::string_view corner : m_corners_of_face) m_indices.push_back(read_index(corner));
    m_indices.push_back(m_indices[first]);
    m_lists.push_back({m_first_face_line, first, m_indices.size(), true});
    m_file.defects.add({Curve_defect_kind::NO_LINES,
                        "there are no lines; the only face is read as a closed curve",
                        m_first_face_line});
  }

  void read_indices(bool is_line)
  {
    const std::size_t line = m_scanner.line(), first = m_indices.size();
    for(auto word = m_scanner.next_word(); !word.empty(); word = m_scanner.next_word())
      m_indices.push_back(read_index(word));
    m_lists.push_back({line, first, m_indices.size(), is_line});
    if(is_line && m_indices.size() - first < 2)
      m_file.defects.add({Curve_defect_kind::SHORT_LINE, "a line needs two indices", line});
  }

  // Returns the vertex that `i`, `i/t` or, counted from the last vertex, `-i` means. A positive
  // index can still be out of range.
  std::size_t read_index(std::string_view word)
  {
    const std::size_t slash = (std::min)(word.find('/'), word.size());
    long long index = 0;
    if(!parse_integer(word.substr(0, slash), index) || !is_texture(word.substr(slash))) {
      add_defect(Curve_defect_kind::BAD_INDEX, quoted(word) + " is not an index");
      return no_vertex;
    }
    const auto number_of_points = static_cast<long long>(m_file.points.size());
    if(index > 0) return static_cast<std::size_t>(index - 1);
    if(index < 0 && index >= -number_of_points)
      return static_cast<std::size_t>(number_of_points + index);
    add_defect(Curve_defect_kind::BAD_INDEX,
               index == 0 ? "the index 0 means nothing, vertices count from 1"
                          : "the index " + std::to_string(index) + " is before the first vertex");
    return no_vertex;
  }

  static bool is_texture(std::string_view word)
  {
    return word.find_first_not_of("/-0123456789") == std::string_view::npos;
  }

  void connect(const Index_list& list)
  {
    for(std::size_t i = list.first; i < list.last; ++i) {
      std::size_t& v = m_indices[i];
      if(v != no_vertex && v >= m_file.points.size()) {
        m_file.defects.add({Curve_defect_kind::BAD_INDEX,
                            "the index " + std::to_string(Curve_draft::number(v)) +
                                " is out of range, the file has " +
                                counted(m_file.points.size(), "vertex", "vertices"),
                            list.line});
        v = no_vertex;
      }
      if(v == no_vertex) continue;
      if(!list.is_line)
        m_file.pinned.push_back(v);
      else if(i > list.first && m_indices[i - 1] != no_vertex)
        m_file.add_edge(m_indices[i - 1], v, list.line);
    }
  }

  bool has_lines() const
  {
    return std::any_of(m_lists.begin(), m_lists.end(),
                       [](const Index_list& list) { return list.is_line; });
  }

  // Reports the first unknown record. Only names and comments may contain bytes beyond ASCII.
  void check_keyword(std::string_view keyword)
  {
    const auto is_ascii = [](char c) { return c > 0; };
    if(!std::all_of(keyword.begin(), keyword.end(), is_ascii)) {
      m_file.is_complete = false;
      return add_defect(Curve_defect_kind::BINARY_DATA,
                        quoted(keyword) + " does not belong in a text file");
    }
    if(is_obj_keyword(keyword) || m_has_unknown_record) return;
    m_has_unknown_record = true;
    add_defect(Curve_defect_kind::UNKNOWN_RECORD,
               quoted(keyword) + " is no record of an OBJ file and is ignored");
  }

  static bool is_obj_keyword(std::string_view keyword)
  {
    static constexpr std::string_view keywords[] = {
        "vt",         "vn",        "vp",    "p",      "o",      "g",      "s",      "mg",
        "f",          "fo",        "deg",   "bmat",   "step",   "cstype", "curv",   "curv2",
        "surf",       "parm",      "trim",  "hole",   "scrv",   "sp",     "end",    "con",
        "bevel",      "c_interp",  "lod",   "usemtl", "mtllib", "usemap", "maplib", "d_interp",
        "shadow_obj", "trace_obj", "ctech", "stech",  "call",   "csh"};
    return std::find(std::begin(keywords), std::end(keywords), keyword) != std::end(keywords);
  }

  void add_defect(Curve_defect_kind kind, std::string message)
  {
    m_file.defects.add({kind, std::move(message), m_scanner.line()});
  }

  Readable_text m_readable;
  Text_scanner m_scanner;
  Curve_draft m_file;
  std::vector<std::size_t> m_indices;
  std::vector<Index_list> m_lists;
  std::vector<std::string_view> m_corners_of_face; // of the first face
  std::size_t m_first_face_line = 0, m_number_of_faces = 0;
  bool m_has_unknown_record = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_OBJ_CURVE_READER_H
