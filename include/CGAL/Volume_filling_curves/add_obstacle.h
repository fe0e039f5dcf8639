// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_ADD_OBSTACLE_H
#define CGAL_VOLUME_FILLING_CURVES_ADD_OBSTACLE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns whether any vertex of a mesh is inside another one (or outside).
template <typename TriangleMesh>
bool has_vertex_on_side(const TriangleMesh& mesh, const TriangleMesh& other, bool is_inside)
{
  const Triangle_mesh_domain_3 domain(other);
  const auto point = get(CGAL::vertex_point, mesh);
  for(const auto v : vertices(mesh))
    if(domain.is_inside(get(point, v)) == is_inside) return true;
  return false;
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief adds an obstacle to a mesh that bounds a domain: a shell around a cavity.
 *
 * The faces of the obstacle are appended to the mesh with the opposite orientation, as a cavity
 * requires; the vertices and faces of the mesh keep their numbers. The mesh can then be passed to
 * `Triangle_mesh_domain_3`, `fill()` and `verify_certificate()`. Add several obstacles one after
 * the other. Takes \cgalBigO{n \log n} time for `n` faces unless many of them have intersecting
 * bounding boxes.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph` and `HalfedgeListGraph` with an internal
 * vertex point map
 *
 * \param mesh the mesh, closed and without self-intersections; its outermost shells have the same
 * orientation
 * \param obstacle the obstacle, closed and without self-intersections, with any orientation
 *
 * \throws std::invalid_argument if either bounds no domain, see `Triangle_mesh_domain_3`; if the
 * obstacle touches or crosses the mesh; or if it does not lie strictly inside the mesh and outside
 * all earlier obstacles. The mesh is unchanged in that case
 */
template <typename TriangleMesh>
void add_obstacle(TriangleMesh& mesh, TriangleMesh obstacle)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(faces(obstacle).empty() || !CGAL::is_closed(obstacle) || !CGAL::is_triangle_mesh(obstacle))
    throw std::invalid_argument("an obstacle must be a closed triangle mesh");
  if(!CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::invalid_argument("the mesh must be a closed triangle mesh");
  if(PMP::do_intersect(mesh, obstacle))
    throw std::invalid_argument("the obstacle touches or crosses the mesh or another obstacle");
  PMP::orient_to_bound_a_volume(obstacle);
  if(internal::has_vertex_on_side(obstacle, mesh, false))
    throw std::invalid_argument(
        "the obstacle is not inside of the mesh, or within another obstacle");
  if(internal::has_vertex_on_side(mesh, obstacle, true))
    throw std::invalid_argument("the obstacle lies around another obstacle");
  if(PMP::is_outward_oriented(mesh)) PMP::reverse_face_orientations(obstacle);
  CGAL::copy_face_graph(obstacle, mesh);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ADD_OBSTACLE_H
