// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_SHAPE_TEST_SUPPORT_H
#define VFC_TEST_SHAPE_TEST_SUPPORT_H

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Curves whose shapes are known.
namespace shape_test {

using namespace fill_test;
namespace internal = VFC::internal;
using internal::Shape_check;
using internal::Shape_goal;
using internal::Shape_limits;
using internal::Strand_pairs;
using internal::Strand_paths;
using internal::Vector;

constexpr CGAL::Sequential_tag sequential{};

inline std::vector<Point> ring(std::size_t n, double radius, const Vector& center = Vector())
{
  std::vector<Point> points;
  for(std::size_t k = 0; k <= n; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k % n) / static_cast<double>(n);
    points.emplace_back(center.x() + radius * std::cos(angle),
                        center.y() + radius * std::sin(angle), center.z());
  }
  return points;
}

inline std::vector<Point> segment(std::size_t n, const Vector& a, const Vector& b)
{
  std::vector<Point> points;
  for(std::size_t k = 0; k <= n; ++k) {
    const Vector x = a + static_cast<double>(k) / static_cast<double>(n) * (b - a);
    points.emplace_back(x.x(), x.y(), x.z());
  }
  return points;
}

inline Curve curve_of(const std::vector<std::vector<Point>>& polylines)
{
  return Curve(polylines);
}

inline Shape_limits limits(const Curve& curve, double bend_radius, double strand_distance)
{
  Shape_goal goal;
  goal.bend_radius.length = bend_radius;
  goal.strand_distance.length = strand_distance;
  return Shape_limits(curve, goal, std::vector<double>(curve.number_of_nodes(), 1));
}

inline std::vector<Vector> positions(const Curve& curve)
{
  std::vector<Vector> x;
  for(const Point& p : curve.points()) x.push_back(internal::to_vector(p));
  return x;
}

inline Shape_check check(const Curve& curve, double bend_radius, double strand_distance)
{
  return Shape_check(sequential, curve, limits(curve, bend_radius, strand_distance));
}

} // namespace shape_test

#endif // VFC_TEST_SHAPE_TEST_SUPPORT_H
