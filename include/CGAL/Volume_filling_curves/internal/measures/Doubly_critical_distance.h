// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_DOUBLY_CRITICAL_DISTANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_DOUBLY_CRITICAL_DISTANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_interval.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_clearance.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Length of the shortest doubly critical chord: at both of its ends the distance to the other end
// turns from growing to shrinking or back (Rawdon 1998; Ashton, Cantarella, Rawdon 2005). The chord
// and the curve between its ends form a loop with a total turning of at least 2 pi, of which at
// most a right angle is at each end of the chord. Hence the curve between the ends turns by at
// least pi, and pairs of edges with less turning in between are skipped. Near-linear time if the
// curve turns by pi within few edges, or if few chords are shorter than `bound`.
template <typename Network>
class Doubly_critical_distance
{
public:
  explicit Doubly_critical_distance(const Network& curve)
      : m_curve(curve),
        m_unit(unit_of_size(curve)),
        m_spans(turning_spans(curve)),
        m_tangents(curve.number_of_nodes())
  {
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      const Vector tangent = edge(e).normalized();
      m_tangents[curve.source(e)].out = tangent;
      m_tangents[curve.target(e)].in = tangent;
    }
  }

  // returns the least of `bound` and the doubly critical distance
  double operator()(double bound, Run_watch* watch = nullptr) const
  {
    const Least_pair_distance pairs(m_curve, m_spans, m_unit);
    const auto distance = [&](std::size_t e, std::size_t f) {
      const Curve_interval &a = m_spans.of_edge[e], &b = m_spans.of_edge[f];
      if(share_a_node(m_curve, e, f)) return infinity;
      if(a.is_comparable(b) && m_spans.reach(a, b) < min_turning) return infinity;
      return shortest_critical_chord(e, f);
    };
    return pairs.nearest(m_unit * bound, min_turning, distance, watch).distance / m_unit;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double min_turning = CGAL_PI * (1 - 1e-9); // sums of angles are rounded

  // A chord counts as orthogonal to an edge within this sine: otherwise the chords of two parallel
  // edges, orthogonal to both, would count or not by chance of rounding.
  static constexpr double orthogonality = 1e-9;

  struct Tangents
  {
    Vector in, out; // zero beyond an end
  };

  Vector point(std::size_t v) const { return m_unit * to_vector(m_curve.point(v)); }
  Vector edge(std::size_t e) const { return point(m_curve.target(e)) - point(m_curve.source(e)); }

  double shortest_critical_chord(std::size_t e, std::size_t f) const
  {
    double shortest = chord_inside_both(e, f);
    for(std::size_t v : {m_curve.source(e), m_curve.target(e)}) {
      shortest = (std::min)(shortest, chord_from_node(v, f));
      for(std::size_t w : {m_curve.source(f), m_curve.target(f)})
        shortest = (std::min)(shortest, chord_of_nodes(v, w));
    }
    for(std::size_t w : {m_curve.source(f), m_curve.target(f)})
      shortest = (std::min)(shortest, chord_from_node(w, e));
    return shortest;
  }

  // The common perpendicular, if its feet lie inside the edges.
  double chord_inside_both(std::size_t e, std::size_t f) const
  {
    const Vector a = point(m_curve.source(e)), c = point(m_curve.source(f));
    return std::sqrt(squared_common_perpendicular(edge(e), edge(f), a - c));
  }

  double chord_from_node(std::size_t v, std::size_t f) const
  {
    const Vector p = point(v), a = point(m_curve.source(f)), u = edge(f);
    const double t = (p - a).dot(u), uu = u.squaredNorm();
    if(!(t >= 0 && t <= uu)) return infinity;
    const Vector chord = a + (t / uu) * u - p;
    return turns_at(v, chord) ? chord.norm() : infinity;
  }

  double chord_of_nodes(std::size_t v, std::size_t w) const
  {
    const Vector chord = point(w) - point(v);
    return turns_at(v, chord) && turns_at(w, -chord) ? chord.norm() : infinity;
  }

  // returns whether the distance to the chord's other end turns at node v; an end of the curve
  // counts if the distance shrinks towards it
  bool turns_at(std::size_t v, const Vector& chord) const
  {
    const double tolerance = orthogonality * chord.norm();
    const Tangents& tangents = m_tangents[v];
    const double in = chord.dot(tangents.in), out = chord.dot(tangents.out);
    if(m_curve.degree(v) == 1) return in >= -tolerance && out <= tolerance;
    return (in >= -tolerance && out <= tolerance) || (in <= tolerance && out >= -tolerance);
  }

  const Network& m_curve;
  const double m_unit; // scales the curve to a size of about 1
  const Curve_intervals m_spans;
  std::vector<Tangents> m_tangents; // per node; junctions are not supported
};

// The radius of the thickest tube around a curve without junctions, see polygonal_thickness().
template <typename Network>
double tube_radius(const Network& curve, Run_watch* watch = nullptr)
{
  return Doubly_critical_distance<Network>(curve)(2 * internal::min_bend_radius(curve), watch) / 2;
}

// Whether the first closed curves have a lower ropelength than the second ones, and about as few
// crossings: tight curves have up to 5 % more of them than the same ones a bit loose. Near linear.
// \throws Run_stopped
template <typename Network>
bool is_tighter(const Network& first, const Network& second, Run_watch& watch)
{
  constexpr double max_crossings = 1.1; // of one, in units of the other's
  const auto ropelength_of = [&](const Network& curve) {
    watch.check();
    return total_length(curve) / tube_radius(curve, &watch);
  };
  return ropelength_of(first) < ropelength_of(second) &&
         average_crossing_number(first, 1, &watch) <=
             max_crossings * average_crossing_number(second, 1, &watch);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_DOUBLY_CRITICAL_DISTANCE_H
