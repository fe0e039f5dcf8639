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
 * \brief constructs a triangle mesh of the surface of the tube around a curve.
 *
 * Every component of the curve adds a closed surface to the mesh, oriented outward: a torus around
 * a closed curve, a sphere with flat ends around an open one. At each node a regular polygon lies
 * in the plane that bisects the corner, with its corners at distance `radius` from the node;
 * triangles join neighboring polygons. Successive polygons are not twisted, except for the twist
 * that closes a closed curve, which is at most half a side and is distributed evenly. The whole
 * tube lies within its radius of the curve.
 *
 * If the radius is less than `polygonal_thickness()` everywhere, the mesh does not intersect
 * itself: no corner is too sharp for the radius, and no two strands are closer than two radii. With
 * larger radii it may.
 *
 * With `k` sides the mesh has `k` vertices and `2k` triangles per node, and one more vertex per
 * open end. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Radius a number, a function, or a model of `ReadablePropertyMap`
 * \tparam TriangleMesh a model of `MutableFaceGraph` whose points are constructed from three
 * `double` numbers
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curve the curve
 * \param radius the radius of the tube, in the input's unit; or a function `double(std::size_t)`,
 * or a property map, for the radius at each node
 * \param mesh the mesh to which the tube is added; it is unchanged if an exception is thrown
 * \param np \vfcNamedParams{Tube_signature}
 *
 * \throws std::invalid_argument if the curve has a junction, if a radius is not positive and
 * finite, or so small that it is lost in the rounding of the coordinates, or if there are fewer
 * than 3 sides
 *
 * \pre the network has no garbage
 * \pre no edge has length zero
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
