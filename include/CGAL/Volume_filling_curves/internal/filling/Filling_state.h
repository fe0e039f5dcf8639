// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Flow_motion.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lengths of a growing curve in its last iterations.
struct Length_window
{
  std::vector<double> values;

  void add(double length) { values.push_back(length); }

  // returns whether the length changed by less than this fraction over the last iterations
  bool has_settled(std::size_t iterations, double fraction) const
  {
    if(values.size() <= iterations) return false;
    const auto begin = values.end() - static_cast<std::ptrdiff_t>(iterations) - 1;
    const auto [min, max] = std::minmax_element(begin, values.end());
    return *max - *min < fraction * *max;
  }

  // since the first one
  double growth() const { return values.empty() ? 1 : values.back() / values.front(); }
};

// Progress of polishing: the fractions of the nodes at which a limit is exceeded, before the first
// step and after each that moves the curve.
struct Polishing_record
{
  std::vector<double> fractions;

  void add(std::size_t exceeding_nodes, std::size_t nodes)
  {
    fractions.push_back(
        nodes > 0 ? static_cast<double>(exceeding_nodes) / static_cast<double>(nodes) : 0);
  }

  double last() const { return fractions.empty() ? 0 : fractions.back(); }
  bool is_done() const { return last() == 0; }

  // Whether the domain has no room for the limits: after the last step more than a twentieth of the
  // nodes still exceed them, and more than half as many as before it. In 108 fillings between ports
  // the first step leaves at most 4 %; in six meshes with walls too thin for the thickness 34 to
  // 70 %, in a plate 1.8 r thick 17 of 22 %. Without this rule the plate took 25 s instead of 2 s,
  // and five of the meshes, polished further and loosened, were filled to 31 instead of 77 %
  // (2026-11-27).
  bool are_limits_out_of_reach() const
  {
    constexpr double many = 0.05, remainder = 0.5;
    const std::size_t n = fractions.size();
    return n > 1 && last() > many && last() > remainder * fractions[n - 2];
  }
};

// All that a filling depends on between two steps, besides the curve and its guard. A run that was
// interrupted makes the same decisions, and continues in the middle of a stage.
struct Filling_state
{
  Curve_flow_statistics statistics; // after the last complete step
  double gradient_norm = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> numbers; // decided between stages
  std::vector<Vector> points;  // likewise, some at a time
  std::vector<std::size_t> point_counts;
  std::size_t stage = 0; // from 1; 0 before the tree of fingers has grown
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

  bool is_start() const { return stage == 0; }

  bool is_valid() const
  {
    if(is_start()) return numbers.empty() && points.empty() && point_counts.empty();
    if(numbers.empty() || numbers[0] == 0) return false; // the thickness
    for(const double number : numbers)
      if(!(number >= 0 && std::isfinite(number))) return false;
    for(const Vector& p : points)
      if(!is_in_range(p)) return false;
    for(const double length : lengths.values)
      if(!is_positive(length)) return false;
    for(const double fraction : polishing.fractions)
      if(!(fraction >= 0 && fraction <= 1)) return false;
    std::size_t rest = points.size();
    for(const std::size_t count : point_counts) {
      if(count > rest) return false;
      rest -= count;
    }
    return rest == 0 && is_positive(max_displacement) && idle_steps.is_valid() && flow.is_valid();
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STATE_H
