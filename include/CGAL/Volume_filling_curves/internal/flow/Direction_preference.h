// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_PREFERENCE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_PREFERENCE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Field_vector.h>

#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Direction of a field at a point, as a unit vector, or zero if there is no preference. Throws
// std::invalid_argument, with the point in the message, if the field is not finite.
template <typename Field, typename Point_3>
Vector unit_direction(const Field& field, const Point_3& p)
{
  const Field_vector given = field(p);
  const Vector v(given[0], given[1], given[2]);
  if(!v.allFinite())
    throw std::invalid_argument("direction_field is not finite at " + point_text(p));
  const double size = v.cwiseAbs().maxCoeff(); // squares must neither overflow nor underflow
  return size > 0 ? (v / size).normalized() : Vector();
}

// Energy of edges in a direction field: an edge of length L at the angle phi to the field costs an
// additional w L sin^2(phi). For an edge e and a unit vector d this is w (|e| - (e . d)^2 / |e|);
// with t = e / |e| and c = t . d, its gradient by e is w ((1 + c^2) t - 2 c d), and the largest
// eigenvalue of its Hessian is w (1 + c^2) / |e|. Directions are held fixed, like the centers of
// medial spheres. For d = 0 all terms are 0.
struct Direction_preference
{
  Vector_field directions; // of unit length, or zero; per edge
  double weight = 0;       // w

  Vector pull(std::size_t e, const Vector& t) const
  {
    const Vector d = row(directions, e);
    const double c = t.dot(d);
    return weight * ((d.squaredNorm() + c * c) * t - 2 * c * d);
  }

  // The largest eigenvalue of the Hessian, for an edge that is the vector v.
  double stiffness(std::size_t e, const Vector& v) const
  {
    const Vector d = row(directions, e);
    const double c = v.normalized().dot(d);
    return weight * (d.squaredNorm() + c * c) / v.norm();
  }
};

// The directions at the middles of the edges. Throws std::invalid_argument if one is not finite.
template <typename Network, typename Field>
Vector_field edge_directions(const Network& curve, const Field& field)
{
  Vector_field directions(static_cast<Eigen::Index>(curve.number_of_edges()), 3);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const Vector a = to_vector(curve.point(curve.source(e)));
    const Vector b = to_vector(curve.point(curve.target(e)));
    set_row(directions, e, unit_direction(field, to_point((a + b) / 2, curve.traits())));
  }
  return directions;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_PREFERENCE_H
