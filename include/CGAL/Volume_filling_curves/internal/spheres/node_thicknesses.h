// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_THICKNESSES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_THICKNESSES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/thickness_at.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The thickness at each node: what a field says there, or else the same everywhere. Throws
// std::invalid_argument if the field does not make sense.
template <typename Network, typename Field>
std::vector<double> node_thicknesses(const Network& curve, double thickness, const Field& field)
{
  std::vector<double> result(curve.number_of_nodes(), thickness);
  if(!field) return result;
  for(std::size_t v = 0; v < result.size(); ++v) result[v] = thickness_at(field, curve.point(v));
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_THICKNESSES_H
