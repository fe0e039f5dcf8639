// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// List of nodes and their positions, one array per coordinate.
class Node_list
{
public:
  using Index = std::uint32_t;

  std::size_t size() const { return m_size; }
  Index index(std::size_t k) const { return m_indices[k]; }
  const double* x() const { return m_x.data(); }
  const double* y() const { return m_y.data(); }
  const double* z() const { return m_z.data(); }

  void clear() { m_size = 0; }

  void push_back(Index index, const Vector& position)
  {
    grow(m_size + 1);
    m_indices[m_size] = index;
    m_x[m_size] = position.x();
    m_y[m_size] = position.y();
    m_z[m_size] = position.z();
    ++m_size;
  }

  // Adds the entries first, ..., end - 1 of another list.
  void append(const Node_list& other, std::size_t first, std::size_t end)
  {
    grow(m_size + end - first);
    for(std::size_t k = first; k < end; ++k) copy(other, k, m_size++);
  }

  // Adds some entries of another list.
  void append(const Node_list& other, const std::vector<std::uint32_t>& numbers, std::size_t number)
  {
    grow(m_size + number);
    for(std::size_t k = 0; k < number; ++k) copy(other, numbers[k], m_size++);
  }

  // Removes all nodes farther from a point.
  void keep_within(const Vector& p, double distance)
  {
    const double squared_distance = distance * distance;
    std::size_t count = 0;
    for(std::size_t k = 0; k < m_size; ++k) {
      copy(*this, k, count);
      const Vector d = Vector(m_x[k], m_y[k], m_z[k]) - p;
      count += d.squaredNorm() <= squared_distance ? 1 : 0;
    }
    m_size = count;
  }

private:
  void copy(const Node_list& from, std::size_t k, std::size_t to)
  {
    m_indices[to] = from.m_indices[k];
    m_x[to] = from.m_x[k];
    m_y[to] = from.m_y[k];
    m_z[to] = from.m_z[k];
  }

  // Reserves space for n nodes.
  void grow(std::size_t n)
  {
    if(n <= m_indices.size()) return;
    n = (std::max)(n, 2 * m_indices.size());
    m_indices.resize(n);
    for(auto* values : {&m_x, &m_y, &m_z}) values->resize(n);
  }

  std::size_t m_size = 0;
  std::vector<Index> m_indices; // of which the first m_size count, as of the coordinates
  std::vector<double> m_x, m_y, m_z;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_LIST_H
