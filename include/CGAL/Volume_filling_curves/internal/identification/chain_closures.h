// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_CLOSURES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_CLOSURES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polygon_projection.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Ways to close an open chain, which is a polygon without its last edge. The diagrams are exact.

// The points of an open component in order. \throws std::invalid_argument if it is none
template <typename Network>
std::vector<Vector> points_of_chain(const Network& curves, std::size_t component)
{
  if(component >= curves.number_of_components() || curves.is_closed(component) ||
     has_junction(curves, component))
    throw std::invalid_argument("component " + std::to_string(component) + " is not an open chain");
  const auto edges = edges_along(curves, component);
  std::vector<Vector> points{to_vector(curves.point(curves.source(edges.front())))};
  for(const std::size_t e : edges) points.push_back(to_vector(curves.point(curves.target(e))));
  return points;
}

inline Closed_polygons closed_polygon(std::vector<Vector> points)
{
  Closed_polygons polygon{std::move(points), {}};
  polygon.close();
  return polygon;
}

// Directions spread evenly on the sphere: a Fibonacci lattice, rotated at random.
inline std::vector<Viewing_direction> spread_directions(std::size_t number, std::size_t seed)
{
  constexpr double scale = 1 << 20, golden_section = 0.6180339887498949;
  Random_source random(seed);
  const Vector axis = random.direction(), x = axis.unitOrthogonal(), y = axis.cross(x);
  const double phase = random.real();
  std::vector<Viewing_direction> directions;
  for(std::size_t k = 0; k < number; ++k) {
    const double index = static_cast<double>(k), z = 1 - (2 * index + 1) / double(number);
    const auto [c, s] = cos_sin(phase + golden_section * index);
    const Vector d = scale * (std::sqrt(1 - z * z) * (c * x + s * y) + z * axis);
    directions.push_back(
        {int(std::lround(d.x())), int(std::lround(d.y())), int(std::lround(d.z()))});
  }
  return directions;
}

// The diagram of a chain with both ends extended to infinity in a direction, and joined there. Seen
// from there, the extensions are points, and the path that joins them passes above all else, so one
// projection gives this diagram without any points far away. The path has a corner: a single edge
// would cover one at an end of the chain that points at the other end.
// \throws std::invalid_argument if the chain meets itself
// \throws Run_stopped in a Watched_scope
inline Planar_diagram diagram_closed_at_infinity(std::vector<Vector> chain,
                                                 Viewing_direction direction)
{
  constexpr int max_refused = 20; // as in find_diagram()
  const std::size_t last = chain.size() - 1;
  const Vector middle = (chain.front() + chain.back()) / 2;
  // of a gap, or of the first edge if the ends nearly meet: no corner may be rounded to an end
  const double length =
      (std::max)((chain.front() - chain.back()).norm(), 1e-3 * (chain[1] - chain.front()).norm());
  chain.emplace_back();
  Closed_polygons polygon = closed_polygon(std::move(chain));
  for(int k = 0; k < max_refused; ++k) {
    polygon.points.back() = middle + length / 4 * Random_source(std::size_t(k)).direction();
    auto diagram = Polygon_projection(polygon, direction, last)();
    if(diagram) return std::move(*diagram);
    direction[std::size_t(k % 3)] += k + 1; // an angle of 1e-6 makes it generic
  }
  throw std::invalid_argument("the chain has no generic projection: it meets itself");
}

// A short path from an end of a chain out of its convex hull: a unit vector, and a distance.
struct Hull_exit
{
  Vector direction;
  double distance = std::numeric_limits<double>::infinity();
};

// The distance to the plane that touches the hull in a direction is least for the nearest face. The
// best of many directions is improved by a pattern search, in doubles: whatever exit is taken, the
// closure is an exact polygon. \throws Run_stopped in a Watched_scope
inline Hull_exit hull_exit(const std::vector<Vector>& chain, const Vector& end)
{
  constexpr std::size_t number_of_directions = 500; // 0.16 apart
  constexpr double first_step = 0.1, last_step = 1e-6;
  Hull_exit best;
  const auto improve = [&](const Vector& direction) {
    check_run();
    double distance = 0;
    for(const Vector& p : chain) distance = (std::max)(distance, direction.dot(p - end));
    if(distance >= best.distance) return false;
    best = {direction, distance};
    return true;
  };
  for(const Viewing_direction& d : spread_directions(number_of_directions, 0))
    improve(Vector(d[0], d[1], d[2]).normalized());
  for(double step = first_step; step > last_step;) {
    const Vector d = best.direction, x = step * d.unitOrthogonal(), y = d.cross(x);
    const bool is_better = improve((d + x).normalized()) || improve((d - x).normalized()) ||
                           improve((d + y).normalized()) || improve((d - y).normalized());
    if(!is_better) step /= 2;
  }
  return best;
}

// The polygon of the minimally interfering closure (Tubiana, Orlandini, Micheletti 2011): the ends
// of the chain are joined by a segment or, if that is shorter, extended to the nearest points of
// the convex hull, and far beyond. \throws Run_stopped in a Watched_scope
inline Closed_polygons minimally_interfering_closure(std::vector<Vector> chain)
{
  const Hull_exit at_front = hull_exit(chain, chain.front()),
                  at_back = hull_exit(chain, chain.back());
  if(at_front.distance + at_back.distance >= (chain.front() - chain.back()).norm())
    return closed_polygon(std::move(chain));
  Vector low = chain.front(), high = low;
  for(const Vector& p : chain) low = low.cwiseMin(p), high = high.cwiseMax(p);
  // Edges between points that are seen from the center at most 100 degrees apart are 6 diameters
  // away from it.
  const double far = 10 * (high - low).norm();
  const Vector sum = at_front.direction + at_back.direction, center = (low + high) / 2;
  const Vector between = sum.norm() > 0.1 ? sum.normalized() : at_front.direction.unitOrthogonal();
  const Vector first = chain.front() + far * at_front.direction;
  chain.push_back(chain.back() + far * at_back.direction);
  chain.push_back(center + far * between);
  chain.push_back(first);
  return closed_polygon(std::move(chain));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IDENTIFICATION_CHAIN_CLOSURES_H
