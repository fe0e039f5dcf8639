// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_RANDOM_SOURCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_RANDOM_SOURCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Random numbers that are the same on every platform, unlike the distributions of the standard
// library: splitmix64 (Steele, Lea, Flood 2014), and distributions computed by IEEE operations.
class Random_source
{
public:
  explicit Random_source(std::uint64_t seed) : m_state(seed) {}

  std::uint64_t bits()
  {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // uniform in [0, 1), a multiple of 2^-53
  double real() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  // uniform in 0, ..., n - 1; the bias for n < 2^32 is below 2^-32
  std::size_t index(std::size_t n) { return static_cast<std::size_t>(bits() % n); }

  // uniform on the unit sphere: height and longitude are independent (Archimedes)
  Vector direction()
  {
    const double z = 2 * real() - 1, radius = std::sqrt(1 - z * z);
    const auto [x, y] = cos_sin(real());
    return {radius * x, radius * y, z};
  }

private:
  std::uint64_t m_state;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_RANDOM_SOURCE_H
