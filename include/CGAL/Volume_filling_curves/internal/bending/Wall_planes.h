// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_WALL_PLANES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_WALL_PLANES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Planes that approximate the boundary near nodes and middles of edges close to it. Without them,
// nodes pushed into a wall were held there by the guard and kept the bends next to them: 8 of the
// bunny's 3,200 nodes, between which the bend radius stayed at 0.06 r. Without those of edges, a
// strand hung on a reflex edge of a bracket, its bends at 0.76 r. Normals are differences of
// distances, which every domain has. Linear.
class Wall_planes
{
public:
  // Takes the margin that nodes and the middles of edges must keep, in addition to the distance
  // of the boundary itself.
  template <typename Network, typename Boundary>
  void find(const Network& curve, const Boundary& boundary, const std::vector<double>& margins)
  {
    m_planes.clear();
    if constexpr(Boundary::is_bounded) {
      const Vector_field x = coordinates(curve);
      take_axes(x);
      const auto add_if_close = [&](const Vector& p, std::size_t v, std::size_t w) {
        check_run();
        const double margin = (std::min)(margins[v], margins[w]);
        const double distance = boundary.wall_distance() + margin;
        const double most = boundary.wall_distance() + reach * margin;
        if(curve.is_free(v) && curve.is_free(w) && !boundary.is_farther(p, most))
          add(p, boundary.domain(), {v, w}, distance, most, curve.traits());
      };
      for(std::size_t v = 0; v < margins.size(); ++v) add_if_close(row(x, v), v, v);
      for(const std::size_t e : curve.edges()) {
        const std::size_t v = curve.source(e), w = curve.target(e);
        add_if_close((row(x, v) + row(x, w)) / 2, v, w);
      }
    }
  }

  // Takes the mobility of each node, 1, or 0 for one that is held.
  void push_inside(std::vector<Vector>& x, const std::vector<double>& mobility) const
  {
    for(const Plane& plane : m_planes) {
      const auto [v, w] = plane.ends;
      const double missing = plane.offset - plane.normal.dot((x[v] + x[w]) / 2);
      if(!(missing > 0)) continue;
      x[v] += mobility[v] * missing * plane.normal;
      if(w != v) x[w] += mobility[w] * missing * plane.normal;
    }
  }

private:
  using Ends = std::array<std::size_t, 2>;

  static constexpr double reach = 3; // of planes, in margins beyond the distance of the boundary

  struct Plane
  {
    Ends ends;     // of an edge, or twice a node
    Vector normal; // of length 1, to the inside
    double offset; // of the middle of the ends
  };

  // A curve in a coordinate plane stays there, whatever the rounding.
  void take_axes(const Vector_field& x)
  {
    if(x.rows() == 0) return;
    const Vector extent = sides(x);
    m_is_axis = {extent[0] > 0, extent[1] > 0, extent[2] > 0};
  }

  template <typename Domain, typename Traits>
  void add(const Vector& p,
           const Domain& domain,
           const Ends& ends,
           double distance,
           double most,
           const Traits& traits)
  {
    const double depth = depth_up_to(domain, to_point(p, traits), most);
    if(!(depth < most)) return;
    const double step = (std::min)(distance, depth) / 2; // stays inside
    const Vector gradient = depth_differences(domain, p, step, m_is_axis, traits);
    const double norm = gradient.norm(); // 2 steps at a plane
    if(!(norm > step)) return;           // between two walls, or far outside of the plane
    const Vector normal = gradient / norm;
    m_planes.push_back({ends, normal, normal.dot(p) + distance - depth});
  }

  std::vector<Plane> m_planes;
  std::array<bool, 3> m_is_axis = {true, true, true};
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_WALL_PLANES_H
