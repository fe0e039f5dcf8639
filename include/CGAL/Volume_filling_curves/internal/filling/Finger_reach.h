// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_REACH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_REACH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_stations.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
  static constexpr double max_thin_root =
      0.2; // longest edge that a thin finger grows from, likewise
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
