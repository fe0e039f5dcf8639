// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_PLY_VERTEX_PROPERTY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_PLY_VERTEX_PROPERTY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Mesh_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Text_scanner.h>

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads one number per vertex from a PLY file: a text word by word, so that errors can name the line, a
// binary file through CGAL. Only float and double properties are accepted, as CGAL's reader has it.
class Ply_vertex_property
{
public:
  Ply_vertex_property(const std::string& text, const std::string& name)
      : m_text(text), m_name(name), m_scanner(text)
  {}

  // returns whether there is no error
  bool read(std::vector<double>& values, std::vector<Mesh_defect>& defects)
  {
    if(!read_header())
      defects.push_back({Mesh_defect_kind::UNREADABLE_FILE, "the file has no PLY header"});
    else if(m_place == none)
      defects.push_back({Mesh_defect_kind::MISSING_PROPERTY,
                         "the vertices have no property '" + m_name + "' of type float or double"});
    else if(m_is_text)
      read_text(values, defects);
    else
      read_binary(values, defects);
    return defects.empty();
  }

  // returns the line of a vertex, 0 in a binary file
  std::size_t line(std::size_t v) const { return v < m_lines.size() ? m_lines[v] : 0; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool read_header()
  {
    if(m_scanner.next_word() != "ply") return false;
    bool is_first_element = true, is_vertex = false;
    std::size_t place = 0;
    for(;;) {
      m_scanner.next_record();
      if(m_scanner.is_at_end()) return false;
      const std::string_view word = m_scanner.next_word();
      if(word == "end_header") return true;
      if(word == "format") m_is_text = m_scanner.next_word() == "ascii";
      if(word == "element") {
        const std::string_view element = m_scanner.next_word();
        is_vertex = element == "vertex" && is_first_element;
        is_first_element = false;
        if(is_vertex) parse_integer(m_scanner.next_word(), m_number_of_vertices);
      }
      if(word == "property" && is_vertex) read_property(place++);
    }
  }

  void read_property(std::size_t place)
  {
    const std::string_view type = m_scanner.next_word(), name = m_scanner.next_word();
    const bool is_real =
        type == "float" || type == "double" || type == "float32" || type == "float64";
    if(is_real && name == m_name) m_place = place;
  }

  void read_text(std::vector<double>& values, std::vector<Mesh_defect>& defects)
  {
    for(std::size_t v = 0; v < m_number_of_vertices; ++v) {
      m_scanner.next_record();
      if(m_scanner.is_at_end())
        return defects.push_back({Mesh_defect_kind::TRUNCATED_FILE,
                                  "the file ends after " + std::to_string(v) + " of " +
                                      std::to_string(m_number_of_vertices) + " vertices",
                                  m_scanner.line()});
      for(std::size_t k = 0; k < m_place; ++k) m_scanner.next_word();
      const std::string_view word = m_scanner.next_word();
      double value = 0;
      if(!parse_number(word, value))
        defects.push_back({Mesh_defect_kind::UNPARSABLE_NUMBER,
                           quoted(word) + " is no number",
                           m_scanner.line(),
                           {v + 1}});
      values.push_back(value);
      m_lines.push_back(m_scanner.line());
    }
  }

  void read_binary(std::vector<double>& values, std::vector<Mesh_defect>& defects) const
  {
    std::istringstream stream(m_text, std::ios::in | std::ios::binary);
    auto property = std::make_pair(CGAL::Identity_property_map<double>(),
                                   CGAL::IO::PLY_property<double>(m_name.c_str()));
    if(!CGAL::IO::read_PLY_with_properties<double>(stream, std::back_inserter(values),
                                                   std::move(property)))
      defects.push_back({Mesh_defect_kind::TRUNCATED_FILE, "this is no complete PLY file"});
  }

  const std::string& m_text;
  std::string m_name;
  Text_scanner m_scanner;
  bool m_is_text = false;
  std::size_t m_number_of_vertices = 0, m_place = none; // among the properties of a vertex
  std::vector<std::size_t> m_lines;                     // of the values
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_PLY_VERTEX_PROPERTY_H
