// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_strategy.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/untangle.h
 *
 * \brief The parameters of `untangle()`.
 *
 * With `AUTO` the default thickness is measured at the polygon that the search ends with; if that
 * is a proved unknot, it is a fortieth of its length.
 *
 * Of the flow's parameters one has another default here: `preconditioner` is
 * `Preconditioner::CONTACT`. Hard unknots are untied in 0.3 of the iterations that the paper's,
 * `Preconditioner::MEDIAL`, takes, and tangled knots settle in 0.55 of them (7 unknots and 236
 * knots).
 *
 * Each member, those of the base classes included, can be set by the named parameter of the same
 * name.
 */
struct Untangling_parameters : Curve_run_parameters
{
  Untangling_parameters() { preconditioner = Preconditioner::CONTACT; }

  /// How the curves are untangled. Open curves with pinned ends flow, whatever the strategy.
  Untangling_strategy strategy = Untangling_strategy::AUTO;

  /// The number of independent searches, of which the first that succeeds, in number of moves, is
  /// taken. They run on threads of their own if the `ConcurrencyTag` allows.
  std::size_t number_of_chains = 2;

  /// The curve is tight if `Curve_flow_3::gradient_norm()`, which is dimensionless, is less, and
  /// `Curve_flow_3::loose_share()` is less than 0.05, or than twice the tolerance if that is more.
  double tolerance = 7e-3;

  /// Whether to stop once the curves are proved to be unknots and unlinked and are short, 8
  /// thicknesses per component, which is at most 50 iterations later. Otherwise a single curve ends
  /// as a regular polygon of that length, of 64 nodes or more, and several flow on until they are
  /// tight, as small loops.
  bool stop_at_proof = true;

  /// Whether curves are pulled tighter where the flow has converged or stalled, to a lower
  /// `ropelength()`. The flow ends 16 % above the least that is known, in the median of 14 prime
  /// knots of 3 to 7 crossings, and this 0.3 %, in 1.7 times the time. Strands stay
  /// one thickness apart, edges get at most 0.15 thicknesses long in the mean, and every certified
  /// motion counts as an iteration. The ropelength is not higher in the end, not even at a limit;
  /// the gradient of the flow, which weighs spheres instead, grows again. Of unknots that are
  /// proved, of curves with ends, junctions or pinned nodes, in a domain, and with the strategy
  /// `SEARCH` nothing is lowered. See `Untangling_result::is_ropelength_lowered`.
  bool lower_ropelength = false;

  /// Whether to scale the result, by certified steps, to the length of the input. The thickness
  /// that is returned is scaled likewise. Not with pinned nodes, hence not with open polylines.
  bool keep_length = false;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H
