// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

/*!
 * \ingroup PkgVolumeFillingCurvesConcepts
 * \cgalConcept
 *
 * The concept `CurveFlowVisitor` describes visitors that follow the progress of
 * `CGAL::Volume_filling_curves::untangle()` and `CGAL::Volume_filling_curves::fill()`, and can stop
 * them. A class derived from `CGAL::Volume_filling_curves::Default_curve_flow_visitor` need only
 * define the functions that it uses.
 *
 * A run is a sequence of flows and searches. `fill()` consists of one flow,
 * `Untangling_strategy::SEARCH` of one search. `Untangling_strategy::FLOW` consists of one flow if
 * a thickness is given; a measured one that proves too small is followed by a flow with a larger
 * one. With `Untangling_strategy::AUTO` a flow follows a search; if the flow jams, both are
 * repeated, with at most four searches in all. During each flow the functions are called in the
 * order `on_start()`, `go_further()`, `on_iteration()`, `go_further()`, `on_iteration()`, ...
 *
 * All functions are called between steps, in the thread that called `untangle()` or `fill()`; the
 * reading functions of `CGAL::Volume_filling_curves::Curve_flow_3` then describe the current curve.
 * A visitor cannot change the curve. It may throw: the exception reaches the caller, and the curve
 * is the one after the last step, ambient isotopic to the input, or the input itself if the
 * exception is an `std::invalid_argument`.
 *
 * A visitor passed by value must be copyable, and changes of the copy are lost. Pass `std::ref()`
 * of a visitor to keep its state.
 *
 * The curve that a visitor of `untangle()` sees has closing rays at pinned ends: pinned nodes whose
 * `CGAL::Volume_filling_curves::Curve_network_3::origin()` is null.
 * `CGAL::Volume_filling_curves::without_closing_rays()` returns the curve without them.
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
  /// is called once per flow, before its first step, when the thickness is known and the curve is
  /// remeshed. `flow.statistics()` starts from 0, unless the run resumes in the middle of this
  /// flow. `fill()` calls it with the required thickness; some stages use another one: multiples of
  /// it with `Filling_start::CIRCLE`, and fractions of it while bends are rounded. `Flow` is an
  /// instance of `CGAL::Volume_filling_curves::Curve_flow_3`, or has the same reading functions.
  template <typename Flow>
  void on_start(const Flow& flow);

  /// is called after each step.
  template <typename Flow>
  void on_iteration(const Flow& flow);

  /// is called before each step, unless the run ends for another reason. If it returns `false`, the
  /// run ends and the status is `Untangling_status::INTERRUPTED` or `Filling_status::INTERRUPTED`.
  template <typename Flow>
  bool go_further(const Flow& flow);

  /// is called first by `CGAL::Volume_filling_curves::fill()` if more than 1 % of the domain's
  /// volume is too thin for the thickness, as a warning: the curve will not reach these regions,
  /// and the status will most likely be `Filling_status::CONSTRAINT_NOT_REACHED` or
  /// `Filling_status::PARTIAL`.
  void on_thin_domain(const CGAL::Volume_filling_curves::Thickness_fit& fit);

  /// is called every few milliseconds during a search. If it returns `false`, the search ends, the
  /// curve becomes the best polygon found so far unless that would take more than 5 seconds, and
  /// the status is `Untangling_status::INTERRUPTED`.
  bool on_search(const CGAL::Volume_filling_curves::Search_progress& progress);
};
