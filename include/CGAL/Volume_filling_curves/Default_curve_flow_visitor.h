// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_DEFAULT_CURVE_FLOW_VISITOR_H
#define CGAL_VOLUME_FILLING_CURVES_DEFAULT_CURVE_FLOW_VISITOR_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesTraits
///
/// A visitor that does nothing, to derive from.
///
/// \cgalModels{CurveFlowVisitor}
struct Default_curve_flow_visitor
{
  /// is called before the first step, with a `Curve_flow_3`.
  template <typename Flow>
  void on_start(const Flow&)
  {}

  /// is called after each step.
  template <typename Flow>
  void on_iteration(const Flow&)
  {}

  /// is called before each step; the run ends, with a valid curve, if it returns `false`.
  template <typename Flow>
  bool go_further(const Flow&)
  {
    return true;
  }
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_DEFAULT_CURVE_FLOW_VISITOR_H
