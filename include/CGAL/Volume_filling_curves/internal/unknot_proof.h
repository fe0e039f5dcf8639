// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNKNOT_PROOF_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNKNOT_PROOF_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_result.h>
#include <CGAL/Volume_filling_curves/internal/Vector.h>
#include <CGAL/Volume_filling_curves/internal/bending.h>
#include <CGAL/Volume_filling_curves/internal/strands.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The sum of the turning angles at the nodes of closed component c.
template <typename Network>
double total_curvature(const Network& curve, std::size_t c)
{
  const std::size_t begin = curve.first_node(c), n = curve.first_node(c + 1) - begin;
  const auto position = [&](std::size_t k) { return to_vector(curve.point(begin + k % n)); };
  Vector in = position(0) - position(n - 1);
  double sum = 0;
  for(std::size_t k = 0; k < n; ++k) {
    const Vector out = position(k + 1) - position(k);
    sum += turning_angle(in, out);
    in = out;
  }
  return sum;
}

// The largest turning angle at a node of a closed component.
template <typename Network>
double largest_turning_angle(const Network& curve)
{
  double largest = 0;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(curve.is_closed(c))
      for_each_corner(curve, c, [&](const Vector& in, const Vector& out) {
        largest = (std::max)(largest, turning_angle(in, out));
      });
  return largest;
}

// Why component c is known to be an unknot: a knot has at least 6 edges (Randell 1994) and a total
// curvature above 4 pi (Fary 1949, Milnor 1950). Linear.
template <typename Network>
Unknot_proof unknot_proof(const Network& curve, std::size_t c)
{
  constexpr std::size_t edges_of_unknots = 5;
  // 4 pi is the infimum for the trefoil; the margin is far above the rounding of a sum of angles
  constexpr double unknotted_curvature = 4 * CGAL_PI - 1e-6;
  if(!curve.is_closed(c)) return Unknot_proof::NONE;
  if(curve.first_node(c + 1) - curve.first_node(c) <= edges_of_unknots) return Unknot_proof::EDGES;
  return total_curvature(curve, c) < unknotted_curvature ? Unknot_proof::TOTAL_CURVATURE
                                                         : Unknot_proof::NONE;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNKNOT_PROOF_H
