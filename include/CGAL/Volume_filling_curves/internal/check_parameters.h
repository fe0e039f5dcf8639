// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>

#include <cmath>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

inline bool is_positive(double x)
{
  return x > 0 && std::isfinite(x);
}

// Throws std::invalid_argument if a flow cannot use the parameters.
inline void check_parameters(const Curve_flow_parameters& p)
{
  const auto is_positive_or_zero = [](double x) { return x == 0 || is_positive(x); };
  const bool are_valid = p.number_of_directions > 0 && is_positive(p.max_radius) &&
                         is_positive(p.spacing) && is_positive(p.screening) &&
                         is_positive(p.max_displacement) && is_positive(p.medial_weight) &&
                         is_positive_or_zero(p.thickness) && is_positive_or_zero(p.coupling) &&
                         is_positive_or_zero(p.time_step);
  if(!are_valid)
    throw std::invalid_argument("the parameters of a flow must be positive and finite");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CHECK_PARAMETERS_H
