// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TRIDIAGONAL_CONJUGATE_GRADIENTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TRIDIAGONAL_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/direction/preconditioner.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Solves P d = b for large P, whose Cholesky factor fills in like that of a mesh in space, by
// conjugate gradients, preconditioned with the tridiagonal part of P. As nodes are numbered along
// the curve this holds all but a few edges of the curve and leaves out the weak coupling along
// medial spheres only: it takes some ten iterations, linear time each. P is an M-matrix, so that
// its tridiagonal part is positive definite, too.
class Tridiagonal_conjugate_gradients
{
public:
  // Returns the solution up to a relative residual: `tolerance` suffices for a direction.
  Vector_field operator()(const Sparse_matrix& p, const Vector_field& b)
  {
    factorize(p);
    Vector_field x = Vector_field::Zero(b.rows(), 3), residual = b;
    Vector_field z = apply_inverse(residual), direction = z;
    double rho = residual.cwiseProduct(z).sum();
    const double goal = tolerance * tolerance * b.squaredNorm();
    for(int k = 0; k < max_iterations && residual.squaredNorm() > goal; ++k) {
      const Vector_field image = p.selfadjointView<Eigen::Lower>() * direction;
      const double length = rho / direction.cwiseProduct(image).sum();
      x += length * direction;
      residual -= length * image;
      z = apply_inverse(residual);
      const double next_rho = residual.cwiseProduct(z).sum();
      direction = z + next_rho / rho * direction;
      rho = next_rho;
    }
    return x;
  }

private:
  static constexpr double tolerance = 1e-4;
  static constexpr int max_iterations = 500;

  // T = (I + l) D (I + l)^T with l below the diagonal
  void factorize(const Sparse_matrix& p)
  {
    const Eigen::Index n = p.rows();
    m_inverse_diagonal.resize(n);
    m_lower.setZero(n);
    double carried = 0;
    for(Eigen::Index v = 0; v < n; ++v) {
      m_inverse_diagonal[v] = 1 / (p.coeff(v, v) - carried);
      if(v + 1 == n) break;
      const double entry = p.coeff(v + 1, v);
      m_lower[v + 1] = entry * m_inverse_diagonal[v];
      carried = entry * m_lower[v + 1];
    }
  }

  Vector_field apply_inverse(const Vector_field& b) const
  {
    Vector_field x = b;
    for(Eigen::Index v = 1; v < x.rows(); ++v) x.row(v) -= m_lower[v] * x.row(v - 1);
    x.array().colwise() *= m_inverse_diagonal.array();
    for(Eigen::Index v = x.rows() - 1; v > 0; --v) x.row(v - 1) -= m_lower[v] * x.row(v);
    return x;
  }

  Eigen::VectorXd m_inverse_diagonal, m_lower;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TRIDIAGONAL_CONJUGATE_GRADIENTS_H
