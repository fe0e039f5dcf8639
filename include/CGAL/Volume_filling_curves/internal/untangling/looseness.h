// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_LOOSENESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_LOOSENESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The gradient is in units of 1 / r, and below the tolerance on whatever is smooth on the scale of
// r, such as a loop of radius 143 r that nothing holds. So a curve is tight only if contacts and
// bends also carry the pull of its length.

// Whether they leave more than 5 % of it. Tight knots have a share of 1.4 times their gradient,
// 0.01 (236 knots, 2026-11-23); a rough tolerance takes more.
template <typename Flow>
bool is_loose(const Flow& flow, double tolerance)
{
  constexpr double loose = 0.05, loose_over_tolerance = 2;
  return flow.loose_share() >= (std::max)(loose, loose_over_tolerance * tolerance);
}

// The thickness at which a loose curve as it stands is far from smooth, at least twice the present
// one. Ribbons, loops of strands 1e-2 to 1e-11 of their radius apart, come tight from there in 40
// to 130 iterations (2026-11-23).
template <typename Flow>
double fitting_thickness(const Flow& flow, double tolerance)
{
  constexpr double gradient_of_fitting = 0.05;
  const double gradient = (std::max)(gradient_of_fitting, 2 * tolerance);
  return flow.thickness() * gradient / flow.gradient_norm();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_LOOSENESS_H
