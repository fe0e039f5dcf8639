// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_TORUS_KNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_TORUS_KNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

/* returns the torus knot T(p, q), a link of gcd(p, q) components if that is not 1: on a torus with
 * the radii 2 and 1 it runs p times around the axis and |q| times around the core. Its crossings
 * are positive if q is, so that T(2, 3) is the right-handed trefoil and T(2, -3) the left-handed
 * one.
 * \throws std::invalid_argument if p < 1 or q = 0, if p or |q| exceeds 10,000, or if the nodes are
 * too few for the knot
 */
inline Polygons torus_knot(int p, int q, std::size_t number_of_nodes, std::uint64_t seed = 0)
{
  if(p < 1 || q == 0) throw std::invalid_argument("a torus knot needs p > 0 and q other than 0");
  constexpr int most = 10000; // such a knot needs hundreds of millions of nodes
  if(p > most || q > most || q < -most)
    throw std::invalid_argument("p and |q| of a torus knot are at most " + std::to_string(most));
  constexpr double core_radius = 2, tube_radius = 1;
  constexpr std::size_t samples_per_turn = 96;
  const int components = std::gcd(p, q), turns = p / components;
  const std::size_t samples =
      (std::max)(samples_per_turn * static_cast<std::size_t>(turns + std::abs(q) / components),
                 samples_per_node * (number_of_nodes / static_cast<std::size_t>(components)));
  Polygons curves(static_cast<std::size_t>(components));
  unsigned calls = 0;
  for(std::size_t c = 0; c < curves.size(); ++c)
    for(std::size_t i = 0; i < samples; ++i) {
      check_run_sometimes(calls);
      const double t = static_cast<double>(i) / static_cast<double>(samples);
      const double shift = static_cast<double>(c) / p; // of the strands around the core
      const auto [x, y] = cos_sin(turns * t);
      const auto [u, v] = cos_sin(q / components * t + shift);
      const double radius = core_radius + tube_radius * u;
      curves[c].push_back({radius * x, radius * y, -tube_radius * v});
    }
  // parallel strands are this far apart where the torus is narrowest
  const double across = p / tube_radius, along = q / (core_radius - tube_radius);
  const double strand_distance = 2 * CGAL_PI / std::sqrt(across * across + along * along);
  Polygons result = equally_spaced(curves, number_of_nodes, 0.75 * strand_distance);
  turn_randomly(result, seed);
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_TORUS_KNOT_H
