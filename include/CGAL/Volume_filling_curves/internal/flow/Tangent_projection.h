// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TANGENT_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TANGENT_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Orthogonal projection of a vector per node to the tangents of the sets in which nodes move, a
// symmetric 3n x 3n matrix T. The gradient g of the energy becomes T g, and the direction solves
// (T P T) d = -T g with d in the image of T. Linear in the number of constrained nodes.
class Tangent_projection
{
public:
  Tangent_projection() = default; // of free nodes

  template <typename Network, typename Boundary>
  Tangent_projection(const Network& curve, const Boundary& boundary)
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      if(curve.is_free(v)) continue;
      m_has_sliding_nodes |= !curve.is_pinned(v);
      const Node_set set(curve, boundary, v);
      m_tangents.push_back(
          {v, {set.tangential({1, 0, 0}), set.tangential({0, 1, 0}), set.tangential({0, 0, 1})}});
    }
  }

  bool has_sliding_nodes() const { return m_has_sliding_nodes; }

  void operator()(Vector_field& field) const
  {
    for(const auto& [v, columns] : m_tangents) {
      const Vector u = row(field, v);
      set_row(field, v, u.x() * columns[0] + u.y() * columns[1] + u.z() * columns[2]);
    }
  }

private:
  struct Tangent
  {
    std::size_t node;
    Vector columns[3]; // of the projection
  };

  std::vector<Tangent> m_tangents;
  bool m_has_sliding_nodes = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TANGENT_PROJECTION_H
