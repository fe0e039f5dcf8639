// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Frame.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/cos_sin.h>
#include <CGAL/Volume_filling_curves/internal/measures/Crossing_counter.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The mean number of crossings over 100 directions that are spread evenly over the half-sphere: a
// Fibonacci lattice (each direction a golden angle further around the axis), turned once so that no
// direction is special for curves on a lattice. Fixed directions make the number reproducible; its
// sampling error is about 1 %.

constexpr std::size_t number_of_viewing_directions = 100;

// returns a rotation whose third row is the k-th direction
inline Frame viewing_frame(std::size_t k)
{
  constexpr double golden_angle = 0.38196601125010515; // in turns
  const double index = static_cast<double>(k);
  const double z = (index + 0.5) / static_cast<double>(number_of_viewing_directions);
  const double radius = std::sqrt(1 - z * z);
  const auto [x, y] = cos_sin(golden_angle * index);
  const Vector front = generic_frame()(Vector(radius * x, radius * y, z));
  const Vector right = front.unitOrthogonal();
  return {right, front.cross(right), front};
}

// With a stride k of every k-th direction only.
template <typename Network>
double average_crossing_number(const Network& curve, std::size_t stride = 1)
{
  const Vector_field points = coordinates(curve);
  std::vector<Vector> projection(curve.number_of_nodes());
  Crossing_counter count(curve);
  std::size_t crossings = 0, directions = 0;
  for(std::size_t k = 0; k < number_of_viewing_directions; k += stride, ++directions) {
    const Frame frame = viewing_frame(k);
    for(std::size_t v = 0; v < projection.size(); ++v) {
      const Vector x = row(points, v);
      projection[v] = {frame.first.dot(x), frame.second.dot(x), 0};
    }
    crossings += count(projection);
  }
  return static_cast<double>(crossings) / static_cast<double>(directions);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H
