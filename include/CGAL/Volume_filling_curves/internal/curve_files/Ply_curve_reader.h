// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/without_lines.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

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
// with vertex1 and vertex2. The header lists the elements, their numbers and their properties; then
// each item has a line. Other elements and properties are passed over. Linear time.
class Ply_curve_reader
{
public:
  explicit Ply_curve_reader(std::string_view text) : m_readable(text), m_words(m_readable.text()) {}

  Curve_draft run()
  {
    m_file.is_complete = read_header() && read_elements() && m_readable.is_complete();
    if(!m_readable.is_complete() && !m_file.defects.has_error())
      refuse(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
    if(m_file.is_complete) {
      check_indices();
      if(m_edges.empty()) take_without_lines(m_file, m_line_of_face, m_words.line());
    }
    return std::move(m_file);
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Element
  {
    std::string_view name;
    std::size_t count;
    std::vector<std::string_view> properties = {};
    bool has_list = false; // so that the places of properties are not known

    std::size_t place(std::string_view property) const
    {
      const auto found = std::find(properties.begin(), properties.end(), property);
      return found == properties.end() ? none
                                       : static_cast<std::size_t>(found - properties.begin());
    }
  };

  struct Edge
  {
    std::array<std::size_t, 2> nodes;
    std::size_t line;
  };

  bool refuse(Curve_defect_kind kind, const std::string& message)
  {
    m_file.defects.add({kind, message, m_words.line()});
    return false;
  }

  bool read_header()
  {
    if(m_words.next_word() != "ply")
      return refuse(Curve_defect_kind::UNKNOWN_FORMAT, "the first word is not ply");
    for(m_words.next_record(); !m_words.is_at_end(); m_words.next_record()) {
      const std::string_view keyword = m_words.next_word();
      if(keyword == "end_header") {
        m_words.next_record();
        return true;
      }
      if(!read_header_line(keyword)) return false;
    }
    // only the data can be binary, and only if the header says so
    return m_readable.is_complete() &&
           refuse(Curve_defect_kind::WRONG_POINT_COUNT, "the header has no end_header");
  }

  bool read_header_line(std::string_view keyword)
  {
    if(keyword == "format") {
      const std::string_view format = m_words.next_word();
      return format == "ascii" ||
             refuse(Curve_defect_kind::BINARY_DATA, quoted(format) + " is not the format ascii");
    }
    if(keyword == "element") {
      const std::string_view name = m_words.next_word(), word = m_words.next_word();
      m_elements.push_back({name, 0});
      return parse_integer(word, m_elements.back().count) ||
             refuse(Curve_defect_kind::UNPARSABLE_NUMBER,
                    quoted(word) + " is not a number of items");
    }
    if(keyword == "property") return read_property();
    if(keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
    return refuse(Curve_defect_kind::UNKNOWN_FORMAT,
                  quoted(keyword) + " does not belong in the header");
  }

  bool read_property()
  {
    if(m_elements.empty())
      return refuse(Curve_defect_kind::UNKNOWN_FORMAT, "a property comes before any element");
    Element& element = m_elements.back();
    if(m_words.next_word() == "list") element.has_list = true;
    element.properties.push_back(m_words.next_word());
    return true;
  }

  bool read_elements()
  {
    for(const Element& element : m_elements) {
      const bool is_vertex = element.name == "vertex", is_edge = element.name == "edge";
      if((is_vertex || is_edge) && element.has_list)
        return refuse(Curve_defect_kind::UNKNOWN_FORMAT,
                      "a list is no property of " + std::string(element.name));
      if(element.name == "face" && element.count > 0) m_line_of_face = m_words.line();
      if(is_vertex ? !read_vertices(element) : is_edge ? !read_edges(element) : !pass_over(element))
        return false;
    }
    return true;
  }

  // Reads the words of the next line that has any. Returns whether there are enough.
  bool read_item(const Element& element, std::size_t number)
  {
    while(!m_words.is_at_end()) {
      m_line = m_words.line();
      m_item.clear();
      for(auto word = m_words.next_word(); !word.empty(); word = m_words.next_word())
        m_item.push_back(word);
      m_words.next_record();
      if(m_item.empty()) continue;
      if(element.has_list || m_item.size() >= element.properties.size()) return true;
      m_file.defects.add({Curve_defect_kind::MISSING_COORDINATES,
                          std::string(element.name) + " has " + std::to_string(m_item.size()) +
                              " of " + std::to_string(element.properties.size()) + " values",
                          m_line,
                          {Curve_draft::number(number)}});
      return false;
    }
    return m_readable.is_complete() &&
           refuse(Curve_defect_kind::WRONG_POINT_COUNT,
                  "the file ends after " + std::to_string(number) + " of " +
                      std::to_string(element.count) + " items of " + std::string(element.name));
  }

  bool pass_over(const Element& element)
  {
    for(std::size_t i = 0; i < element.count; ++i)
      if(!read_item(element, i)) return false;
    return true;
  }

  bool read_vertices(const Element& element)
  {
    const std::array<std::size_t, 3> places = {element.place("x"), element.place("y"),
                                               element.place("z")};
    const std::size_t pinned = element.place("pinned");
    if(std::find(places.begin(), places.end(), none) != places.end())
      return refuse(Curve_defect_kind::MISSING_COORDINATES, "vertices have no x, y and z");
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!read_item(element, i)) return false;
      if(pinned != none && m_item[pinned] != "0") m_file.pinned.push_back(m_file.points.size());
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

  bool read_edges(const Element& element)
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
  Text_scanner m_words;
  Curve_draft m_file;
  std::vector<Element> m_elements;
  std::vector<std::string_view> m_item; // the words of a line
  std::size_t m_line = 0;               // its number
  std::vector<Edge> m_edges;
  std::size_t m_line_of_face = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_PLY_CURVE_READER_H
