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
    Vector_field x = Vector_field::Zero(b.rows(), 3);
    m_residual = b;
    m_direction.setZero(b.rows(), 3);
    double rho = 1;
    const double goal = tolerance * tolerance * b.squaredNorm();
    for(int k = 0; k < max_iterations && m_residual.squaredNorm() > goal; ++k) {
      apply_inverse();
      const double next_rho = m_residual.cwiseProduct(m_image).sum();
      m_direction = m_image + next_rho / rho * m_direction;
      rho = next_rho;
      multiply(p);
      const double length = rho / m_direction.cwiseProduct(m_image).sum();
      x += length * m_direction;
      m_residual -= length * m_image;
    }
    return x;
  }

private:
  static constexpr double tolerance = 1e-4;
  static constexpr int max_iterations = 500;

  // T = (I + l) D (I + l)^T with l below the diagonal, and one more entry of l, 0
  void factorize(const Sparse_matrix& p)
  {
    const Eigen::Index n = p.rows();
    m_inverse_diagonal.resize(n);
    m_lower.setZero(n + 1);
    double carried = 0;
    for(Eigen::Index v = 0; v < n; ++v) {
      m_inverse_diagonal[v] = 1 / (p.coeff(v, v) - carried);
      if(v + 1 == n) break;
      const double entry = p.coeff(v + 1, v);
      m_lower[v + 1] = entry * m_inverse_diagonal[v];
      carried = entry * m_lower[v + 1];
    }
  }

  // image = T^-1 residual
  void apply_inverse()
  {
    m_image.resize(m_residual.rows(), 3);
    Vector last;
    for(std::size_t v = 0; v < size(); ++v) {
      last = row(m_residual, v) - m_lower[index(v)] * last;
      set_row(m_image, v, last);
    }
    last = Vector();
    for(std::size_t v = size(); v-- > 0;) {
      last = m_inverse_diagonal[index(v)] * row(m_image, v) - m_lower[index(v + 1)] * last;
      set_row(m_image, v, last);
    }
  }

  // image = P direction, in one pass over P for all three columns: Eigen takes one for each.
  void multiply(const Sparse_matrix& p)
  {
    m_image.setZero();
    for(std::size_t v = 0; v < size(); ++v) {
      const Vector x = row(m_direction, v);
      Vector sum = row(m_image, v);
      for(Sparse_matrix::InnerIterator entry(p, index(v)); entry; ++entry) {
        const auto w = static_cast<std::size_t>(entry.row());
        if(w == v)
          sum += entry.value() * x;
        else {
          sum += entry.value() * row(m_direction, w);
          set_row(m_image, w, row(m_image, w) + entry.value() * x);
        }
      }
      set_row(m_image, v, sum);
    }
  }

  static Eigen::Index index(std::size_t v) { return static_cast<Eigen::Index>(v); }
  std::size_t size() const { return static_cast<std::size_t>(m_residual.rows()); }

  // kept from one system to the next: with a million nodes the kernel takes longer to hand them out
  // than it takes to fill them
  Vector_field m_residual, m_direction, m_image;
  Eigen::VectorXd m_inverse_diagonal, m_lower;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_TRIDIAGONAL_CONJUGATE_GRADIENTS_H
