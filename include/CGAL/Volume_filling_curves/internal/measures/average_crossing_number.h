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
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <numeric>
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
template <typename ConcurrencyTag = Sequential_tag, typename Network>
double average_crossing_number(const Network& curve,
                               std::size_t stride = 1,
                               Run_watch* watch = nullptr)
{
  constexpr std::size_t block = 10; // directions that share the memory of a counter
  const Vector_field points = coordinates(curve);
  std::vector<std::size_t> crossings((number_of_viewing_directions + stride - 1) / stride);
  for_each_block<ConcurrencyTag>(crossings.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<Vector> projection(curve.number_of_nodes());
    Crossing_counter count(curve);
    for(std::size_t k = begin; k < end; ++k) {
      const Frame frame = viewing_frame(k * stride);
      for(std::size_t v = 0; v < projection.size(); ++v) {
        const Vector x = row(points, v);
        projection[v] = {frame.first.dot(x), frame.second.dot(x), 0};
      }
      crossings[k] = count(projection, watch);
    }
  });
  return static_cast<double>(std::accumulate(crossings.begin(), crossings.end(), std::size_t(0))) /
         static_cast<double>(crossings.size());
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_AVERAGE_CROSSING_NUMBER_H
