// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOTAL_LENGTH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOTAL_LENGTH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lengths of curves, summed in one order everywhere, so that they have the same bits wherever they
// are computed. Linear time.

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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_TOTAL_LENGTH_H
