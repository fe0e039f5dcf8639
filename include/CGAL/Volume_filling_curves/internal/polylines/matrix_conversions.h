// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_MATRIX_CONVERSIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_MATRIX_CONVERSIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of vectors and rows of matrices to points and edges of a network.

template <typename Traits>
std::vector<typename Traits::Point_3> to_points(const std::vector<Vector>& vectors,
                                                const Traits& traits)
{
  std::vector<typename Traits::Point_3> points;
  points.reserve(vectors.size());
  for(const Vector& v : vectors) points.push_back(to_point(v, traits));
  return points;
}

template <typename Matrix, typename Traits>
std::vector<typename Traits::Point_3> rows_to_points(const Eigen::MatrixBase<Matrix>& matrix,
                                                     const Traits& traits)
{
  CGAL_precondition_msg(matrix.cols() == 3, "`points` has three columns");
  std::vector<Vector> vectors;
  vectors.reserve(static_cast<std::size_t>(matrix.rows()));
  for(Eigen::Index i = 0; i < matrix.rows(); ++i) {
    vectors.emplace_back(matrix(i, 0), matrix(i, 1), matrix(i, 2));
    if(!vectors.back().allFinite())
      throw std::invalid_argument("point " + std::to_string(i) + " is not finite");
  }
  return to_points(vectors, traits);
}

// A negative index becomes a very large one, which no point has.
template <typename Matrix>
std::vector<std::array<std::size_t, 2>> rows_to_edges(const Eigen::MatrixBase<Matrix>& matrix)
{
  static_assert(std::is_integral_v<typename Matrix::Scalar>, "indices are integers");
  CGAL_precondition_msg(matrix.cols() == 2, "`edges` has two columns");
  std::vector<std::array<std::size_t, 2>> edges;
  edges.reserve(static_cast<std::size_t>(matrix.rows()));
  for(Eigen::Index e = 0; e < matrix.rows(); ++e)
    edges.push_back(
        {static_cast<std::size_t>(matrix(e, 0)), static_cast<std::size_t>(matrix(e, 1))});
  return edges;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_MATRIX_CONVERSIONS_H
