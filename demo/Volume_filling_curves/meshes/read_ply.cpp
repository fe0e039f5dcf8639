// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/read_ply.h"

#include "meshes/Ply_items.h"
#include "meshes/triangle_strips.h"
#include "options/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vfc {
namespace {

using Element = Ply_items::Element;

bool is_vertex(const Element& element)
{
  return element.name == "vertex" || element.name == "vertices";
}

bool is_face(const Element& element)
{
  return element.name == "face" || element.name == "faces";
}

bool is_strips(const Element& element)
{
  return element.name == "tristrips";
}

// the place of a property that is a number
std::size_t place_of_number(const Element& element, std::string_view property)
{
  const std::size_t place = element.place(property);
  return place != Element::none && element.properties[place].is_list ? Element::none : place;
}

class Ply_surface_reader
{
public:
  Ply_surface_reader(std::string_view text,
                     std::vector<Kernel::Point_3>& points,
                     std::vector<std::vector<std::size_t>>& polygons,
                     Mesh_findings& findings)
      : m_findings(findings), m_items(text, findings), m_points(points), m_polygons(polygons)
  {}

  void read()
  {
    const auto& elements = m_items.elements();
    require_single(is_vertex);
    require_single(is_face);
    require_single(is_strips);
    for(const Element& element : elements)
      if(is_vertex(element)) m_number_of_vertices = element.count;
    for(const Element& element : elements) {
      if(m_findings.has_error()) return;
      if(is_vertex(element))
        read_vertices(element);
      else if(is_face(element))
        read_faces(element, false);
      else if(is_strips(element))
        read_faces(element, true);
      else
        for(std::size_t i = 0; i < element.count && m_items.next(element); ++i) continue;
    }
  }

private:
  template <typename Is>
  void require_single(Is is)
  {
    std::size_t number = 0;
    for(const Element& element : m_items.elements())
      if(is(element) && ++number == 2)
        return m_items.refuse(element, "unknown format",
                              "element " + std::string(element.name) + " comes twice");
  }

  void read_vertices(const Element& element)
  {
    const std::array<std::size_t, 3> xyz = {place_of_number(element, "x"),
                                            place_of_number(element, "y"),
                                            place_of_number(element, "z")};
    if(std::find(xyz.begin(), xyz.end(), Element::none) != xyz.end())
      return m_items.refuse(element, "missing coordinates", "vertices have no numbers x, y and z");
    for(std::size_t i = 0; i < element.count && m_items.next(element); ++i) {
      std::array<double, 3> p;
      for(std::size_t k = 0; k < 3; ++k) p[k] = *m_items.begin(xyz[k]);
      m_points.emplace_back(p[0], p[1], p[2]);
      if(!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        m_findings.add_error("non-finite coordinate", "a coordinate is not a finite number",
                             {m_items.line(), {i + 1}});
    }
  }

  void read_faces(const Element& element, bool are_strips)
  {
    std::size_t list = element.place("vertex_indices");
    if(list == Element::none) list = element.place("vertex_index");
    if(list == Element::none || !element.properties[list].is_list)
      return m_items.refuse(element, "unknown format", "faces have no list vertex_indices");
    for(std::size_t i = 0; i < element.count && m_items.next(element); ++i) {
      m_corners.clear();
      for(const double *v = m_items.begin(list), *end = m_items.end(list); v != end; ++v)
        if(are_strips && *v == end_of_strip)
          end_strip();
        else
          add_corner(*v);
      if(are_strips)
        end_strip();
      else
        m_polygons.push_back(m_corners);
    }
  }

  void end_strip()
  {
    add_strip(m_corners, m_polygons);
    m_corners.clear();
  }

  void add_corner(double v)
  {
    if(v >= 0 && v < static_cast<double>(m_number_of_vertices) && v == std::floor(v))
      m_corners.push_back(static_cast<std::size_t>(v));
    else
      m_findings.add_error("bad index", "there is no vertex " + to_text(v) + " (they count from 0)",
                           {m_items.line(), {}, {m_polygons.size() + 1}});
  }

  static constexpr double end_of_strip = -1; // in a list of several

  Mesh_findings& m_findings;
  Ply_items m_items;
  std::vector<Kernel::Point_3>& m_points;
  std::vector<std::vector<std::size_t>>& m_polygons;
  std::vector<std::size_t> m_corners; // of a polygon or strip
  std::size_t m_number_of_vertices = 0;
};

} // namespace

void read_ply_surface(std::string_view text,
                      std::vector<Kernel::Point_3>& points,
                      std::vector<std::vector<std::size_t>>& polygons,
                      Mesh_findings& findings)
{
  Ply_surface_reader(text, points, polygons, findings).read();
}

std::vector<double> read_ply_column(std::string_view text,
                                    const std::string& property,
                                    Mesh_findings& findings)
{
  std::vector<double> values;
  Ply_items items(text, findings);
  bool has_property = false;
  for(const Element& element : items.elements()) {
    const std::size_t place =
        is_vertex(element) ? place_of_number(element, property) : Element::none;
    has_property = has_property || place != Element::none;
    for(std::size_t i = 0; i < element.count && items.next(element); ++i)
      if(place != Element::none) {
        values.push_back(*items.begin(place));
        if(std::isnan(values.back()))
          findings.add_error("unparsable number", "a value is not a number",
                             {items.line(), {i + 1}});
      }
  }
  if(!has_property && !findings.has_error())
    findings.add_error("missing property",
                       "the vertices have no property '" + property + "' that is a number");
  return values;
}

} // namespace vfc
