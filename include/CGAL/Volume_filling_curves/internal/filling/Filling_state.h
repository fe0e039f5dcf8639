// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Length_window.h>
#include <CGAL/Volume_filling_curves/internal/filling/Polishing_record.h>
#include <CGAL/Volume_filling_curves/internal/flow/Flow_motion.h>
#include <CGAL/Volume_filling_curves/internal/flow/Idle_steps.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// All that a filling depends on between two steps, besides the curve and its guard. A run that was
// interrupted makes the same decisions, and continues in the middle of a stage.
struct Filling_state
{
  Curve_flow_statistics statistics; // after the last complete step
  double gradient_norm = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> numbers; // decided between stages
  std::vector<Vector> points;  // likewise, some at a time
  std::vector<std::size_t> point_counts;
  std::size_t stage = 0; // from 1
  Length_window lengths; // of the stage, as all that follows
  Polishing_record polishing;
  double max_displacement = 0; // in units of the thickness
  Idle_steps idle_steps;
  Flow_state flow;

  auto members()
  {
    return std::tuple_cat(std::tie(statistics, gradient_norm, numbers, points, point_counts, stage,
                                   lengths.values, polishing.fractions, max_displacement,
                                   idle_steps),
                          flow.members());
  }

  bool is_valid() const
  {
    for(const double fraction : polishing.fractions)
      if(!(fraction >= 0 && fraction <= 1)) return false;
    std::size_t rest = points.size();
    for(const std::size_t count : point_counts) {
      if(count > rest) return false;
      rest -= count;
    }
    return rest == 0 && stage > 0 && is_positive(max_displacement);
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H
