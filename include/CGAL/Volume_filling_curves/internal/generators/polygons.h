// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_POLYGONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_POLYGONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Closed polygons of the generators, one per component, and their common steps: even spacing of
// nodes along a finely sampled curve, and a random rotation.
using Polygon = std::vector<Vector>;
using Polygons = std::vector<Polygon>;

// Ratio by which the polygons along which nodes are spaced are finer, to look smooth.
constexpr std::size_t samples_per_node = 8;

template <typename Traits = Curve_flow_traits_3<>>
Curve_network_3<Traits> closed_network(const Polygons& polygons, const Traits& traits = Traits())
{
  return Curve_network_3<Traits>(polygons, parameters::closure(Closure::CLOSED), traits);
}

inline double perimeter(const Polygon& polygon)
{
  double length = 0;
  for(std::size_t i = 0, n = polygon.size(); i < n; ++i)
    length += (polygon[(i + 1) % n] - polygon[i]).norm();
  return length;
}

// returns n points on the polygon, equally spaced along it, from its first point on
inline Polygon equally_spaced(const Polygon& polygon, std::size_t n)
{
  const double spacing = perimeter(polygon) / static_cast<double>(n);
  Polygon result(1, polygon.front());
  double walked = 0;
  unsigned calls = 0;
  for(std::size_t i = 0; i < polygon.size() && result.size() < n; ++i) {
    check_run_sometimes(calls);
    const Vector &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double length = (b - a).norm();
    for(double next = static_cast<double>(result.size()) * spacing;
        next < walked + length && result.size() < n;
        next = static_cast<double>(result.size()) * spacing)
      result.push_back(a + (next - walked) / length * (b - a));
    walked += length;
  }
  return result;
}

/* returns polygons with `number_of_nodes` equally spaced nodes together, each component with a
 * share in proportion to its length.
 * \throws std::invalid_argument if this spaces them wider than `max_spacing`, where strands might
 * cut through each other
 */
inline Polygons equally_spaced(const Polygons& curves,
                               std::size_t number_of_nodes,
                               double max_spacing)
{
  std::vector<double> lengths;
  std::size_t needed = 0;
  for(const Polygon& curve : curves) {
    lengths.push_back(perimeter(curve));
    needed += 3 + static_cast<std::size_t>(lengths.back() / max_spacing);
  }
  if(number_of_nodes < needed)
    throw std::invalid_argument("this curve needs at least " + std::to_string(needed) +
                                " nodes, not " + std::to_string(number_of_nodes));
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.);
  const double to_share = static_cast<double>(number_of_nodes - 3 * curves.size());
  Polygons result;
  double length = 0;
  std::size_t given = 0;
  for(std::size_t c = 0; c < curves.size(); ++c) {
    length += lengths[c];
    const bool is_last = c + 1 == curves.size();
    const std::size_t end = is_last ? number_of_nodes - 3 * curves.size()
                                    : static_cast<std::size_t>(to_share * (length / total));
    result.push_back(equally_spaced(curves[c], 3 + end - given));
    given = end;
  }
  return result;
}

// Seed 0 leaves the curve as it is, another seed turns it by a random rotation (Shoemake 1992).
inline void turn_randomly(Polygons& polygons, std::uint64_t seed)
{
  if(seed == 0) return;
  Random_source random(seed);
  const double share = random.real();
  const auto [a, b] = cos_sin(random.real());
  const auto [c, d] = cos_sin(random.real());
  const double p = std::sqrt(share), q = std::sqrt(1 - share);
  const Frame rotation = frame_of_quaternion(p * a, p * b, q * c, q * d);
  for(Polygon& polygon : polygons)
    for(Vector& v : polygon) v = rotation(v);
}

// Returns a regular polygon in the plane z = 0 around the origin.
// \throws std::invalid_argument for fewer than 3 nodes, or a radius below 1e-150 or beyond 1e150
inline Polygon regular_polygon(std::size_t number_of_nodes, double radius)
{
  if(number_of_nodes < 3) throw std::invalid_argument("a polygon needs at least 3 nodes");
  if(!(radius >= min_extent && radius <= max_coordinate))
    throw std::invalid_argument("the radius of a polygon must be between 1e-150 and 1e150");
  Polygon polygon;
  for(std::size_t k = 0; k < number_of_nodes; ++k) {
    const auto [x, y] = cos_sin(static_cast<double>(k) / static_cast<double>(number_of_nodes));
    polygon.push_back({radius * x, radius * y, 0});
  }
  return polygon;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_POLYGONS_H
