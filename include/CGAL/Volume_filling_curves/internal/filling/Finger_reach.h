// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_REACH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_REACH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_stations.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Finger that grows out of an edge of a curve: the edge is halved, and one half is pulled out to a
// blunt tip, an edge across the path, by two insertions, each an elementary move that the guard
// certifies. Constant time apart from the guard's search.
template <typename Guard>
class Finger
{
  using Network = typename Guard::Curve_network;

public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Finger(Guard& guard, std::size_t edge) : m_guard(guard), m_edge(edge) {}

  // The length of an edge as seen from a point: the longer, the better a finger grows from it.
  static double span(const Network& curve, std::size_t e, const Vector& p)
  {
    const Vector a = to_vector(curve.point(curve.source(e)));
    const Vector b = to_vector(curve.point(curve.target(e)));
    return across(b - a, p - (a + b) / 2).norm();
  }

  // Halves the edge and returns the second half, or none if the guard refuses. \pre it is whole
  std::size_t halve()
  {
    if(halve_edge(m_guard, m_edge)) m_half = edge_after(m_edge);
    return m_half;
  }

  // Pulls the finger to a tip of the given half width around p, whose ends must both have enough
  // clearance; returns whether it has grown.
  template <typename HasClearance>
  bool grow(const Vector& p, double half_width, const HasClearance& has_clearance)
  {
    const Vector a = position(curve().source(m_edge));
    const Vector b = position(curve().target(m_half == none ? m_edge : m_half));
    const Vector side = half_width * across(b - a, p - (a + b) / 2).normalized();
    if(!has_clearance(p - side) || !has_clearance(p + side)) return false;
    if(m_half == none && halve() == none) return false;
    if(!insert(m_half, p - side)) return false;
    const std::size_t first = curve().target(m_half), rest = edge_after(m_half);
    if(!insert(rest, p + side)) {
      m_guard.remove_node(first);
      return false;
    }
    m_tip = rest;
    return true;
  }

  // Undoes the halving of the edge. \pre the finger has not grown
  void withdraw()
  {
    if(m_half != none && m_guard.remove_node(curve().target(m_edge))) m_half = none;
  }

  // the edge of the tip. \pre the finger has grown
  std::size_t tip() const { return m_tip; }

  // the edges of the sides, which lead to the tip and back. \pre the finger has grown
  std::array<std::size_t, 2> sides() const { return {m_half, edge_after(m_tip)}; }

private:
  const Network& curve() const { return m_guard.curve(); }

  Vector position(std::size_t v) const { return to_vector(curve().point(v)); }

  static Vector across(const Vector& v, const Vector& direction)
  {
    return v - v.dot(direction) / direction.squaredNorm() * direction;
  }

  bool insert(std::size_t e, const Vector& p)
  {
    return m_guard.insert_node(e, to_point(p, curve().traits()));
  }

  // the edge that an inserted node joins to e
  std::size_t edge_after(std::size_t e) const
  {
    const std::size_t v = curve().target(e);
    return curve().incident_edge(v, curve().incident_edge(v, 0) == e ? 1 : 0);
  }

  Guard& m_guard;
  std::size_t m_edge;
  std::size_t m_half = none, m_tip = none; // the second half of the edge; the tip
};

// Growth of a finger from one station to another, out of the best placed edge, with the widest tip
// that the guard certifies.
template <typename Guard, typename Domain>
class Finger_reach
{
public:
  Finger_reach(Guard& guard, const Domain& domain) : m_guard(guard), m_domain(domain) {}

  // Returns whether a finger has grown; its edges are added to the other station.
  bool operator()(const Finger_station& from, Finger_station& to)
  {
    return grow_out_of_best(from.edges, wide, to);
  }

  // Likewise with a thin finger, out of a piece of an edge, where no wide one fits. The pieces are
  // added to the first station.
  bool squeeze(Finger_station& from, Finger_station& to)
  {
    for(std::size_t k = 0; k < from.edges.size(); ++k)
      while(from.edges.size() < max_pieces && is_long(from.edges[k], from.thickness)) {
        const std::size_t half = Finger<Guard>(m_guard, from.edges[k]).halve();
        if(half == Finger<Guard>::none) break;
        from.edges.push_back(half);
      }
    return grow_out_of_best(from.edges, thin, to);
  }

private:
  // Half widths of tips, in units of the thickness; the first one that fits is taken.
  using Half_widths = std::vector<double>;
  inline static const Half_widths wide{0.7, 0.21, 0.1}, thin{0.1, 0.03};
  static constexpr double tip_clearance = 0.2; // from the boundary, likewise
  static constexpr double max_thin_root = 0.2; // the longest edge of a thin finger's root, likewise
  static constexpr std::size_t max_pieces = 64;

  bool is_long(std::size_t e, double thickness) const
  {
    return edge_vector(m_guard.curve(), e).norm() > max_thin_root * thickness;
  }

  bool grow_out_of_best(const std::vector<std::size_t>& edges,
                        const Half_widths& half_widths,
                        Finger_station& to)
  {
    std::vector<std::pair<double, std::size_t>> best_first;
    for(const std::size_t e : edges)
      best_first.push_back({Finger<Guard>::span(m_guard.curve(), e, to.position), e});
    std::sort(best_first.begin(), best_first.end(), std::greater<>());
    return std::any_of(best_first.begin(), best_first.end(), [&](const auto& edge) {
      return edge.first > 0 && grow_out_of(edge.second, half_widths, to);
    });
  }

  bool grow_out_of(std::size_t e, const Half_widths& half_widths, Finger_station& to)
  {
    const double clearance = depth_at(to.position);
    const auto has_clearance = [&](const Vector& x) {
      return depth_at(x) >= (std::min)(tip_clearance * to.thickness, clearance / 4);
    };
    Finger<Guard> finger(m_guard, e);
    for(const double half_width : half_widths)
      if(finger.grow(to.position, (std::min)(half_width * to.thickness, clearance / 2),
                     has_clearance)) {
        to.edges.push_back(finger.tip());
        // In the plane the tip has one side, and branches grow out of the finger's sides as well:
        // without those one in six stations is reached by detours or not at all.
        if(Space_of<Domain>::is_plane)
          for(const std::size_t side : finger.sides()) to.edges.push_back(side);
        return true;
      }
    finger.withdraw();
    return false;
  }

  // the distance to the boundary, 0 outside
  double depth_at(const Vector& x) const
  {
    return depth(m_domain, to_point(x, m_guard.curve().traits()));
  }

  Guard& m_guard;
  const Domain& m_domain;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_REACH_H
