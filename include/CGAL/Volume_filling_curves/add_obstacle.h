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
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns the domain that a mesh bounds; refusals begin with its name.
template <typename TriangleMesh>
auto named_domain(const TriangleMesh& mesh, const std::string& name, bool check_shells)
{
  try {
    return Triangle_mesh_domain_3(mesh, parameters::check_mesh(check_shells));
  } catch(const std::invalid_argument& error) {
    throw std::invalid_argument(name + " bounds no domain: " + error.what());
  }
}

// Returns the mesh without vertices that have no faces: they bound nothing. The header of CGAL's
// remove_isolated_vertices() includes all repairs of meshes.
template <typename TriangleMesh>
TriangleMesh without_isolated_vertices(TriangleMesh mesh)
{
  using Graph = boost::graph_traits<TriangleMesh>;
  std::vector<typename Graph::vertex_descriptor> isolated;
  for(const auto v : vertices(mesh))
    if(halfedge(v, mesh) == Graph::null_halfedge()) isolated.push_back(v);
  for(const auto v : isolated) remove_vertex(v, mesh);
  return mesh;
}

// Returns whether any vertex of a mesh is inside a domain (or outside).
template <typename TriangleMesh, typename Domain>
bool has_vertex_on_side(const TriangleMesh& mesh, const Domain& domain, bool is_inside)
{
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
 * the other. Vertices without faces are ignored. Takes \cgalBigO{n \log n} time for `n` faces
 * unless many of them have intersecting bounding boxes.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph`, `HalfedgeListGraph` and
 * `CopyConstructible`, with an internal vertex point map, whose points are those of a kernel with
 * exact predicates
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
void add_obstacle(TriangleMesh& mesh, const TriangleMesh& obstacle)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto domain = internal::named_domain(mesh, "the mesh", true);
  internal::named_domain(obstacle, "the obstacle", false); // its shells are not yet oriented
  const TriangleMesh walls = internal::without_isolated_vertices(mesh);
  TriangleMesh shells = internal::without_isolated_vertices(obstacle);
  if(PMP::do_intersect(walls, shells))
    throw std::invalid_argument("the obstacle touches or crosses the mesh or another obstacle");
  PMP::orient_to_bound_a_volume(shells);
  const auto cavity = internal::named_domain(shells, "the obstacle", true);
  if(internal::has_vertex_on_side(shells, domain, false))
    throw std::invalid_argument(
        "the obstacle is not inside of the mesh, or within another obstacle");
  if(internal::has_vertex_on_side(walls, cavity, true))
    throw std::invalid_argument("the obstacle lies around another obstacle");
  if(PMP::is_outward_oriented(walls)) PMP::reverse_face_orientations(shells);
  CGAL::copy_face_graph(shells, mesh);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ADD_OBSTACLE_H
