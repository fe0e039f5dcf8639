// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_ELEMENTARY_OPERATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_ELEMENTARY_OPERATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Change of a curve that a guard is asked to make. Nodes have the guard's numbers: those of the
// network without garbage, followed by inserted nodes in their order.
struct Elementary_operation
{
  enum Kind : std::uint32_t
  {
    MOVE,
    INSERT,
    REMOVE
  };

  Kind kind;
  std::uint32_t node;   // MOVE, REMOVE: the node; INSERT: one end of the edge
  std::uint32_t second; // INSERT: the other end
  Vector position;      // MOVE, INSERT
};

// Carries out an operation if the guard certifies it, and returns whether it does.
template <typename Guard>
bool carry_out(Guard& guard, const Elementary_operation& operation)
{
  const auto& curve = guard.curve();
  const auto point = [&] { return to_point(operation.position, curve.traits()); };
  switch(operation.kind) {
  case Elementary_operation::MOVE:
    return guard.move_node(operation.node, point());
  case Elementary_operation::REMOVE:
    return guard.remove_node(operation.node);
  case Elementary_operation::INSERT:
    break;
  }
  for(std::size_t k = 0; k < curve.degree(operation.node); ++k)
    if(curve.neighbor(operation.node, k) == operation.second)
      return guard.insert_node(curve.incident_edge(operation.node, k), point());
  return false;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYGON_SEARCH_ELEMENTARY_OPERATION_H
