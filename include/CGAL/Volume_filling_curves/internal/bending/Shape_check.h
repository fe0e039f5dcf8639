// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_CHECK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_CHECK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Point of a curve that comes closest to a limit of its shape, or exceeds it most.
struct Shape_extreme
{
  double share = std::numeric_limits<double>::infinity(); // value at the point, over the limit
  double value = 0, limit = 0;
  Vector point;

  void note(double other_value, double other_limit, const Vector& other_point)
  {
    if(!(other_value < share * other_limit)) return;
    *this = {other_value / other_limit, other_value, other_limit, other_point};
  }

  // but for rounding
  bool is_kept() const { return share >= min_share; }

  static constexpr double min_share = 1 - 1e-12;
};

// Tightest bend and closest strands of a curve, compared with the limits of its shape. Near-linear.
struct Shape_check
{
  template <typename ConcurrencyTag, typename Network>
  Shape_check(ConcurrencyTag, const Network& curve, const Shape_limits& limits)
      : Shape_check(curve, limits, Strand_pairs(ConcurrencyTag(), curve, limits, 0))
  {}

  // Takes pairs of strands that were found before.
  template <typename Network>
  Shape_check(const Network& curve, const Shape_limits& limits, const Strand_pairs& pairs)
  {
    const Vector_field x = coordinates(curve);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      if(curve.degree(v) != 2 || !(limits.bend_radius[v] > 0)) continue;
      const Vector in = row(x, v) - row(x, curve.neighbor(v, 0));
      const Vector out = row(x, curve.neighbor(v, 1)) - row(x, v);
      const double radius = bend_radius(in, out);
      bend.note(radius, limits.bend_radius[v], row(x, v));
      if(radius < Shape_extreme::min_share * limits.bend_radius[v]) exceeding_nodes.push_back(v);
    }
    for(const auto& [e, f] : pairs.pairs()) {
      const auto end = [&](std::size_t k, std::size_t i) { return row(x, pairs.ends(k)[i]); };
      const double squared_distance =
          squared_segment_distance(end(e, 0), end(e, 1), end(f, 0), end(f, 1));
      const double distance = std::sqrt(squared_distance);
      strands.note(distance, pairs.distance(e, f), end(e, 0));
      if(distance < Shape_extreme::min_share * pairs.distance(e, f))
        for(const std::size_t k : {e, f})
          exceeding_nodes.insert(exceeding_nodes.end(), pairs.ends(k).begin(), pairs.ends(k).end());
    }
    std::sort(exceeding_nodes.begin(), exceeding_nodes.end());
    exceeding_nodes.erase(std::unique(exceeding_nodes.begin(), exceeding_nodes.end()),
                          exceeding_nodes.end());
  }

  bool is_passed() const { return bend.is_kept() && strands.is_kept(); }

  Shape_extreme bend, strands;
  std::vector<std::size_t> exceeding_nodes; // at bends and edges that exceed a limit
};

// Returns the extremes that exceed a limit.
template <typename Point_3, typename Traits>
std::vector<Shape_excess_3<Point_3>> shape_excesses(const Shape_check& check, const Traits& traits)
{
  std::vector<Shape_excess_3<Point_3>> excesses;
  for(const bool is_bend : {true, false}) {
    const Shape_extreme& extreme = is_bend ? check.bend : check.strands;
    if(!extreme.is_kept())
      excesses.push_back({to_point(extreme.point, traits), extreme.value, extreme.limit, is_bend});
  }
  return excesses;
}

// Returns the reason of CONSTRAINT_NOT_REACHED.
template <typename Point_3>
std::string shape_reason(const std::vector<Shape_excess_3<Point_3>>& excesses)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3);
  for(const Shape_excess_3<Point_3>& excess : excesses)
    text << (text.tellp() > 0 ? "; " : "")
         << (excess.is_bend ? "the curve bends with a radius of " : "strands have a distance of ")
         << excess.value << ", not " << excess.limit << ", at " << point_text(excess.point);
  return text.str();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_CHECK_H
