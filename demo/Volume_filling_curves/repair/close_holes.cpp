// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/examine_mesh.h"
#include "meshes/mesh_size.h"
#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/domain/mesh_holes.h>

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::Volume_filling_curves::internal::holes_of;

using Polygon = std::vector<std::size_t>; // of points of a soup

constexpr std::size_t max_edges = 2000;       // of a hole that is closed at all
constexpr std::size_t max_for_all_ways = 250; // among which to choose takes cubic time

// Asks the watch at each step of a search.
struct Watching_search : PMP::Hole_filling::Default_visitor
{
  explicit Watching_search(Work_watch& watch) : m_watch(&watch) {}

  void quadratic_step() const { m_watch->check(); }
  void cubic_step() const { m_watch->check(); }

private:
  Work_watch* m_watch;
};

// Takes the border of holes that touch in points apart into the borders of each of them: as soon as
// it comes back to a point, it has gone around one.
std::vector<Polygon> without_repeated_points(const Polygon& border, const Mesh_soup& soup)
{
  std::vector<Polygon> polygons;
  Polygon path;
  std::map<Mesh_soup::Point, std::size_t> position; // in the path
  for(const std::size_t v : border) {
    const auto [found, is_new] = position.insert({soup.points[v], path.size()});
    if(!is_new) {
      const auto first = path.begin() + static_cast<std::ptrdiff_t>(found->second);
      polygons.emplace_back(first, path.end());
      for(auto w = first + 1; w != path.end(); ++w) position.erase(soup.points[*w]);
      path.erase(first + 1, path.end());
    } else
      path.push_back(v);
  }
  polygons.push_back(path);
  return polygons;
}

// Adds triangles to the soup that close a hole, and returns whether there are any.
bool close(const Polygon& hole, Mesh_soup& soup, Work_watch& watch)
{
  if(hole.size() < 3 || hole.size() > max_edges) return false;
  std::vector<Mesh_soup::Point> points;
  for(const std::size_t v : hole) points.push_back(soup.points[v]);
  std::vector<CGAL::Triple<int, int, int>> patch;
  const Watching_search search(watch);
  PMP::triangulate_hole_polyline(
      points, std::back_inserter(patch),
      CGAL::parameters::visitor(search).do_not_use_cubic_algorithm(hole.size() > max_for_all_ways));
  const auto vertex = [&](int i) { return hole[static_cast<std::size_t>(i)]; };
  for(const auto& [i, j, k] : patch) soup.faces.push_back({vertex(i), vertex(j), vertex(k)});
  return !patch.empty();
}

double width_of(const Polygon& hole, const Mesh_soup& soup)
{
  CGAL::Bbox_3 box;
  for(const std::size_t v : hole) box += soup.points[v].bbox();
  return width(box);
}

} // namespace

std::string close_holes(Mesh& mesh, Work_watch& watch)
{
  Mesh_soup soup = soup_of(mesh);
  std::size_t closed = 0;
  double width_of_closed = 0;
  for(const auto& border : holes_of(mesh))
    for(const Polygon& hole :
        without_repeated_points(Polygon(border.vertices.begin(), border.vertices.end()), soup)) {
      if(!close(hole, soup, watch)) continue;
      ++closed;
      width_of_closed = (std::max)(width_of_closed, width_of(hole, soup));
    }
  if(closed == 0) return "";
  assemble_faces(soup, mesh, watch);
  return counted(closed, "hole") + " closed, " + (closed == 1 ? "" : "the widest ") + "of width " +
         to_text(width_of_closed);
}

} // namespace vfc
