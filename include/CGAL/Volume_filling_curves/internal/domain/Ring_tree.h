// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RING_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RING_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Ray_entry.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/planar_predicates.h>
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
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Ring: the outer boundary of a polygon, or one of its holes.
struct Ring
{
  std::vector<Planar_point> corners; // no two consecutive ones are equal
  std::vector<std::size_t> numbers;  // of the corners, in the input
  std::size_t polygon = 0;
  std::size_t hole = outer; // the number among the holes of the polygon

  static constexpr std::size_t outer = static_cast<std::size_t>(-1);

  bool is_outer() const { return hole == outer; }

  Planar_point source(std::size_t k) const { return corners[k]; }
  Planar_point target(std::size_t k) const { return corners[k + 1 == corners.size() ? 0 : k + 1]; }
};

// Tree of the edges of rings in the plane z = 0. The rings around a point, and intersections with
// triangles, are decided exactly; distances are computed in double. Logarithmic time per query for
// most points.
class Ring_tree
{
public:
  struct Edge
  {
    std::size_t ring, number; // from the corner with that number to the next one
    Planar_point source, target;
  };

  explicit Ring_tree(const std::vector<Ring>& rings)
  {
    std::vector<Edge> edges;
    for(std::size_t r = 0; r < rings.size(); ++r)
      for(std::size_t k = 0; k < rings[r].corners.size(); ++k)
        edges.push_back({r, k, rings[r].source(k), rings[r].target(k)});
    std::vector<Bbox_3> boxes;
    for(const Edge& edge : edges) boxes.push_back(box_of(edge.source) + box_of(edge.target));
    const Surface_area_order order(boxes);
    m_tree = Box_tree(order.sorted(boxes), order.run_ends());
    m_edges = order.sorted(edges);
    for(int i = 0; i < 2; ++i)
      m_max_coordinate =
          (std::max)({m_max_coordinate, std::abs(bbox().min(i)), std::abs(bbox().max(i))});
  }

  // in the order of the tree
  const std::vector<Edge>& edges() const { return m_edges; }

  const Bbox_3& bbox() const { return m_tree.root().hull(); }

  // Calls a function for the edges that meet a closed triangle, which may be degenerate, until it
  // returns true; returns whether it has. Exact.
  template <typename Function>
  bool any_meeting(const std::array<Planar_point, 3>& triangle, const Function& function) const
  {
    const Bbox_3 box = box_of(triangle[0]) + box_of(triangle[1]) + box_of(triangle[2]);
    const auto overlaps = [&](const Bbox_3& other) { return CGAL::do_overlap(box, other); };
    return any_leaf(m_tree, overlaps, [&](std::size_t i) {
      const Edge& edge = m_edges[i];
      return does_triangle_meet_segment(triangle, edge.source, edge.target) && function(edge);
    });
  }

  bool does_meet(const std::array<Planar_point, 3>& triangle) const
  {
    return any_meeting(triangle, [](const Edge&) { return true; });
  }

  // Returns the rings, except a given one, that have the point strictly inside, in order, by the
  // parity of the edges that the ray along the x-axis crosses. Exact.
  // \pre the point is on none of them
  std::vector<std::size_t> rings_around(const Planar_point& p, std::size_t except = none) const
  {
    std::set<std::size_t> odd;
    cross(p, except, [&](const Edge& edge) {
      if(!odd.insert(edge.ring).second) odd.erase(edge.ring);
    });
    return {odd.begin(), odd.end()};
  }

  // returns whether the point is on no ring, and strictly inside of an odd number of them; exact
  bool encloses(const Planar_point& p) const
  {
    bool is_odd = false;
    return cross(p, none, [&](const Edge&) { is_odd = !is_odd; }) && is_odd;
  }

  // returns the distance to the nearest edge, or `limit` if that is less
  double distance(const Vector& p, double limit = infinity) const
  {
    Distance_query query{*this, p, limit * limit};
    Nearest_first_descent<Distance_query>(m_tree, query).run();
    return query.nearest < limit * limit ? std::sqrt(query.nearest) : limit;
  }

  // Returns the squared distance of the segment pq to the nearest edge, and the position of the
  // nearest point on pq, from 0 to 1. \pre the segment meets no edge
  std::pair<double, double> nearest_to_segment(const Vector& p, const Vector& q) const
  {
    Segment_query query{*this, p, q, to_bbox(Box(p).extend(q)), {infinity, 0}};
    Nearest_first_descent<Segment_query>(m_tree, query).run();
    return query.nearest;
  }

  // returns the least t <= limit for which p + t u lies on an edge, or `limit`. \pre p and u lie in
  // the plane
  double distance_along(const Vector& p, const Vector& u, double limit) const
  {
    Ray_query query{*this, p, u, Ray_entry(p, u, m_max_coordinate), limit};
    Nearest_first_descent<Ray_query>(m_tree, query).run();
    return query.nearest;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Calls a function for the edges that the ray crosses, except those of one ring, unless the point
  // lies on an edge; returns whether it does not. An edge contains its lower end, hence a corner
  // counts once.
  template <typename Function>
  bool cross(const Planar_point& p, std::size_t except, const Function& function) const
  {
    const auto may_cross = [&](const Bbox_3& box) {
      return box.ymin() <= p.y() && p.y() <= box.ymax() && p.x() <= box.xmax();
    };
    return !any_leaf(m_tree, may_cross, [&](std::size_t i) {
      const Edge& e = m_edges[i];
      if(e.ring == except) return false;
      const bool is_upward = e.source.y() <= p.y();
      if(is_upward != (e.target.y() <= p.y()) &&
         CGAL::orientation(e.source, e.target, p) == (is_upward ? LEFT_TURN : RIGHT_TURN))
        function(e);
      return does_segment_hold(e.source, e.target, p);
    });
  }

  struct Distance_query
  {
    const Ring_tree& rings;
    Vector p;
    double nearest; // squared

    double bound() const { return nearest; }
    double entry(const Bbox_3& box) const { return squared_distance_to_box(p, box); }

    void visit(std::size_t i)
    {
      const Edge& edge = rings.m_edges[i];
      nearest = (std::min)(
          nearest, squared_distance_to_segment(p, position(edge.source), position(edge.target)));
    }
  };

  // Of two disjoint segments, an end of one is nearest to the other.
  struct Segment_query
  {
    const Ring_tree& rings;
    Vector p, q;
    Bbox_3 box;
    std::pair<double, double> nearest; // squared distance, position

    double bound() const { return nearest.first; }
    double entry(const Bbox_3& other) const { return squared_distance_of_boxes(box, other); }

    void visit(std::size_t i)
    {
      const Vector a = position(rings.m_edges[i].source), b = position(rings.m_edges[i].target);
      add(squared_distance_to_segment(p, a, b), 0);
      add(squared_distance_to_segment(q, a, b), 1);
      for(const Vector& corner : {a, b})
        add(squared_distance_to_segment(corner, p, q), position_on_segment(corner, p, q));
    }

    void add(double squared_distance, double position)
    {
      if(squared_distance < nearest.first) nearest = {squared_distance, position};
    }
  };

  struct Ray_query
  {
    const Ring_tree& rings;
    Vector p, u;
    Ray_entry ray_entry;
    double nearest;

    double bound() const { return nearest; }
    double entry(const Bbox_3& box) const { return ray_entry(box, nearest); }

    // The neighbors of edges parallel to the ray decide.
    void visit(std::size_t i)
    {
      constexpr double slack = 1e-12; // for the rounding where the ray goes through a corner
      const Vector a = position(rings.m_edges[i].source) - p;
      const Vector edge = position(rings.m_edges[i].target) - p - a;
      const double height = u.cross(edge).z();
      if(height == 0) return;
      const double s = u.cross(a).z() / -height, t = a.cross(edge).z() / height;
      if(s >= -slack && s <= 1 + slack && t >= 0) nearest = (std::min)(nearest, t);
    }
  };

  static Vector position(const Planar_point& p) { return {p.x(), p.y(), 0}; }
  static Bbox_3 box_of(const Planar_point& p) { return {p.x(), p.y(), 0, p.x(), p.y(), 0}; }

  Box_tree m_tree;
  std::vector<Edge> m_edges;   // in the order of the leaves
  double m_max_coordinate = 0; // absolute value of a coordinate
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_RING_TREE_H
