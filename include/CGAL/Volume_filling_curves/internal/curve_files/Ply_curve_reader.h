// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Binary_ply_items.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Ply_header.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/without_lines.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads a PLY file with the elements `vertex`, of which x, y, z and `pinned` matter, and `edge`,
// with vertex1 and vertex2. Each item has a line; those of a binary file are given lines, which do
// not count as lines of the file. Other elements and properties are passed over. Linear time.
class Ply_curve_reader
{
public:
  explicit Ply_curve_reader(std::string_view text)
      : m_readable(text),
        m_words(m_readable.text()),
        m_header(m_words, m_readable.is_complete(), m_file),
        m_is_binary(m_header.is_complete() && m_header.format() != Ply_format::ASCII)
  {
    if(!m_is_binary) return;
    const std::size_t end_of_header = m_readable.text().size() - m_words.rest().size();
    const bool is_big_endian = m_header.format() == Ply_format::BINARY_BIG_ENDIAN;
    m_items =
        Binary_ply_items(text.substr(end_of_header), is_big_endian).to_text(m_header.elements());
    m_words = Text_scanner(m_items);
  }

  Curve_draft run()
  {
    m_file.is_complete = m_header.is_complete() && read_elements() && is_readable();
    if(!is_readable()) refuse(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
    if(m_file.is_complete) {
      check_indices();
      if(m_edges.empty()) take_without_lines(m_file, m_line_of_face, line());
    }
    return std::move(m_file);
  }

private:
  static constexpr std::size_t none = Ply_element::none;

  struct Edge
  {
    std::array<std::size_t, 2> nodes;
    std::size_t line;
  };

  bool refuse(Curve_defect_kind kind, const std::string& message)
  {
    if(!m_file.defects.has_error()) m_file.defects.add({kind, message, line()});
    return false;
  }

  std::size_t line() const { return m_is_binary ? 0 : m_words.line(); }

  // Only the items can be binary, and only if the header says so.
  bool is_readable() const { return m_is_binary || m_readable.is_complete(); }

  bool read_elements()
  {
    for(const Ply_element& element : m_header.elements()) {
      const bool is_vertex = element.name == "vertex", is_edge = element.name == "edge";
      if((is_vertex || is_edge) && element.has_list())
        return refuse(Curve_defect_kind::UNKNOWN_FORMAT,
                      "a list is no property of " + std::string(element.name));
      if((element.name == "face" || element.name == "tristrips") && element.count > 0)
        m_line_of_face = m_is_binary ? element.line : line();
      if(is_vertex ? !read_vertices(element) : is_edge ? !read_edges(element) : !pass_over(element))
        return false;
    }
    return true;
  }

  // Reads the words of the next line that has any. Returns whether there are enough.
  bool read_item(const Ply_element& element, std::size_t number)
  {
    while(!m_words.is_at_end()) {
      m_line = line();
      m_item.clear();
      for(auto word = m_words.next_word(); !word.empty(); word = m_words.next_word())
        m_item.push_back(word);
      m_words.next_record();
      if(m_item.empty()) continue;
      if(element.has_list() || m_item.size() >= element.properties.size()) return true;
      m_file.defects.add({Curve_defect_kind::MISSING_COORDINATES,
                          std::string(element.name) + " has " + std::to_string(m_item.size()) +
                              " of " + std::to_string(element.properties.size()) + " values",
                          m_line,
                          {Curve_draft::number(number)}});
      return false;
    }
    return is_readable() &&
           refuse(Curve_defect_kind::WRONG_POINT_COUNT,
                  "the file ends after " + std::to_string(number) + " of " +
                      std::to_string(element.count) + " items of " + std::string(element.name));
  }

  bool pass_over(const Ply_element& element)
  {
    for(std::size_t i = 0; i < element.count; ++i)
      if(!read_item(element, i)) return false;
    return true;
  }

  bool read_vertices(const Ply_element& element)
  {
    const std::array<std::size_t, 3> places = {element.place("x"), element.place("y"),
                                               element.place("z")};
    const std::size_t pinned = element.place("pinned");
    if(std::find(places.begin(), places.end(), none) != places.end())
      return refuse(Curve_defect_kind::MISSING_COORDINATES, "vertices have no x, y and z");
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!read_item(element, i)) return false;
      if(pinned != none && is_set(m_item[pinned])) m_file.pinned.push_back(m_file.points.size());
      add_vertex(places);
    }
    return true;
  }

  void add_vertex(const std::array<std::size_t, 3>& places)
  {
    Curve_draft::Point point;
    for(std::size_t k = 0; k < 3; ++k)
      if(!parse_number(m_item[places[k]], point[k]))
        return m_file.add_unreadable_point({Curve_defect_kind::UNPARSABLE_NUMBER,
                                            quoted(m_item[places[k]]) + " is not a number",
                                            m_line,
                                            {Curve_draft::number(m_file.points.size())}});
    m_file.add_point(point, m_line);
  }

  bool read_edges(const Ply_element& element)
  {
    const std::array<std::size_t, 2> places = {element.place("vertex1"), element.place("vertex2")};
    if(places[0] == none || places[1] == none)
      return refuse(Curve_defect_kind::BAD_INDEX, "edges have no vertex1 and vertex2");
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!read_item(element, i)) return false;
      Edge edge{{none, none}, m_line};
      for(std::size_t k = 0; k < 2; ++k)
        if(!parse_integer(m_item[places[k]], edge.nodes[k])) edge.nodes[k] = none;
      m_edges.push_back(edge);
    }
    return true;
  }

  // Vertices may follow the edges.
  void check_indices()
  {
    const std::size_t n = m_file.points.size();
    for(const Edge& edge : m_edges)
      if(edge.nodes[0] < n && edge.nodes[1] < n)
        m_file.add_edge(edge.nodes[0], edge.nodes[1], edge.line);
      else
        m_file.defects.add(
            {Curve_defect_kind::BAD_INDEX,
             "an edge has an index that is not in 0 to " + std::to_string(n) + " - 1", edge.line});
  }

  Readable_text m_readable;
  std::string m_items; // of a binary file, as they stand in one in ASCII
  Text_scanner m_words;
  Curve_draft m_file;
  Ply_header m_header;
  bool m_is_binary;
  std::vector<std::string_view> m_item; // the words of a line
  std::size_t m_line = 0;               // its number
  std::vector<Edge> m_edges;
  std::size_t m_line_of_face = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H
