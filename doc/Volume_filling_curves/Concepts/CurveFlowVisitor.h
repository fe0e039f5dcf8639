// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `CurveFlowVisitor` describes how the progress of
 * `CGAL::Volume_filling_curves::untangle()` and `CGAL::Volume_filling_curves::fill()` is followed,
 * and stopped. Derive from `CGAL::Volume_filling_curves::Default_curve_flow_visitor` to write those
 * functions only that matter.
 *
 * A run is a sequence of flows and searches. `fill()` and `Untangling_strategy::FLOW` are one flow,
 * `Untangling_strategy::SEARCH` is one search. With `Untangling_strategy::AUTO` a search is
 * followed by a flow, and if that flow jams, both take their turns again, up to four times. Of each
 * flow the functions are called in the order `on_start()`, `go_further()`, `on_iteration()`,
 * `go_further()`, `on_iteration()`, ...
 *
 * All functions are called by the thread that called `untangle()` or `fill()`, between steps, when
 * everything that `CGAL::Volume_filling_curves::Curve_flow_3` lets read belongs to the curve as it
 * stands. A visitor cannot change the curve. It may throw: the exception reaches the caller, and
 * the curve is the one after the last step, ambient isotopic to the input.
 *
 * A visitor that is passed by value is copied, so that what the run leaves in it is lost; a model
 * is copyable if it is to be passed so. Pass `std::ref()` of a visitor to keep its state.
 *
 * The curve that a visitor of `untangle()` sees has rays at pinned ends: pinned nodes whose
 * `CGAL::Volume_filling_curves::Curve_network_3::origin()` is null.
 * `CGAL::Volume_filling_curves::without_closing_rays()` gives the curve itself.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Volume_filling_curves::Default_curve_flow_visitor}
 * \cgalHasModelsEnd
 *
 * \sa `CGAL::Volume_filling_curves::Curve_flow_3`
 */
class CurveFlowVisitor
{
public:
  /// is called once per flow, before its first step, when the thickness is known and the edges have
  /// the lengths that the flow wants. Everything that `flow.statistics()` counts begins at 0 again,
  /// unless the run resumes in the middle of this flow.
  /// In `fill()` it is called once, with the thickness asked for, although the curve then grows
  /// with a coarser one first. `Flow` is an instance of
  /// `CGAL::Volume_filling_curves::Curve_flow_3`, or has the same functions for reading.
  template <typename Flow>
  void on_start(const Flow& flow);

  /// is called after each step.
  template <typename Flow>
  void on_iteration(const Flow& flow);

  /// is called before each step, unless the run ends for another reason. If it returns `false`, no
  /// further step is made and the status is `Untangling_status::INTERRUPTED` or
  /// `Filling_status::INTERRUPTED`.
  template <typename Flow>
  bool go_further(const Flow& flow);

  /// is called by `CGAL::Volume_filling_curves::fill()` before anything else if more than 1 % of
  /// the domain's volume is too thin for the thickness, so that the user can be warned: the curve
  /// does not get there, and the status will most likely be `Filling_status::PARTIAL`.
  void on_thin_domain(const CGAL::Volume_filling_curves::Thickness_fit& fit);

  /// is called every few milliseconds of a search, and not at all if that is shorter. If it returns
  /// `false`, the search ends, the curve becomes the polygon that it has found so far, and the
  /// status is `Untangling_status::INTERRUPTED`.
  bool on_search(const CGAL::Volume_filling_curves::Search_progress& progress);
};
