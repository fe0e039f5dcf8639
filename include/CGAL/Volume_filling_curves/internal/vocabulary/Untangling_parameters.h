// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The method of untangling.
enum class Untangling_strategy
{
  FLOW,   ///< the flow alone, a continuous motion of all nodes
  SEARCH, ///< a random search for a polygon with as few edges as possible
  AUTO    ///< the search first, and then the flow to an even, smooth shape
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "flow".
inline const char* to_string(Untangling_strategy strategy)
{
  switch(strategy) {
  case Untangling_strategy::FLOW:
    return "flow";
  case Untangling_strategy::SEARCH:
    return "search";
  case Untangling_strategy::AUTO:
    return "auto";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Untangling_strategy strategy)
{
  return out << to_string(strategy);
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/untangle.h
 *
 * \brief The parameters of `untangle()`.
 *
 * With `AUTO` the default thickness is measured on the resulting polygon of the search; if this is
 * a proved unknot, it is a fortieth of the polygon's length. With limits of the shape it is
 * measured on the input.
 *
 * One parameter of the flow has a different default: `preconditioner` is `Preconditioner::CONTACT`.
 * It unties hard unknots in 0.3 times the iterations of the paper's `Preconditioner::MEDIAL`, and
 * tightens tangled knots in 0.55 times (7 unknots and 236 knots).
 *
 * Each member, including those of the base classes, can be set by the named parameter of the same
 * name.
 */
struct Untangling_parameters : Curve_run_parameters
{
  Untangling_parameters() { preconditioner = Preconditioner::CONTACT; }

  /// The method of untangling. Open curves with pinned ends and curves with sliding nodes always
  /// flow.
  Untangling_strategy strategy = Untangling_strategy::AUTO;

  /// The number of independent chains of random moves in each search. The chain that succeeds with
  /// the fewest moves provides the result or, if none succeeds, the one with the fewest edges. Each
  /// runs in a thread of its own if the `ConcurrencyTag` allows it.
  std::size_t number_of_chains = 2;

  /// The tolerance for tight curves, dimensionless. A curve is tight if
  /// `Curve_flow_3::gradient_norm()` is less than the tolerance, and `Curve_flow_3::loose_share()`
  /// is less than 0.05 or twice the tolerance, whichever is more.
  double tolerance = 7e-3;

  /// Whether to stop once the curves are proved to be unknotted and unlinked and are short: 8
  /// thicknesses per component, or 50 iterations after the proof. If `false`, a single unknot ends
  /// as a regular polygon of that length with at least 64 nodes, and several unlinked unknots flow
  /// on until they are tight, as small loops.
  bool stop_at_proof = true;

  /// Whether to tighten the curves to a lower `ropelength()` once the flow has converged or
  /// stalled. In the median of 14 prime knots of 3 to 7 crossings, the flow alone ends 16 % above
  /// the least known ropelength, and this option 0.3 % above, in 1.9 times the time. Strands stay
  /// one thickness apart, the mean edge is at most 0.15 thicknesses long, and every certified
  /// motion counts as an iteration. The ropelength never ends higher, not even at a limit; the
  /// gradient of the flow, which weighs spheres, grows again. The option has no effect on proved
  /// unknots, on curves with ends, junctions or constrained nodes, inside a domain, and with the
  /// strategy `SEARCH`. See `Untangling_result::is_ropelength_lowered`.
  bool lower_ropelength = false;

  /// Whether to scale the result, and the returned thickness, to the length of the input, by
  /// certified steps, which end early if strands or the rounding of coordinates are in the way. Not
  /// possible with constrained nodes, hence not with open polylines.
  bool keep_length = false;

  /// The least radius with which the result may bend, in the input's unit: that of the arcs that
  /// round its corners, see `min_bend_radius()`. 0 (default) stands for none. Once the flow has
  /// ended, certified steps round the curve until the limits of its shape are kept; these steps
  /// count as iterations. The `thickness` is then at least `bend_radius` / 0.75, with which tight
  /// curves hardly bend more. Where a limit is not reached, the run ends as
  /// `Untangling_status::CONSTRAINT_NOT_REACHED`. Not with the strategy `SEARCH`.
  double bend_radius = 0;

  /// The least distance between strands, in the input's unit: of edges with at least half of a turn
  /// of curve between them, pi times `bend_radius`, or pi/2 times the distance if that is more. 0
  /// (default) stands for none; otherwise like `bend_radius`, with a `thickness` of at least this
  /// distance / 0.95.
  double strand_distance = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_PARAMETERS_H
