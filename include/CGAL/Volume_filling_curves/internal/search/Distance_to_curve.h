// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How far is a point from a curve? The edges in a CGAL AABB tree, each as a degenerate triangle
// with the same box, and once more as pairs of points in the order of the leaves. Built in
// O(n log n) time; a query takes O(log n) near the curve.
class Distance_to_curve
{
public:
  template <typename Network>
  explicit Distance_to_curve(const Network& curve)
  {
    m_triangles.reserve(curve.number_of_edges());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      const Vector p = to_vector(curve.point(curve.source(e)));
      const Vector q = to_vector(curve.point(curve.target(e)));
      const Point b(q.x(), q.y(), q.z());
      m_triangles.emplace_back(Point(p.x(), p.y(), p.z()), b, b);
    }
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
    Listing_query query{m_segments};
    if(m_tree.size() > 1) Nearest_first_descent<Tree, Listing_query>(query).run(m_tree);
    if(m_tree.size() == 1) query.visit(Primitive(m_triangles.cbegin()), 0);
  }

  Distance_to_curve(const Distance_to_curve&) = delete; // the tree points at the triangles
  Distance_to_curve& operator=(const Distance_to_curve&) = delete;

  // returns the distance of p to the curve, infinity if there are no edges
  double distance(const Vector& p) const
  {
    Distance_query query{m_segments, p, std::numeric_limits<double>::infinity()};
    if(m_segments.size() > 1) Nearest_first_descent<Tree, Distance_query>(query).run(m_tree);
    if(m_segments.size() == 1) query.visit(Primitive(m_triangles.cbegin()), 0);
    return std::sqrt(query.squared_distance);
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = Aabb_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>>;
  using Segments = std::vector<std::array<Vector, 2>>;

  struct Listing_query
  {
    Segments& segments;

    double bound() const { return 1; }
    double entry(const Bbox_3&) const { return 0; }
    void visit(const Primitive& primitive, std::size_t)
    {
      segments.push_back({to_vector((*primitive.id())[0]), to_vector((*primitive.id())[1])});
    }
  };

  struct Distance_query
  {
    const Segments& segments;
    Vector p;
    double squared_distance;

    double bound() const { return squared_distance; }
    double entry(const Bbox_3& box) const { return squared_distance_to_box(p, box); }
    void visit(const Primitive&, std::size_t i)
    {
      const auto& [a, b] = segments[i];
      squared_distance = (std::min)(squared_distance, squared_distance_to_segment(p, a, b));
    }
  };

  Triangles m_triangles;
  Tree m_tree;
  Segments m_segments;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SEARCH_DISTANCE_TO_CURVE_H
