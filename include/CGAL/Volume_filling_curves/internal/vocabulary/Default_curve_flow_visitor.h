// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_DEFAULT_CURVE_FLOW_VISITOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_DEFAULT_CURVE_FLOW_VISITOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesTraits
/// \headerfile CGAL/Volume_filling_curves/Curve_flow_3.h
///
/// A visitor that does nothing; a base class for other visitors.
///
/// \cgalModels{CurveFlowVisitor}
struct Default_curve_flow_visitor
{
  /// is called before the first step of each flow, with a `Curve_flow_3`.
  template <typename Flow>
  void on_start(const Flow&)
  {}

  /// is called after each step.
  template <typename Flow>
  void on_iteration(const Flow&)
  {}

  /// is called before each step. If it returns `false`, the run ends with a valid curve.
  template <typename Flow>
  bool go_further(const Flow&)
  {
    return true;
  }

  /// is called by `fill()` before the start if more than 1 % of the domain is too thin for the
  /// thickness.
  void on_thin_domain(const Thickness_fit&) {}

  /// is called every few milliseconds of a search. If it returns `false`, the run ends with a valid
  /// curve.
  bool on_search(const Search_progress&) { return true; }
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_DEFAULT_CURVE_FLOW_VISITOR_H
