// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_CURVE_ORIGINS_H
#define CGAL_VOLUME_FILLING_CURVES_CURVE_ORIGINS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Curve_origin.h>
#include <CGAL/Volume_filling_curves/internal/curve/Origin_interpolation.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns where in the input the nodes of a network come from, whatever has been done to it
 * since: for each node an edge of the input and a place on it.
 *
 * A node of the input that is still there comes from where it was. The origins of the nodes between
 * two of these are spread between theirs, in proportion to the length of the curve as it is, each
 * edge of the input counting the same. So origins never run backwards along a component, and run
 * once around a closed one; if none of its nodes is left, its first node comes from the first of
 * the input. In a component with junctions this holds for each chain from one junction or end to
 * the next, and junctions and ends come from themselves. Nodes that a visitor sees beyond the ends
 * of an arc come from nowhere: both indices are `Curve_network_3::null_node()`.
 *
 * The input is what the network was constructed from. Takes time linear in the number of nodes of
 * the network and of its input.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
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

#endif // CGAL_VOLUME_FILLING_CURVES_CURVE_ORIGINS_H
