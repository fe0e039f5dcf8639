// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IS_EMBEDDED_H
#define CGAL_VOLUME_FILLING_CURVES_IS_EMBEDDED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/check_embedded.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns whether a curve is embedded, as `untangle()`, `fill()`, `simplify_curves()` and
 * `Isotopy_guard_3` need it: whether no edge has length zero, and any two edges meet at most in a
 * common node.
 *
 * Decided with exact predicates. `IO::read_embedded_curve_network()` lists where the edges of a
 * file meet. Takes \cgalBigO{n \log^2 n} time for `n` nodes unless many edges have intersecting
 * bounding boxes.
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

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IS_EMBEDDED_H
