// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Origin_interpolation.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns whether a curve is embedded: no edge has length zero, and two edges meet at most
 * in a common node. `untangle()`, `fill()`, `simplify_curves()` and `Isotopy_guard_3` require this.
 *
 * The decision is exact. `IO::read_embedded_curve_network()` lists the edges of a file that meet.
 * Takes \cgalBigO{n \log^2 n} time for `n` nodes unless many edges have intersecting bounding
 * boxes.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] bool is_embedded(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  return internal::first_contact(curve).empty();
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief writes the curves of a network to an output iterator, as polylines.
 *
 * Every component without junctions becomes one polyline, whose last point repeats the first if the
 * component is closed. Components with junctions are cut at these. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam OutputIterator a model of `OutputIterator` that accepts
 * `std::vector<Traits::Point_3>`
 *
 * \param network the network
 * \param polylines receives the polylines
 *
 * \returns the output iterator past the last polyline
 *
 * \pre the network has no garbage
 */
template <typename Traits, typename OutputIterator>
OutputIterator curve_network_to_polylines(const Curve_network_3<Traits>& network,
                                          OutputIterator polylines)
{
  for(const auto& path : internal::Curve_paths(network).paths) {
    std::vector<typename Traits::Point_3> polyline;
    polyline.reserve(path.size());
    for(const std::size_t v : path) polyline.push_back(network.point(v));
    *polylines++ = std::move(polyline);
  }
  return polylines;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns the positions of the nodes as a matrix with one row x, y, z per node, the form
 * that libigl and polyscope use for curves. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param network the network
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> point_matrix(
    const Curve_network_3<Traits>& network)
{
  CGAL_precondition_msg(!network.has_garbage(), "the network has no garbage");
  return internal::coordinates(network);
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns the edges as a matrix with one row per edge: the indices of two rows of
 * `point_matrix()`. Takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param network the network
 *
 * \pre the network has no garbage, and fewer than \f$2^{31}\f$ nodes
 */
template <typename Traits>
[[nodiscard]] Eigen::Matrix<int, Eigen::Dynamic, 2> edge_matrix(
    const Curve_network_3<Traits>& network)
{
  CGAL_precondition_msg(!network.has_garbage(), "the network has no garbage");
  Eigen::Matrix<int, Eigen::Dynamic, 2> edges(static_cast<Eigen::Index>(network.number_of_edges()),
                                              2);
  for(const std::size_t e : network.edges())
    edges.row(static_cast<Eigen::Index>(e)) << static_cast<int>(network.source(e)),
        static_cast<int>(network.target(e));
  return edges;
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns for each node of a network the point of the input that it corresponds to: an edge
 * of the input and a position on it. Any changes since then are taken into account.
 *
 * A remaining node of the input corresponds to itself. Between two such nodes, the origins of the
 * nodes are interpolated in proportion to the present length of the curve, with the same share for
 * each edge of the input. Hence origins never run backwards along a component, and run once around
 * a closed one; if none of its nodes remains, its first node corresponds to the first node of the
 * input. In a component with junctions this holds for each chain between junctions or ends, which
 * correspond to themselves. Nodes of the closing rays that a visitor sees beyond the ends of an arc
 * have no origin: both indices are `Curve_network_3::null_node()`.
 *
 * The input is the data that the network was constructed from. Takes time linear in the number of
 * nodes of the network and of its input.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param network the network
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] std::vector<Curve_origin> curve_origins(const Curve_network_3<Traits>& network)
{
  CGAL_precondition_msg(!network.has_garbage(), "the network has no garbage");
  return internal::Origin_interpolation<Curve_network_3<Traits>>(network).origins();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_NETWORK_3_H
