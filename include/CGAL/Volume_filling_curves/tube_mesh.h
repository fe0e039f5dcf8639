// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_TUBE_MESH_H
#define CGAL_VOLUME_FILLING_CURVES_TUBE_MESH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/drawing/Tube_builder.h>
#include <CGAL/Volume_filling_curves/internal/drawing/Tube_parameters.h>
#include <CGAL/Volume_filling_curves/internal/drawing/Tube_sections.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief makes a triangle mesh of the surface of the tube around a curve.
 *
 * Every component of the curve gets a closed surface of its own, oriented to the outside, which is
 * added to the mesh: a torus around a closed curve, a sphere around an open one, whose ends are
 * flat. At each node there is a regular polygon, in the plane that bisects the corner, whose
 * corners have the distance `radius` from the node; neighboring polygons are joined by triangles.
 * Polygons follow one another without a twist, but for what closes a closed curve, at most half of
 * a side, which is spread evenly. All of the tube is within its radius of the curve.
 *
 * The mesh does not intersect itself if the radius is less than `polygonal_thickness()` everywhere:
 * then no corner is too sharp for the radius, and no strand comes closer than two radii. With
 * larger radii it may.
 *
 * With `k` sides there are `k` vertices and `2k` triangles per node, and another vertex per open
 * end. Linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Radius a number, a function, or a model of `ReadablePropertyMap`
 * \tparam TriangleMesh a model of `MutableFaceGraph` whose points are constructed from three
 * `double` numbers
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curve the curve
 * \param radius the radius of the tube, in the input's unit; or a function `double(std::size_t)`,
 * or a property map, that gives the radius at each node
 * \param mesh receives the tube in addition to what it holds; it does not change if an exception is
 * thrown
 * \param np \vfcNamedParams{Tube_signature}
 *
 * \throws std::invalid_argument if the curve has a junction, if a radius is not positive and
 * finite, or if there are fewer than 3 sides
 *
 * \pre the network has no garbage
 * \pre the nodes of an edge are distinct
 */
template <typename Traits,
          typename Radius,
          typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void tube_mesh(const Curve_network_3<Traits>& curve,
               const Radius& radius,
               TriangleMesh& mesh,
               const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  const std::size_t number_of_sides = internal::tube_parameters(np).number_of_sides;
  internal::refuse_junctions(curve);
  const std::vector<double> radii = internal::radii_of_nodes(curve, radius);
  internal::Tube_builder builder(
      mesh, CGAL::parameters::choose_parameter(
                CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                CGAL::get_property_map(CGAL::vertex_point, mesh)));
  for(const std::size_t c : curve.components()) {
    std::vector<internal::Vector> nodes;
    std::vector<double> radii_of_component;
    for(const std::size_t v : curve.nodes(c)) {
      nodes.push_back(internal::to_vector(curve.point(v)));
      radii_of_component.push_back(radii[v]);
    }
    builder.add(internal::Tube_sections(nodes, curve.is_closed(c), number_of_sides),
                radii_of_component);
  }
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_TUBE_MESH_H
