// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_SOLVER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_DIRECTION_SOLVER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Contact_stiffness.h>
#include <CGAL/Volume_filling_curves/internal/flow/Tangent_projection.h>
#include <CGAL/Volume_filling_curves/internal/flow/Tridiagonal_conjugate_gradients.h>
#include <CGAL/Volume_filling_curves/internal/flow/preconditioner.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <CGAL/tags.h>

#include <Eigen/SparseCholesky>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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
