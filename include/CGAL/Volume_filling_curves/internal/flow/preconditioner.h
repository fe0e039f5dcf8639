// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_PRECONDITIONER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_PRECONDITIONER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/flow/Touching_nodes.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <CGAL/tags.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;

// Preconditioner P = L* + lambda M (section 4.1 of the paper), one n x n matrix for x, y and z: L*
// is the Laplacian of the curve, with the weights 1 / length, and of nodes that touch a medial
// sphere of one another, with the weights beta / R; M is diagonal, with the nodes' weights w. Rows
// of pinned nodes are those of the identity. Contact_stiffness is added to P.
//
// Each row only depends on the data of its node: rows are independent, and are filled in place, in
// parallel with a parallel tag; the order of the entries is known, and nothing is sorted or
// transposed. P is symmetric, hence its columns, which Eigen stores, are its rows. Linear time.
template <typename Network, typename ConcurrencyTag>
class Preconditioner_assembly
{
public:
  // Takes a null pointer if the curve follows no direction field.
  Preconditioner_assembly(const Curve_flow_parameters& parameters,
                          const Network& curve,
                          const Vector_field& x,
                          const Touching_nodes& touching,
                          const Direction_preference* preference)
      : m_parameters(parameters),
        m_curve(curve),
        m_x(x),
        m_touching(touching),
        m_preference(preference)
  {}

  Sparse_matrix operator()(const std::vector<double>& weights,
                           const std::vector<double>& thickness) const
  {
    const double lambda = m_parameters.preconditioner == Preconditioner::QUASI_NEWTON
                              ? m_parameters.medial_weight
                              : m_parameters.screening;
    Sparse_matrix matrix(index(size()), index(size()));
    matrix.reserve(max_entries());
    for_each_block<ConcurrencyTag>(size(), block, [&](std::size_t v, std::size_t end) {
      Entries neighbors;
      for(; v < end; ++v)
        fill_row(v, lambda / (thickness[v] * thickness[v]) * weights[v], neighbors, matrix);
    });
    return matrix;
  }

private:
  static constexpr std::size_t block = 256; // nodes per task

  struct Entry
  {
    std::size_t node;
    double value;
  };

  using Entries = std::vector<Entry>;

  static Eigen::Index index(std::size_t v) { return static_cast<Eigen::Index>(v); }
  std::size_t size() const { return m_curve.number_of_nodes(); }

  // Bounds of the numbers of entries per row; an edge and a sphere may contribute to the same one.
  Eigen::VectorXi max_entries() const
  {
    Eigen::VectorXi numbers(index(size()));
    for(std::size_t v = 0; v < size(); ++v)
      numbers[index(v)] = static_cast<int>(1 + m_curve.degree(v) + m_touching.max_nodes(v));
    return numbers;
  }

  // Fills the row of node v, in the order of the nodes: its neighbors along the curve, which are
  // kept in `neighbors` meanwhile, merged with those that it shares a sphere with.
  void fill_row(std::size_t v, double diagonal, Entries& neighbors, Sparse_matrix& matrix) const
  {
    Row row(matrix, v);
    if(m_curve.is_pinned(v)) return row.append({v, 1});
    neighbors.assign(1, {v, 0});
    if(m_parameters.preconditioner != Preconditioner::L2) add_neighbors(v, neighbors, diagonal);
    auto next = neighbors.begin();
    m_touching.for_each(v, [&](std::size_t w, double radius) {
      while(next != neighbors.end() && next->node < w) row.append(*next++);
      const double weight = m_parameters.coupling / radius;
      diagonal += weight;
      if(!m_curve.is_pinned(w)) row.append({w, -weight});
    });
    while(next != neighbors.end()) row.append(*next++);
    row.set(v, diagonal);
  }

  // Adds the neighbors along the curve, and sorts all.
  void add_neighbors(std::size_t v, Entries& neighbors, double& diagonal) const
  {
    for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
      const std::size_t w = m_curve.neighbor(v, k);
      const double weight = edge_weight(v, k);
      diagonal += weight;
      if(!m_curve.is_pinned(w)) neighbors.push_back({w, -weight});
    }
    std::sort(neighbors.begin(), neighbors.end(),
              [](const Entry& a, const Entry& b) { return a.node < b.node; });
  }

  // With a direction field also one factor for x, y and z: the largest eigenvalue of the Hessian of
  // the edge.
  double edge_weight(std::size_t v, std::size_t k) const
  {
    const Vector edge = row(m_x, m_curve.neighbor(v, k)) - row(m_x, v);
    const double weight = 1 / edge.norm();
    if(!m_preference) return weight;
    return weight + m_preference->stiffness(m_curve.incident_edge(v, k), edge);
  }

  // The row of a node, which grows in the order of the nodes.
  class Row
  {
  public:
    Row(Sparse_matrix& matrix, std::size_t v)
        : m_nodes(matrix.innerIndexPtr() + matrix.outerIndexPtr()[v]),
          m_values(matrix.valuePtr() + matrix.outerIndexPtr()[v]),
          m_size(matrix.innerNonZeroPtr()[v])
    {
      m_size = 0;
    }

    // Entries of the same node are added up.
    void append(const Entry& entry)
    {
      const int node = static_cast<int>(entry.node);
      if(m_size > 0 && m_nodes[m_size - 1] == node)
        m_values[m_size - 1] += entry.value;
      else {
        m_nodes[m_size] = node;
        m_values[m_size++] = entry.value;
      }
    }

    // \pre there is an entry of the node
    void set(std::size_t node, double value)
    {
      m_values[std::lower_bound(m_nodes, m_nodes + m_size, static_cast<int>(node)) - m_nodes] =
          value;
    }

  private:
    int* m_nodes;
    double* m_values;
    int& m_size;
  };

  const Curve_flow_parameters& m_parameters;
  const Network& m_curve;
  const Vector_field& m_x;
  const Touching_nodes& m_touching;
  const Direction_preference* m_preference;
};

// Takes a null pointer if the curve follows no direction field.
template <typename ConcurrencyTag = Sequential_tag, typename Network>
Sparse_matrix preconditioner(const Curve_flow_parameters& parameters,
                             const Network& curve,
                             const Vector_field& x,
                             const std::vector<double>& weights,
                             const std::vector<double>& thickness,
                             const Medial_spheres& spheres,
                             const Direction_preference* preference = nullptr)
{
  const Medial_spheres none;
  const bool is_medial = parameters.preconditioner == Preconditioner::MEDIAL;
  const Touching_nodes touching(ConcurrencyTag(), is_medial ? spheres : none,
                                curve.number_of_nodes());
  return Preconditioner_assembly<Network, ConcurrencyTag>(parameters, curve, x, touching,
                                                          preference)(weights, thickness);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_PRECONDITIONER_H
