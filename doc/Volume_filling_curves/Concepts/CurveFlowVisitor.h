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
 * `CGAL::Volume_filling_curves::untangle()` is followed, and stopped.
 *
 * Its functions are called by the thread that called `untangle()`, between steps, when everything that
 * `CGAL::Volume_filling_curves::Curve_flow_3` lets read belongs to the curve as it stands. A visitor
 * cannot change the curve. It may throw: the exception reaches the caller of `untangle()`, and the
 * curve is the one after the last step, ambient isotopic to the input.
 *
 * The curve that a visitor sees has tails at pinned ends: pinned nodes whose
 * `CGAL::Volume_filling_curves::Curve_network_3::origin()` is null.
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
  /// is called once, before the first step, when the thickness is known and the edges have the lengths
  /// that the flow wants. `Flow` is an instance of `CGAL::Volume_filling_curves::Curve_flow_3`.
  template <typename Flow>
  void on_start(const Flow& flow);

  /// is called after each step.
  template <typename Flow>
  void on_iteration(const Flow& flow);

  /// is called before each step, unless the run ends for another reason. If it returns `false`, no
  /// further step is made and the status is `Untangling_status::INTERRUPTED`.
  template <typename Flow>
  bool go_further(const Flow& flow);
};
