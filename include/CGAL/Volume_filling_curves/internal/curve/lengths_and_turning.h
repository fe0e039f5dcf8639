// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_LENGTHS_AND_TURNING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_LENGTHS_AND_TURNING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/bending.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lengths of curves, summed in a fixed order, which makes all callers get the same bits. Linear
// time.

template <typename Network>
std::vector<double> lengths_of_components(const Network& curve)
{
  std::vector<double> lengths(curve.number_of_components(), 0);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    lengths[curve.component(curve.source(e))] += edge_vector(curve, e).norm();
  return lengths;
}

template <typename Network>
double total_length(const Network& curve)
{
  double sum = 0;
  for(double component_length : lengths_of_components(curve)) sum += component_length;
  return sum;
}

// returns the length of all edges, each in units of the mean of the values at its ends
template <typename Network>
double length_in_units(const Network& curve, const std::vector<double>& values)
{
  double length = 0;
  for(const std::size_t e : curve.edges())
    length +=
        2 * edge_vector(curve, e).norm() / (values[curve.source(e)] + values[curve.target(e)]);
  return length;
}

// Turning angles of a curve at its nodes, in radians, and bend radii. Linear.

// The sum of the turning angles at the nodes inside component c; 0 if it has a junction.
template <typename Network>
double total_curvature(const Network& curve, std::size_t c)
{
  double sum = 0;
  for_each_corner(curve, c,
                  [&](const Vector& in, const Vector& out) { sum += turning_angle(in, out); });
  return sum;
}

// The reciprocal of the bend radius at each node; 0 at ends and junctions. All are finite: a fold
// has the largest number.
template <typename Network>
std::vector<double> node_curvatures(const Network& curve)
{
  std::vector<double> curvatures(curve.number_of_nodes(), 0.);
  for(const std::size_t v : curve.nodes()) {
    if(curve.degree(v) != 2) continue;
    const Vector p = to_vector(curve.point(v));
    const double radius = bend_radius(p - to_vector(curve.point(curve.neighbor(v, 0))),
                                      to_vector(curve.point(curve.neighbor(v, 1))) - p);
    curvatures[v] = (std::min)(1 / radius, (std::numeric_limits<double>::max)());
  }
  return curvatures;
}

// A corner of a curve, infinitely round if there is none.
struct Corner
{
  double bend_radius = std::numeric_limits<double>::infinity();
  std::size_t node = static_cast<std::size_t>(-1);
};

// The corner with the least bend radius in components without junctions, the first one of several.
template <typename Network>
Corner tightest_corner(const Network& curve)
{
  Corner tightest;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    const std::vector<std::size_t> edges = edges_along(curve, c);
    const auto take = [&](std::size_t in, std::size_t out) {
      const double radius = bend_radius(edge_vector(curve, in), edge_vector(curve, out));
      if(radius < tightest.bend_radius) tightest = {radius, curve.source(out)};
    };
    for(std::size_t i = 1; i < edges.size(); ++i) take(edges[i - 1], edges[i]);
    if(curve.is_closed(c)) take(edges.back(), edges.front());
  }
  return tightest;
}

// The least bend radius at a node of a component without junctions; infinity if all are straight.
template <typename Network>
double min_bend_radius(const Network& curve)
{
  return tightest_corner(curve).bend_radius;
}

// The largest turning angle at a node of a closed component.
template <typename Network>
double max_turning_angle(const Network& curve)
{
  double largest = 0;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(curve.is_closed(c))
      for_each_corner(curve, c, [&](const Vector& in, const Vector& out) {
        largest = (std::max)(largest, turning_angle(in, out));
      });
  return largest;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_LENGTHS_AND_TURNING_H
