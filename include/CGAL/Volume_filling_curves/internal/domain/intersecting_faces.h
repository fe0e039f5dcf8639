// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INTERSECTING_FACES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INTERSECTING_FACES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/enum.h>
#include <CGAL/intersections.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for faces of a mesh that meet elsewhere than in a common vertex or edge, by CGAL's search
// for intersecting boxes and exact predicates. O(n log^2 n) unless many boxes intersect: 23 ms for
// 20,000 faces.

template <typename Mesh>
using Face_pair = std::pair<typename Mesh::Face_index, typename Mesh::Face_index>;

template <typename Mesh>
std::array<typename Mesh::Vertex_index, 3> corners_of(const Mesh& mesh, typename Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

// Returns whether two faces meet only in a corner or an edge at the same position. Where a surface
// touches itself, such corners are different vertices, and CGAL's search takes the faces for
// intersecting. \pre no vertex is shared
template <typename Mesh>
bool do_only_touch(const Mesh& mesh, const Face_pair<Mesh>& pair)
{
  using Point = typename Mesh::Point;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Segment = typename Kernel::Segment_3;
  using Triangle = typename Kernel::Triangle_3;
  const auto points_of = [&](typename Mesh::Face_index f) {
    const auto [u, v, w] = corners_of(mesh, f);
    return std::array<Point, 3>{mesh.point(u), mesh.point(v), mesh.point(w)};
  };
  auto first = points_of(pair.first), second = points_of(pair.second);
  const auto move_common_to_front = [](auto& points, const auto& others) {
    const auto is_common = [&](const Point& p) {
      return std::find(others.begin(), others.end(), p) != others.end();
    };
    return std::partition(points.begin(), points.end(), is_common) - points.begin();
  };
  move_common_to_front(first, second);
  const auto number_of_common = move_common_to_front(second, first);
  const auto& [a, b, c] = first;
  const auto& [d, e, f] = second;
  switch(number_of_common) {
  case 1:
    return !do_intersect(Segment(b, c), Triangle(d, e, f)) &&
           !do_intersect(Segment(e, f), Triangle(a, b, c));
  case 2:
    return !coplanar(a, b, c, f) || coplanar_orientation(a, b, c, f) != POSITIVE;
  default:
    return false;
  }
}

template <typename Mesh>
bool share_a_vertex(const Mesh& mesh, const Face_pair<Mesh>& pair)
{
  const auto first = corners_of(mesh, pair.first), second = corners_of(mesh, pair.second);
  return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) !=
         first.end();
}

// The points of a mesh, as a property map by which CGAL's search ends when a run is to stop.
template <typename Mesh>
class Points_in_run
{
public:
  using key_type = typename Mesh::Vertex_index;
  using value_type = typename Mesh::Point;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;

  explicit Points_in_run(const Mesh& mesh) : m_mesh(&mesh) {}

  friend reference get(const Points_in_run& map, key_type v)
  {
    static thread_local unsigned accesses = 0; // reading the clock takes as long as some
    if(++accesses % 64 == 0) check_run();
    return map.m_mesh->point(v);
  }

private:
  const Mesh* m_mesh;
};

// there can be quadratically many pairs
constexpr std::size_t max_pairs_of_faces = 1000000;

struct Enough_pairs_of_faces
{};

// Returns the pairs, in order, up to a million of them. Vertices at the same place are the same
// one. \pre no face is degenerate \param points a property map, which may throw to end the search
template <typename Mesh, typename Points>
std::vector<Face_pair<Mesh>> intersecting_faces(const Mesh& mesh, const Points& points)
{
  std::vector<Face_pair<Mesh>> pairs;
  const auto add = [&](const Face_pair<Mesh>& pair) {
    if(!share_a_vertex(mesh, pair) && do_only_touch(mesh, pair)) return;
    pairs.push_back(std::minmax(pair.first, pair.second));
    if(pairs.size() == max_pairs_of_faces) throw Enough_pairs_of_faces();
  };
  try {
    CGAL::Polygon_mesh_processing::self_intersections(mesh,
                                                      boost::make_function_output_iterator(add),
                                                      CGAL::parameters::vertex_point_map(points));
  } catch(const Enough_pairs_of_faces&) {
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <typename Mesh>
Mesh_fault intersection_fault(const Mesh& mesh, const Face_pair<Mesh>& pair)
{
  const auto [u, v, w] = corners_of(mesh, pair.first);
  return {"self-intersection",
          "two faces intersect" +
              near_text((std::min)({mesh.point(u), mesh.point(v), mesh.point(w)}))};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INTERSECTING_FACES_H
