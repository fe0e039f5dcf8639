// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_PRECONDITIONER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_PRECONDITIONER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/internal/direction/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/direction/touching_pairs.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;

// The preconditioner P = L* + lambda M (section 4.1 of the paper), one n x n matrix for x, y and z:
// L* is the Laplacian of the curve, with the weights 1 / length, and of the touching pairs, with
// the weights beta / R; M is diagonal and holds the nodes' weights w. Rows of pinned nodes are
// those of the identity. Only the lower triangle is stored.
template <typename Network>
class Preconditioner_assembly
{
public:
  Preconditioner_assembly(const Network& curve)
      : m_curve(curve), m_diagonal(curve.number_of_nodes(), 0.)
  {}

  // times a factor per node
  void add_mass(const std::vector<double>& weights, const std::vector<double>& factors)
  {
    for(std::size_t v = 0; v < m_diagonal.size(); ++v) m_diagonal[v] += factors[v] * weights[v];
  }

  void add_curve_laplacian(const Vector_field& x)
  {
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const std::size_t a = m_curve.source(e), b = m_curve.target(e);
      couple(a, b, 1 / (row(x, b) - row(x, a)).norm());
    }
  }

  // One factor for x, y and z: the largest eigenvalue of the Hessian of each edge.
  void add_direction_laplacian(const Vector_field& x, const Direction_preference& preference)
  {
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const std::size_t a = m_curve.source(e), b = m_curve.target(e);
      couple(a, b, preference.stiffness(e, row(x, b) - row(x, a)));
    }
  }

  void add_medial_laplacian(const std::vector<Touching_pair>& pairs, double beta)
  {
    for(const Touching_pair& pair : pairs) couple(pair.low, pair.high, beta / pair.radius);
  }

  Sparse_matrix matrix()
  {
    for(std::size_t v = 0; v < m_diagonal.size(); ++v)
      add_entry(v, v, m_curve.is_pinned(v) ? 1. : m_diagonal[v]);
    const auto n = static_cast<Eigen::Index>(m_diagonal.size());
    Sparse_matrix matrix(n, n);
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    return matrix;
  }

private:
  void add_entry(std::size_t row, std::size_t column, double value)
  {
    m_entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  }

  void couple(std::size_t a, std::size_t b, double weight)
  {
    m_diagonal[a] += weight;
    m_diagonal[b] += weight;
    if(!m_curve.is_pinned(a) && !m_curve.is_pinned(b))
      add_entry((std::max)(a, b), (std::min)(a, b), -weight);
  }

  const Network& m_curve;
  std::vector<double> m_diagonal;
  std::vector<Eigen::Triplet<double>> m_entries;
};

// Takes a null pointer if the curve follows no direction field.
template <typename Network>
Sparse_matrix preconditioner(const Curve_flow_parameters& parameters,
                             const Network& curve,
                             const Vector_field& x,
                             const std::vector<double>& weights,
                             const std::vector<double>& thickness,
                             const Medial_spheres& spheres,
                             const Direction_preference* preference = nullptr)
{
  const Preconditioner kind = parameters.preconditioner;
  std::vector<double> mass_factors;
  const double mass_factor =
      kind == Preconditioner::QUASI_NEWTON ? parameters.medial_weight : parameters.screening;
  for(double r : thickness) mass_factors.push_back(mass_factor / (r * r));
  Preconditioner_assembly<Network> assembly(curve);
  assembly.add_mass(weights, mass_factors);
  if(kind != Preconditioner::L2) assembly.add_curve_laplacian(x);
  if(kind != Preconditioner::L2 && preference) assembly.add_direction_laplacian(x, *preference);
  if(kind == Preconditioner::MEDIAL)
    assembly.add_medial_laplacian(touching_pairs(spheres, curve.number_of_nodes()),
                                  parameters.coupling);
  return assembly.matrix();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIRECTION_PRECONDITIONER_H
