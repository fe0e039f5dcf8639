// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STOP_RULES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STOP_RULES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// When the untangling of a curve ends, and the defaults of the named parameters that say so.
struct Stop_rules
{
  double tolerance = 7e-3; // of the gradient norm
  std::size_t max_iterations = 5000;
  double time_limit = std::numeric_limits<double>::infinity(); // in seconds
  bool stop_at_proof = true;
  bool starts_from_search = false; // then what is proved at once is coarse, and flows on
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STOP_RULES_H
