// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_FIELD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_FIELD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Field of vectors, one per node, with x, y and z adjacent in memory.
using Vector_field = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

template <typename Index>
Vector row(const Vector_field& field, Index v)
{
  const auto i = static_cast<Eigen::Index>(v);
  return {field(i, 0), field(i, 1), field(i, 2)};
}

template <typename Index>
void set_row(Vector_field& field, Index v, const Vector& x)
{
  const auto i = static_cast<Eigen::Index>(v);
  field(i, 0) = x.x();
  field(i, 1) = x.y();
  field(i, 2) = x.z();
}

template <typename Network>
Vector_field coordinates(const Network& curve)
{
  Vector_field x(static_cast<Eigen::Index>(curve.number_of_nodes()), 3);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) set_row(x, v, to_vector(curve.point(v)));
  return x;
}

// Sums over the rows, one after another. Eigen's reductions add in packets, even within a row, and
// so their last bits depend on the processor and on the compiler's flags; five of twenty flows came
// out with other nodes where Eigen did not vectorize.
inline double dot(const Vector_field& a, const Vector_field& b)
{
  double sum = 0;
  for(Eigen::Index v = 0; v < a.rows(); ++v) sum += row(a, v).dot(row(b, v));
  return sum;
}

inline double sum_of_norms(const Vector_field& x)
{
  double sum = 0;
  for(Eigen::Index v = 0; v < x.rows(); ++v) sum += row(x, v).norm();
  return sum;
}

// The mean of the rows. Eigen's adds them in an order that depends on where in memory the result
// lies, so that compilers differ in the last bits.
// \pre there is a row
inline Vector centroid(const Vector_field& x)
{
  Vector sum;
  for(Eigen::Index v = 0; v < x.rows(); ++v) sum += row(x, v);
  return sum / static_cast<double>(x.rows());
}

// The sides of the box around the rows.
// \pre there is a row
inline Vector sides(const Vector_field& x)
{
  Vector low = row(x, 0), high = low;
  for(Eigen::Index v = 1; v < x.rows(); ++v) {
    low = low.cwiseMin(row(x, v));
    high = high.cwiseMax(row(x, v));
  }
  return high - low;
}

// The power of two that scales the curve to a size of about 1, whereby products of lengths neither
// overflow nor underflow. Scaling by it is exact.
template <typename Network>
double unit_of_size(const Network& curve)
{
  if(curve.number_of_nodes() == 0) return 1;
  const double size = sides(coordinates(curve)).maxCoeff();
  return size > 0 && std::isfinite(size) ? scale_to_one(size) : 1;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_VECTOR_FIELD_H
