// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_MAY_BE_UNKNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_MAY_BE_UNKNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Alexander_matrix.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>

#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Arguments modulo the largest prime below 2^31; no roots of unity of small order.
inline constexpr std::uint64_t alexander_arguments[] = {1234567, 271828182};

// Returns whether a knot seems to have the Alexander polynomial of the unknot, by its values at two
// points of a prime field. If not, the knot is proved knotted; otherwise nothing is proved,
// although no nontrivial knot of up to 10 crossings has this polynomial.
// \throws Run_stopped if a watch requests it
inline bool has_trivial_alexander_polynomial(const Planar_diagram& diagram,
                                             Run_watch* watch = nullptr)
{
  const Alexander_matrix matrix(diagram, watch);
  const Prime_field field;
  for(const std::uint64_t t : alexander_arguments)
    if(matrix.squared_norm(t, field) != 1) return false;
  return true;
}

// Returns whether the Alexander polynomial of a knot is that of the unknot, as far as two values
// show. Returns false for very large curves, whose polynomial would take longer than a second.
// \pre the curve is a single closed component, and has no garbage
template <typename Network>
bool may_be_unknot(const Network& curve)
{
  constexpr std::size_t max_nodes = 10000, max_crossings = 1000;
  if(curve.number_of_nodes() > max_nodes) return false;
  const Planar_diagram diagram = best_diagram(closed_polygons(curve), 1);
  return diagram.crossings.size() <= max_crossings && has_trivial_alexander_polynomial(diagram);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_MAY_BE_UNKNOT_H
