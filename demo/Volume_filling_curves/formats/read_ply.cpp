// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Ply_items.h"
#include "formats/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

bool holds_vertices(const Ply_element& element)
{
  return element.name == "vertex" || element.name == "vertices";
}

bool holds_faces(const Ply_element& element)
{
  return element.name == "face" || element.name == "faces";
}

bool holds_strips(const Ply_element& element)
{
  return element.name == "tristrips";
}

// Rounds a number of a surface, or a value at its vertices, to its type, so that ASCII and binary
// files give the same bits. Curves keep all digits.
double rounded_to_type(double value, const Ply_property& property)
{
  const Ply_type* const type = property.type;
  const bool is_float = type != nullptr && type->kind == Ply_type::REAL && type->size == 4;
  return is_float ? static_cast<float>(value) : value;
}

// Reads the vertices, and either the edges or the faces, in whatever order they come; everything
// else is passed over.
class Ply_reader
{
public:
  // Reads a curve if `polygons` is null.
  Ply_reader(std::string_view text, Polygons* polygons)
      : m_items(text, m_draft.defects), m_polygons(polygons)
  {}

  Curve_draft run()
  {
    m_draft.is_complete = !m_draft.defects.has_error();
    for(const Ply_element& element : m_items.elements())
      if(holds_vertices(element)) m_number_of_vertices += element.count;
    for(const Ply_element& element : m_items.elements())
      m_draft.is_complete = m_draft.is_complete && read(element);
    const bool can_judge = m_draft.is_complete || m_line_of_face > 0; // a face: it is a surface
    if(can_judge && m_polygons == nullptr && !m_has_edges)
      m_draft.take_without_lines(m_line_of_face, m_items.next_line());
    return std::move(m_draft);
  }

private:
  bool read(const Ply_element& element)
  {
    if(holds_vertices(element)) return read_vertices(element);
    const bool has_faces = holds_faces(element) || holds_strips(element);
    if(m_polygons != nullptr && has_faces) return read_faces(element);
    if(m_polygons == nullptr && element.name == "edge") return read_edges(element);
    if(has_faces && element.count > 0)
      m_line_of_face = m_items.next_line() > 0 ? m_items.next_line() : element.line;
    return for_each(element, [] {});
  }

  // Returns whether all items are there.
  template <typename Function>
  bool for_each(const Ply_element& element, const Function& function)
  {
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!m_items.next(element)) return false;
      function();
    }
    return true;
  }

  bool read_vertices(const Ply_element& element)
  {
    const std::array<std::size_t, 3> xyz = {element.index("x"), element.index("y"),
                                            element.index("z")};
    const std::size_t pinned = element.index("pinned");
    if(std::find(xyz.begin(), xyz.end(), Ply_element::none) != xyz.end())
      return m_items.refuse(element, Kind::MISSING_COORDINATES,
                            "vertices have no numbers x, y and z");
    return for_each(element, [&] {
      if(pinned != Ply_element::none && is_set(pinned))
        m_draft.pinned.push_back(m_draft.points.size());
      add_vertex(element, xyz);
    });
  }

  bool is_set(std::size_t property)
  {
    const double value = m_items.value(property);
    if(std::isnan(value))
      m_items.complain(Kind::UNPARSABLE_NUMBER,
                       files::quoted(m_items.word(property)) + " is not a number for pinned");
    return value != 0;
  }

  void add_vertex(const Ply_element& element, const std::array<std::size_t, 3>& xyz)
  {
    Curve_draft::Point point;
    for(std::size_t k = 0; k < 3; ++k) {
      point[k] = m_items.value(xyz[k]);
      if(m_polygons != nullptr) point[k] = rounded_to_type(point[k], element.properties[xyz[k]]);
      double number = 0;
      if(std::isnan(point[k]) && !files::parse_number(m_items.word(xyz[k]), number))
        return m_draft.add_unreadable_point(
            {Kind::UNPARSABLE_NUMBER,
             files::quoted(m_items.word(xyz[k])) + " is not a number",
             m_items.line(),
             {Curve_draft::number(m_draft.points.size())}});
    }
    m_draft.add_point(point, m_items.line());
  }

  bool read_edges(const Ply_element& element)
  {
    const std::size_t v = element.index("vertex1"), w = element.index("vertex2");
    if(v == Ply_element::none || w == Ply_element::none)
      return m_items.refuse(element, Kind::BAD_INDEX, "edges have no vertex1 and vertex2");
    m_has_edges = element.count > 0;
    return for_each(element, [&] {
      m_corners.clear();
      add_corner(m_items.value(v));
      add_corner(m_items.value(w));
      if(m_corners.size() == 2) m_draft.add_edge(m_corners[0], m_corners[1], m_items.line());
    });
  }

  bool read_faces(const Ply_element& element)
  {
    std::size_t list = element.index("vertex_indices", true);
    if(list == Ply_element::none) list = element.index("vertex_index", true);
    if(list == Ply_element::none)
      return m_items.refuse(element, Kind::UNKNOWN_FORMAT, "faces have no list vertex_indices");
    const bool are_strips = holds_strips(element);
    return for_each(element, [&] {
      m_corners.clear();
      for(const double *v = m_items.begin(list), *end = m_items.end(list); v != end; ++v)
        if(are_strips && *v == end_of_strip)
          end_strip();
        else
          add_corner(*v);
      if(are_strips)
        end_strip();
      else
        m_polygons->push_back(m_corners);
    });
  }

  void end_strip()
  {
    add_strip(m_corners, *m_polygons);
    m_corners.clear();
  }

  void add_corner(double v)
  {
    if(v >= 0 && v < static_cast<double>(m_number_of_vertices) && v == std::floor(v))
      return m_corners.push_back(static_cast<std::size_t>(v));
    std::string text;
    files::append_number(text, v); // all digits, as of an index above a million
    m_items.complain(Kind::BAD_INDEX, "there is no vertex " + text + " (numbered from 0)");
  }

  static constexpr double end_of_strip = -1; // in a list of several strips

  Curve_draft m_draft; // before m_items, which report defects to it
  Ply_items m_items;
  Polygons* m_polygons;
  std::vector<std::size_t> m_corners; // of an edge, a polygon or a strip
  std::size_t m_number_of_vertices = 0, m_line_of_face = 0;
  bool m_has_edges = false;
};

} // namespace

Curve_draft read_ply(std::string_view text, Junctions)
{
  return Ply_reader(text, nullptr).run();
}

Curve_draft read_ply_surface(std::string_view text, Polygons& polygons)
{
  return Ply_reader(text, &polygons).run();
}

std::optional<std::vector<double>> read_ply_column(std::string_view text,
                                                   std::string_view property,
                                                   Defect_list& defects)
{
  std::optional<std::vector<double>> values;
  Ply_items items(text, defects);
  for(const Ply_element& element : items.elements()) {
    const std::size_t column =
        holds_vertices(element) ? element.index(property) : Ply_element::none;
    if(column != Ply_element::none && !values) values.emplace();
    for(std::size_t i = 0; i < element.count; ++i) {
      if(!items.next(element)) return values;
      if(column == Ply_element::none) continue;
      values->push_back(rounded_to_type(items.value(column), element.properties[column]));
      if(std::isnan(values->back()))
        defects.add(
            {Kind::UNPARSABLE_NUMBER,
             files::quoted(items.word(column)) + " is not a number for " + std::string(property),
             items.line(),
             {values->size()}});
    }
  }
  return values;
}

} // namespace vfc
