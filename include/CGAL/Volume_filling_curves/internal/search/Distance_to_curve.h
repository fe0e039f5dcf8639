// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/search/Surface_area_order.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Distance from a point to a curve. The edges are stored as pairs of points in the order of a
// tree's leaves. Construction takes O(n log n) time, a query O(log n) near the curve.
class Distance_to_curve
{
public:
  template <typename Network>
  explicit Distance_to_curve(const Network& curve)
  {
    Segments segments;
    std::vector<Bbox_3> boxes;
    segments.reserve(curve.number_of_edges());
    boxes.reserve(curve.number_of_edges());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      segments.push_back(
          {to_vector(curve.point(curve.source(e))), to_vector(curve.point(curve.target(e)))});
      const auto& [p, q] = segments.back();
      boxes.push_back(to_bbox(Box(p.cwiseMin(q), p.cwiseMax(q))));
    }
    const Surface_area_order order(boxes);
    m_tree = Box_tree(order.sorted(boxes), order.run_ends());
    m_segments = order.sorted(segments);
  }

  // returns the distance of p to the curve, infinity if there are no edges
  double distance(const Vector& p) const
  {
    Distance_query query{m_segments, p, std::numeric_limits<double>::infinity()};
    Nearest_first_descent<Distance_query>(m_tree, query).run();
    return std::sqrt(query.squared_distance);
  }

private:
  using Segment = std::array<Vector, 2>;
  using Segments = std::vector<Segment>;

  struct Distance_query
  {
    const Segments& segments;
    Vector p;
    double squared_distance;

    double bound() const { return squared_distance; }
    double entry(const Bbox_3& box) const { return squared_distance_to_box(p, box); }
    void visit(std::size_t i)
    {
      const auto& [a, b] = segments[i];
      squared_distance = (std::min)(squared_distance, squared_distance_to_segment(p, a, b));
    }
  };

  Box_tree m_tree;
  Segments m_segments;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H
