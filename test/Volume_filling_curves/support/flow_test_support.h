// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_FLOW_TEST_SUPPORT_H
#define VFC_TEST_FLOW_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_sphere_search.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Curves for tests of the flow, and the quantities of the flow that most tests start from.
namespace flow_test {

namespace internal = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::Curve_network_3;
using internal::Polygon;
using internal::Polygons;
using internal::Vector;
using internal::Vector_field;
using Network = Curve_network_3<>;
using Edges = std::vector<std::array<std::size_t, 2>>;
using Random = std::mt19937;

inline double between(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vector random_point(Random& random)
{
  const double x = between(-1, 1, random), y = between(-1, 1, random);
  return {x, y, between(-1, 1, random)};
}

inline Vector_field random_field(std::size_t n, Random& random)
{
  Vector_field field(static_cast<Eigen::Index>(n), 3);
  for(Eigen::Index v = 0; v < field.rows(); ++v) internal::set_row(field, v, random_point(random));
  return field;
}

inline Polygon random_polygon(std::size_t n, Random& random)
{
  Polygon polygon;
  for(std::size_t k = 0; k < n; ++k) polygon.push_back(random_point(random));
  return polygon;
}

inline Polygon circle(std::size_t n, double radius = 1, const Vector& center = Vector())
{
  Polygon polygon;
  for(std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(n);
    polygon.push_back(center + radius * Vector(std::cos(angle), std::sin(angle), 0));
  }
  return polygon;
}

inline Network network_of(const std::vector<Vector>& points, const Edges& edges)
{
  std::vector<Network::Point_3> kernel_points;
  for(const Vector& p : points) kernel_points.emplace_back(p.x(), p.y(), p.z());
  return Network(kernel_points, edges);
}

// an open curve through the points
inline Network path(const std::vector<Vector>& points)
{
  Edges edges;
  for(std::size_t v = 1; v < points.size(); ++v) edges.push_back({v - 1, v});
  return network_of(points, edges);
}

// A ring of n nodes with a ray, a star of three arms, and a path that doubles back on itself.
inline Network junctions_and_ends(std::size_t n, Random& random)
{
  std::vector<Vector> points = random_polygon(n + 10, random);
  Edges edges;
  for(std::size_t v = 0; v < n; ++v) edges.push_back({v, (v + 1) % n});
  const Edges others = {{0, 1}, {1, 2}, {3, 4}, {3, 5}, {3, 6}, {7, 8}, {8, 9}};
  for(const auto& [a, b] : others) edges.push_back({n + a, n + b});
  edges.push_back({0, n});
  points[n + 9] = points[n + 7] + Vector(0, 0, 0.01); // a spike at n + 8
  return network_of(points, edges);
}

// The cap of the radii is in units of the thickness, which is the same at all nodes.
inline internal::Medial_spheres spheres_of(const Network& curve,
                                           std::size_t number_of_directions,
                                           double max_radius,
                                           double thickness = 1)
{
  const Vector_field x = internal::coordinates(curve);
  const std::vector<double> thicknesses(curve.number_of_nodes(), thickness);
  return internal::Medial_sphere_search(CGAL::Sequential_tag(), x, thicknesses, max_radius)(
      internal::node_circles(curve, x), number_of_directions);
}

inline Vector product(const Eigen::Matrix3d& matrix, const Vector& v)
{
  return internal::to_vector(Eigen::Vector3d(matrix * Eigen::Vector3d(v.x(), v.y(), v.z())));
}

// The curve after x -> scale * (matrix * x) + shift.
template <typename Network>
Network transformed(const Network& curve,
                    double scale,
                    const Eigen::Matrix3d& matrix = Eigen::Matrix3d::Identity(),
                    const Vector& shift = Vector())
{
  std::vector<typename Network::Point_3> points;
  Edges edges;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const Vector p = scale * product(matrix, internal::to_vector(curve.point(v))) + shift;
    points.push_back(internal::to_point(p, curve.traits()));
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    edges.push_back({curve.source(e), curve.target(e)});
  Network result(points, edges, curve.traits());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    result.set_pinned(v, curve.is_pinned(result.origin(v)));
  return result;
}

} // namespace flow_test

#endif // VFC_TEST_FLOW_TEST_SUPPORT_H
