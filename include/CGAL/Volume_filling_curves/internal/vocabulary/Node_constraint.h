// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_CONSTRAINT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_CONSTRAINT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief The class `Node_constraint` is the set in which a node of a `Curve_network_3` may move.
 *
 * A node is free, fixed (*pinned*), or slides on a line, on a plane, or inside a domain at a given
 * distance from its boundary. A flow moves the node along this set, and brings it there first if it
 * starts elsewhere. A node inserted between two sliding nodes with equal constraints, or between
 * one of these and a pinned node, gets this constraint, too; hence a curve in a plane stays in this
 * plane, whatever the remeshing. Other sliding nodes are never removed.
 *
 * Constraints are equal if they were constructed from equal values: the plane through another of
 * its points is another constraint, since rounding makes it another plane. To keep a curve in a
 * plane, give the same constraint to all of its nodes.
 */
class Node_constraint
{
public:
  /// a point or a vector; converted from points and vectors with members `x()`, `y()` and `z()`
  using Coordinates = internal::Field_vector;

  /// the kinds of sets
  enum class Kind : std::uint64_t // no padding, since states of runs copy constraints as bytes
  {
    FREE,    ///< the whole space, or the domain
    FIXED,   ///< the position of the node
    LINE,    ///< a line
    PLANE,   ///< a plane
    BOUNDARY ///< the points inside the domain at a distance from its boundary
  };

  /// constructs no constraint: the node is free.
  Node_constraint() = default;

  /// returns the constraint that keeps a node where it is.
  static Node_constraint fixed() { return Node_constraint(Kind::FIXED); }

  /// returns the constraint to a line.
  ///
  /// \throws std::invalid_argument if a coordinate is not finite, or `direction` is zero
  static Node_constraint on_line(const Coordinates& point, const Coordinates& direction)
  {
    return {Kind::LINE, point, direction};
  }

  /// returns the constraint to a plane.
  ///
  /// \throws std::invalid_argument if a coordinate is not finite, or `normal` is zero
  static Node_constraint on_plane(const Coordinates& point, const Coordinates& normal)
  {
    return {Kind::PLANE, point, normal};
  }

  /// returns the constraint to the points inside the domain at `distance` from its boundary. A flow
  /// without a domain refuses it.
  ///
  /// \throws std::invalid_argument if `distance` is not positive and finite
  static Node_constraint on_boundary(double distance)
  {
    if(!(distance > 0 && distance <= (std::numeric_limits<double>::max)()))
      throw std::invalid_argument("node constraint: the distance from the boundary is " +
                                  std::to_string(distance) + ", but must be positive and finite");
    Node_constraint constraint(Kind::BOUNDARY);
    constraint.m_distance = distance;
    return constraint;
  }

  /// returns the kind of the set.
  Kind kind() const { return m_kind; }

  /// returns whether the node is neither free nor fixed.
  bool is_sliding() const { return m_kind != Kind::FREE && m_kind != Kind::FIXED; }

  /// returns a point of the line or the plane.
  const std::array<double, 3>& point() const { return m_point; }

  /// returns the direction of the line, or the normal of the plane, of length 1.
  const std::array<double, 3>& axis() const { return m_axis; }

  /// returns the distance from the boundary.
  double distance() const { return m_distance; }

  /// returns the constraint in a space whose coordinates are multiplied by `factor`.
  /// \pre `factor` is positive
  Node_constraint scaled(double factor) const
  {
    Node_constraint result = *this;
    for(double& coordinate : result.m_point) coordinate *= factor;
    result.m_distance *= factor;
    return result;
  }

  /// returns whether both have the same kind, and were constructed from equal values.
  friend bool operator==(const Node_constraint& a, const Node_constraint& b)
  {
    return a.m_kind == b.m_kind && a.m_point == b.m_point && a.m_axis == b.m_axis &&
           a.m_distance == b.m_distance;
  }

  /// returns whether they are not equal.
  friend bool operator!=(const Node_constraint& a, const Node_constraint& b) { return !(a == b); }

private:
  explicit Node_constraint(Kind kind) : m_kind(kind) {}

  Node_constraint(Kind kind, const Coordinates& point, const Coordinates& axis)
      : m_kind(kind), m_point(point)
  {
    double largest = 0, squares = 0;
    for(const double a : axis) largest = (std::max)(largest, std::abs(a));
    for(const double a : axis) squares += (a / largest) * (a / largest);
    if(!(std::isfinite(squares) && std::isfinite(point[0]) && std::isfinite(point[1]) &&
         std::isfinite(point[2])))
      throw std::invalid_argument("node constraint: coordinates must be finite, and the direction "
                                  "of a line or the normal of a plane not zero");
    const double length = std::sqrt(squares);
    m_axis = {axis[0] / largest / length, axis[1] / largest / length, axis[2] / largest / length};
  }

  Kind m_kind = Kind::FREE;
  std::array<double, 3> m_point = {0, 0, 0}, m_axis = {0, 0, 0};
  double m_distance = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_CONSTRAINT_H
