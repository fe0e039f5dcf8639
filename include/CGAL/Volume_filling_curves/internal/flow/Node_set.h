// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_NODE_SET_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_NODE_SET_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Set in which a node may move, near its present position: its tangent there, and the nearest point
// of the set to a target. The guard moves nodes on straight segments, and may shorten these; hence
// targets are projected in each step, not only directions, and nodes do not drift away. On lines
// and planes the deviation is the rounding of coordinates; near a bent boundary, a node that moves
// by s deviates by s^2 / (8 rho) at most where the radius of curvature is rho, until its next step.
template <typename Network, typename Boundary>
class Node_set
{
public:
  // The boundary must have a domain if the node slides along it.
  Node_set(const Network& curve, const Boundary& boundary, std::size_t v)
      : m_curve(curve),
        m_boundary(boundary),
        m_constraint(curve.constraint(v)),
        m_position(to_vector(curve.point(v))),
        m_axis(m_constraint.axis()[0], m_constraint.axis()[1], m_constraint.axis()[2])
  {
    if constexpr(Boundary::is_bounded)
      if(kind() == Kind::BOUNDARY) find_ascent();
  }

  // the component of a vector along the set
  Vector tangential(const Vector& u) const
  {
    switch(kind()) {
    case Kind::FREE:
      return u;
    case Kind::FIXED:
      return Vector();
    case Kind::LINE:
      return u.dot(m_axis) * m_axis;
    default:
      return u - u.dot(m_axis) * m_axis;
    }
  }

  // the point of the set that is nearest to a target near the node
  Vector nearest(const Vector& target) const
  {
    if(kind() == Kind::FREE) return target;
    if(kind() == Kind::FIXED) return m_position;
    if(kind() == Kind::BOUNDARY) return at_depth(target);
    const Vector origin(m_constraint.point()[0], m_constraint.point()[1], m_constraint.point()[2]);
    const Vector offset = target - origin;
    const Vector along = tangential(offset);
    return kind() == Kind::LINE ? origin + along : target - (offset - along);
  }

private:
  using Kind = Node_constraint::Kind;

  static constexpr double min_slope = 0.25; // of the depth; less is halfway between two walls
  static constexpr int max_steps = 4;       // of Newton's method, exact after one along a plane

  Kind kind() const { return m_constraint.kind(); }

  // Over a step of half of the depth, differences also have a direction next to edges of a mesh.
  void find_ascent()
  {
    const auto& domain = m_boundary.domain();
    const double depth = domain.distance(to_point(m_position, m_curve.traits()));
    const double step = (std::min)(m_constraint.distance(), depth) / 2;
    if(!(step > 0)) return;
    const bool has_height = !Space_of<std::decay_t<decltype(domain)>>::is_plane;
    const Vector slope =
        depth_differences(domain, m_position, step, {true, true, has_height}, m_curve.traits()) /
        (2 * step);
    if(slope.norm() < min_slope) return;
    m_axis = slope.normalized();
    m_ascent = slope / slope.squaredNorm();
  }

  Vector at_depth([[maybe_unused]] Vector x) const
  {
    if constexpr(Boundary::is_bounded)
      for(int k = 0; k < max_steps; ++k) {
        const double missing =
            m_constraint.distance() - depth(m_boundary.domain(), to_point(x, m_curve.traits()));
        if(missing == 0) break;
        x += missing * m_ascent;
      }
    return x;
  }

  const Network& m_curve;
  const Boundary& m_boundary;
  const Node_constraint& m_constraint;
  const Vector m_position;
  Vector m_axis;   // of the line, or normal; zero if there is none
  Vector m_ascent; // displacement per depth gained
};

// Moves the targets of constrained nodes to their sets.
template <typename Network, typename Boundary>
void project_targets(const Network& curve, const Boundary& boundary, Vector_field& targets)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(!curve.is_free(v))
      set_row(targets, v, Node_set(curve, boundary, v).nearest(row(targets, v)));
}

// \throws std::invalid_argument if a node slides along the boundary, and there is none
template <typename Boundary, typename Network>
void check_constraints(const Network& curve)
{
  if(Boundary::is_bounded) return;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.constraint(v).kind() == Node_constraint::Kind::BOUNDARY)
      throw std::invalid_argument("node " + std::to_string(v) +
                                  " slides along the boundary, but there is no domain");
}

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_NODE_SET_H
