// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_INTERVAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_INTERVAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Interval of an edge, or a group of edges, along its component, in terms of a quantity that grows
// along the curve, such as arc length or total turning. It decides whether two edges are too close
// along the curve to count, and does so at once for two groups of edges.
struct Curve_interval
{
  static constexpr std::size_t null = static_cast<std::size_t>(-1);

  std::size_t component = null; // null for edges of several components or at junctions
  double first = 0, last = 0;

  bool is_comparable(const Curve_interval& other) const
  {
    return component == other.component && component != null;
  }

  Curve_interval hull(const Curve_interval& other) const
  {
    return {component == other.component ? component : null, (std::min)(first, other.first),
            (std::max)(last, other.last)};
  }

  double extent() const { return last - first; }
};

// The spans of all edges, and each component's total (infinite if it is open).
struct Curve_intervals
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::vector<Curve_interval> of_edge;
  std::vector<double> total;

  // Returns the gap between two edges of one component, on the shorter side.
  double gap(std::size_t e, std::size_t f) const
  {
    const Curve_interval &a = of_edge[e], &b = of_edge[f];
    const double direct = (std::max)(a.first, b.first) - (std::min)(a.last, b.last);
    return (std::max)(0., (std::min)(direct, total[a.component] - a.hull(b).extent()));
  }

  // Returns the extent of two pieces of one component and of the gap between them, on the shorter
  // side; not less than that of any edges of the two pieces.
  double reach(const Curve_interval& a, const Curve_interval& b) const
  {
    const double between = (std::max)(a.first, b.first) - (std::min)(a.last, b.last);
    return (std::min)(a.hull(b).extent(), total[a.component] - between);
  }
};

// Each edge spans its own piece of the curve's length.
template <typename Network>
Curve_intervals arc_length_spans(const Network& curve)
{
  Curve_intervals spans{
      std::vector<Curve_interval>(curve.number_of_edges()),
      std::vector<double>(curve.number_of_components(), Curve_intervals::infinity)};
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    double length = 0;
    for(std::size_t e : edges_along(curve, c)) {
      const double next = length + edge_vector(curve, e).norm();
      spans.of_edge[e] = {c, length, next};
      length = next;
    }
    if(curve.is_closed(c)) spans.total[c] = length;
  }
  return spans;
}

// Each edge spans the angles at both of its nodes. An end counts as a right angle: a chord may
// leave it in any direction.
template <typename Network>
Curve_intervals turning_spans(const Network& curve)
{
  constexpr double right_angle = CGAL_PI / 2;
  Curve_intervals spans{
      std::vector<Curve_interval>(curve.number_of_edges()),
      std::vector<double>(curve.number_of_components(), Curve_intervals::infinity)};
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    const std::vector<std::size_t> edges = edges_along(curve, c);
    const bool is_closed = curve.is_closed(c);
    const auto angle = [&](std::size_t i, std::size_t j) {
      return turning_angle(edge_vector(curve, edges[i]), edge_vector(curve, edges[j]));
    };
    double turned = 0;
    for(std::size_t i = 0, n = edges.size(); i < n; ++i) {
      const bool has_previous = is_closed || i > 0, has_next = is_closed || i + 1 < n;
      const double at_source = has_previous ? angle((i + n - 1) % n, i) : right_angle;
      const double at_target = has_next ? angle(i, (i + 1) % n) : right_angle;
      spans.of_edge[edges[i]] = {c, turned, turned + at_source + at_target};
      turned += at_source;
    }
    if(is_closed) spans.total[c] = turned;
  }
  return spans;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_INTERVAL_H
