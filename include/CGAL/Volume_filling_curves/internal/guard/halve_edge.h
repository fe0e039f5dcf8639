// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_HALVE_EDGE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_HALVE_EDGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Inserts a node in the middle of an edge, and returns whether this was certified; the middle is
// rounded, hence not on the edge.
template <typename Guard>
bool halve_edge(Guard& guard, std::size_t e)
{
  const auto& curve = guard.curve();
  const Vector a = to_vector(curve.point(curve.source(e)));
  const Vector b = to_vector(curve.point(curve.target(e)));
  return guard.insert_node(e, to_point(Vector((a + b) / 2), curve.traits()));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GUARD_HALVE_EDGE_H
