// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WITH_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WITH_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The parameters of a flow that has a thickness of its own: a run changes the thickness, but not
// the parameters that it was given.
inline Curve_flow_parameters with_thickness(Curve_flow_parameters parameters, double thickness)
{
  parameters.thickness = thickness;
  return parameters;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WITH_THICKNESS_H
