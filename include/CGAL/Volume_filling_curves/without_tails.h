// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_WITHOUT_TAILS_H
#define CGAL_VOLUME_FILLING_CURVES_WITHOUT_TAILS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/untangling/tail_nodes.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns a copy of the curve that a visitor of `untangle()` sees, without the tails that it
 * has at pinned ends while it flows (see `CurveFlowVisitor`); a plain copy if there are none.
 *
 * Linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 *
 * \pre the network has no garbage
 */
template <typename Traits>
[[nodiscard]] Curve_network_3<Traits> without_tails(const Curve_network_3<Traits>& curve)
{
  CGAL_precondition_msg(!curve.has_garbage(), "the network has no garbage");
  Curve_network_3<Traits> copy(curve);
  internal::Network_editor<Curve_network_3<Traits>> editor(copy);
  internal::remove_tails(copy, editor);
  return copy;
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_WITHOUT_TAILS_H
