// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOF_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOF_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// largest number of edges with which every closed polygon is an unknot (Randell 1994)
inline constexpr std::size_t edges_of_unknots = 5;

// Proof that component c is an unknot, if it is too simple for a knot, which has at least 6 edges
// (Randell 1994) and a total curvature above 4 pi (Fary 1949, Milnor 1950). Linear.
template <typename Network>
Unknot_proof unknot_proof(const Network& curve, std::size_t c)
{
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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOF_H
