// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_HELD_COMPONENTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_HELD_COMPONENTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Point, line or plane that holds a node: a point of it, and its directions.
struct Node_hold
{
  Vector point;
  std::vector<Vector> directions;
};

inline Node_hold node_hold(const Node_constraint& constraint, const Vector& position)
{
  const auto as_vector = [](const std::array<double, 3>& x) { return Vector(x[0], x[1], x[2]); };
  const Vector axis = as_vector(constraint.axis());
  switch(constraint.kind()) {
  case Node_constraint::Kind::LINE:
    return {as_vector(constraint.point()), {axis}};
  case Node_constraint::Kind::PLANE: {
    const Vector u = axis.unitOrthogonal();
    return {as_vector(constraint.point()), {u, axis.cross(u)}};
  }
  default:
    return {position, {}};
  }
}

// The distance between two of them: the part of an offset that is orthogonal to the directions of
// both (Gram and Schmidt).
inline double distance(const Node_hold& a, const Node_hold& b)
{
  constexpr double parallel = 1e-6; // sine of the angle of directions that count as one
  std::vector<Vector> basis;
  const auto orthogonal_part = [&](Vector x) {
    for(const Vector& u : basis) x -= x.dot(u) * u;
    return x;
  };
  for(const Node_hold* hold : {&a, &b})
    for(const Vector& direction : hold->directions) {
      const Vector u = orthogonal_part(direction);
      if(u.norm() > parallel) basis.push_back(u.normalized());
    }
  return orthogonal_part(a.point - b.point).norm();
}

// Whether a component cannot vanish: two of its nodes are held at a distance, in units of the
// thickness, as the ends of an arc between two plates are. A node that slides along a boundary
// holds nothing, since it may slide to any other node. Linear in the number of nodes times that of
// the sets in which they slide.
template <typename Network>
bool is_held(const Network& curve,
             std::size_t component,
             const Vector_field& x,
             const std::vector<double>& thickness)
{
  constexpr double rounding = 1e-6; // in units of the thickness
  std::vector<Node_constraint> known;
  std::vector<Node_hold> holds;
  for(std::size_t v = curve.first_node(component); v < curve.first_node(component + 1); ++v) {
    const Node_constraint& constraint = curve.constraint(v);
    if(curve.is_free(v) || constraint.kind() == Node_constraint::Kind::BOUNDARY) continue;
    const bool is_known = std::find(known.begin(), known.end(), constraint) != known.end();
    if(is_known && !curve.is_pinned(v)) continue;
    const Node_hold hold = node_hold(constraint, row(x, v));
    for(const Node_hold& other : holds)
      if(distance(hold, other) > rounding * thickness[v]) return true;
    known.push_back(constraint);
    holds.push_back(hold);
  }
  return false;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_HELD_COMPONENTS_H
