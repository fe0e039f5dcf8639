// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_SOLVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_SOLVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Contact_stiffness.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/flow/preconditioner.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <Eigen/SparseCholesky>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Solver of P d = b for large P, whose Cholesky factor fills in like that of a mesh in space:
// conjugate gradients, preconditioned with the tridiagonal part of P. Since nodes are numbered
// along the curve, this part contains nearly all edges of the curve and omits only the weak
// coupling along medial spheres; some ten iterations suffice, in linear time each. P is an
// M-matrix, hence its tridiagonal part is positive definite. It remains so with contacts, which are
// stronger, since a part of their stiffness is added to the diagonal. Contacts are applied one
// after another. Projections keep residuals and directions in the tangents of sliding nodes.
template <typename ConcurrencyTag = Sequential_tag>
class Tridiagonal_conjugate_gradients
{
public:
  // Returns the solution, with contacts added to P, up to a relative residual. P is symmetric, both
  // halves are stored. \throws Run_stopped if a watch requests it
  Vector_field operator()(const Sparse_matrix& p,
                          const Contact_stiffness& contacts,
                          const Vector_field& b,
                          const Tangent_projection& project,
                          double tolerance,
                          Run_watch* watch = nullptr)
  {
    factorize(p, contacts);
    Vector_field x = Vector_field::Zero(b.rows(), 3);
    m_residual = b;
    m_direction.setZero(b.rows(), 3);
    m_image.resize(b.rows(), 3);
    double rho = 1, left = dot(b, b);
    const double goal = tolerance * tolerance * left;
    for(int k = 0; k < max_iterations && left > goal; ++k) {
      check(watch);
      apply_inverse();
      project(m_image);
      const double last_rho = rho;
      rho = dot(m_residual, m_image);
      turn(rho / last_rho);
      const double stiffness = multiply(p) + contacts.add_product(m_direction, m_image);
      project(m_image);
      left = advance(rho / stiffness, x);
    }
    return x;
  }

private:
  // the share of the contacts' stiffness on the diagonal: a contact acts along one direction of
  // three and at two nodes; 0.3 or 1 is as fast
  static constexpr double share_of_contacts = 0.5;
  // In a prototype, 41,000 nodes without contacts took 7 to 38. The bound ends what does not
  // converge.
  static constexpr int max_iterations = 500;

  // T = (I + l) D (I + l)^T with l below the diagonal, and one more entry of l, 0
  void factorize(const Sparse_matrix& p, const Contact_stiffness& contacts)
  {
    read_tridiagonal_part(p);
    contacts.add_to_diagonal(m_inverse_diagonal, share_of_contacts);
    double carried = 0;
    for(Eigen::Index v = 0; v < p.rows(); ++v) {
      m_inverse_diagonal[v] = 1 / (m_inverse_diagonal[v] - carried);
      const double entry = m_lower[v + 1];
      m_lower[v + 1] = entry * m_inverse_diagonal[v];
      carried = entry * m_lower[v + 1];
    }
  }

  // Looks up the diagonal of P, and the entries below it.
  void read_tridiagonal_part(const Sparse_matrix& p)
  {
    m_inverse_diagonal.resize(p.rows());
    m_lower.setZero(p.rows() + 1);
    for_each_index<ConcurrencyTag>(size(p), [&](std::size_t v) {
      for(Sparse_matrix::InnerIterator entry(p, index(v)); entry; ++entry)
        if(entry.row() == index(v))
          m_inverse_diagonal[index(v)] = entry.value();
        else if(entry.row() == index(v + 1))
          m_lower[index(v + 1)] = entry.value();
    });
  }

  // image = T^-1 residual
  void apply_inverse()
  {
    Vector last;
    for(std::size_t v = 0; v < size(m_residual); ++v) {
      last = row(m_residual, v) - m_lower[index(v)] * last;
      set_row(m_image, v, last);
    }
    last = Vector();
    for(std::size_t v = size(m_residual); v-- > 0;) {
      last = m_inverse_diagonal[index(v)] * row(m_image, v) - m_lower[index(v + 1)] * last;
      set_row(m_image, v, last);
    }
  }

  // direction = image + factor direction
  void turn(double factor)
  {
    for_each_index<ConcurrencyTag>(size(m_residual), [&](std::size_t v) {
      set_row(m_direction, v, row(m_image, v) + factor * row(m_direction, v));
    });
  }

  // image = P direction, in one pass over P for all three columns: Eigen takes one for each.
  // Returns direction . image.
  double multiply(const Sparse_matrix& p)
  {
    return sum_over_indices<ConcurrencyTag>(size(p), [&](std::size_t v) {
      Vector sum;
      for(Sparse_matrix::InnerIterator entry(p, index(v)); entry; ++entry)
        sum += entry.value() * row(m_direction, entry.row());
      set_row(m_image, v, sum);
      return row(m_direction, v).dot(sum);
    });
  }

  // x += length direction. Returns the squared norm of the residual.
  double advance(double length, Vector_field& x)
  {
    return sum_over_indices<ConcurrencyTag>(size(x), [&](std::size_t v) {
      set_row(x, v, row(x, v) + length * row(m_direction, v));
      const Vector left = row(m_residual, v) - length * row(m_image, v);
      set_row(m_residual, v, left);
      return left.squaredNorm();
    });
  }

  static double dot(const Vector_field& a, const Vector_field& b)
  {
    return sum_over_indices<ConcurrencyTag>(
        size(a), [&](std::size_t v) { return row(a, v).dot(row(b, v)); });
  }

  static Eigen::Index index(std::size_t v) { return static_cast<Eigen::Index>(v); }

  template <typename Matrix>
  static std::size_t size(const Matrix& matrix)
  {
    return static_cast<std::size_t>(matrix.rows());
  }

  // Kept from one system to the next: with a million nodes, the operating system takes longer to
  // allocate them than the solver to fill them.
  Vector_field m_residual, m_direction, m_image;
  Eigen::VectorXd m_inverse_diagonal, m_lower;
};

// Solver of P d = b for three right-hand sides: by sparse Cholesky factorization while that is
// faster, and by conjugate gradients for large P, in parallel with a parallel tag, or in the
// tangents of sliding nodes.
template <typename ConcurrencyTag = Sequential_tag>
class Direction_solver
{
public:
  Vector_field operator()(const Sparse_matrix& p,
                          const Vector_field& b,
                          const Contact_stiffness& contacts = Contact_stiffness(),
                          const Tangent_projection& project = Tangent_projection(),
                          Run_watch* watch = nullptr)
  {
    if(contacts.has_contacts())
      return m_conjugate_gradients(p, contacts, b, project, rough_tolerance, watch);
    if(p.rows() > max_factorized || project.has_sliding_nodes())
      return m_conjugate_gradients(p, contacts, b, project, tolerance, watch);
    m_factorization.compute(p);
    // b serves as a direction if the factorization breaks down
    if(m_factorization.info() != Eigen::Success) return b;
    const Eigen::Matrix<double, Eigen::Dynamic, 3> columns = b;
    return m_factorization.solve(columns);
  }

private:
  // Cholesky loses from 64 nodes on for tight knots (kernel_solver, 2026-11-21): with 200, tangled
  // knots, which flow on 50 to 200 nodes most of the time, take a fifth longer (2026-11-23).
  static constexpr Eigen::Index max_factorized = 64;

  // Relative residuals. Directions with contacts take twice as many iterations for another digit,
  // and knots do not settle in fewer steps for that (2026-11-23).
  static constexpr double tolerance = 1e-4, rough_tolerance = 1e-2;

  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower> m_factorization;
  Tridiagonal_conjugate_gradients<ConcurrencyTag> m_conjugate_gradients;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_SOLVER_H
