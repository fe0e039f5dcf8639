// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Geometry that decides nothing is done in double with these types; the exact predicates of the
// traits see only points.
using Vector = Eigen::Vector3d;

// One vector per node, x, y, z next to each other.
using Vector_field = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

template <typename Point_3>
Vector to_vector(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

template <typename Traits>
typename Traits::Point_3 to_point(const Vector& v, const Traits& traits)
{
  return traits.construct_point_3_object()(v.x(), v.y(), v.z());
}

template <typename Network>
Vector_field coordinates(const Network& curve)
{
  Vector_field x(static_cast<Eigen::Index>(curve.number_of_nodes()), 3);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    x.row(static_cast<Eigen::Index>(v)) = to_vector(curve.point(v)).transpose();
  return x;
}

// The power of two that scales the curve to a size of about 1, so that products of lengths neither
// overflow nor underflow. Scaling by it is exact.
template <typename Network>
double unit_of_size(const Network& curve)
{
  if(curve.number_of_nodes() == 0) return 1;
  const Vector_field x = coordinates(curve);
  const double size = (x.colwise().maxCoeff() - x.colwise().minCoeff()).maxCoeff();
  return size > 0 && std::isfinite(size) ? std::ldexp(1., -std::ilogb(size)) : 1;
}

inline Vector row(const Vector_field& field, std::size_t v)
{
  return field.row(static_cast<Eigen::Index>(v)).transpose();
}

// The mean of the rows. Eigen's adds them in an order that depends on where in memory the result
// lies, so that compilers differ in the last bits.
// \pre there is a row
inline Vector centroid(const Vector_field& x)
{
  Vector sum = Vector::Zero();
  for(Eigen::Index v = 0; v < x.rows(); ++v) sum += x.row(v).transpose();
  return sum / static_cast<double>(x.rows());
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_H
