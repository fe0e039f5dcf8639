// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Strand_neighbors.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_pair_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Least distance between two edges that are not neighbors along the curve (Strand_neighbors).
// Near-linear time for curves (Least_pair_distance).
template <typename Network>
class Least_clearance
{
public:
  // Takes the neighborhood of each edge, 0 or more.
  Least_clearance(const Network& curve, std::vector<double> neighborhoods)
      : m_curve(curve), m_unit(unit_of_size(curve)), m_neighbors(curve, std::move(neighborhoods))
  {}

  Least_clearance(const Network& curve, double neighborhood)
      : Least_clearance(curve, std::vector<double>(curve.number_of_edges(), neighborhood))
  {}

  // returns the nearest two edges, null ones if all are neighbors
  Least_pair_distance::Pair nearest(Run_watch* watch = nullptr) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::vector<double>& neighborhoods = m_neighbors.neighborhoods();
    if(neighborhoods.empty()) return {infinity};
    const Least_pair_distance pairs(m_curve, m_neighbors.spans(), m_unit);
    const auto distance_of_others = [&](std::size_t e, std::size_t f) {
      return are_neighbors(e, f) ? infinity : distance(e, f);
    };
    const double least = *std::min_element(neighborhoods.begin(), neighborhoods.end());
    auto pair = pairs.nearest(infinity, least, distance_of_others, watch);
    pair.distance /= m_unit;
    return pair;
  }

  double operator()(Run_watch* watch = nullptr) const { return nearest(watch).distance; }

  bool are_neighbors(std::size_t e, std::size_t f) const { return m_neighbors.are_neighbors(e, f); }

private:
  double distance(std::size_t e, std::size_t f) const
  {
    const auto point = [&](std::size_t v) { return Vector(m_unit * to_vector(m_curve.point(v))); };
    return std::sqrt(squared_segment_distance(point(m_curve.source(e)), point(m_curve.target(e)),
                                              point(m_curve.source(f)), point(m_curve.target(f))));
  }

  const Network& m_curve;
  const double m_unit;
  const Strand_neighbors<Network> m_neighbors;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_LEAST_CLEARANCE_H
