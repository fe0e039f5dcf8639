// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DISJOINT_SETS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DISJOINT_SETS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Partition of 0, 1, ..., n - 1, with each set represented by its smallest element. Path halving
// only: O(log n) amortized per operation.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : m_parents(n), m_number_of_sets(n)
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  std::size_t number_of_sets() const { return m_number_of_sets; }

  std::size_t find(std::size_t i)
  {
    while(m_parents[i] != i) i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    if(j < i) std::swap(i, j);
    m_parents[j] = i;
    if(i != j) --m_number_of_sets;
  }

private:
  std::vector<std::size_t> m_parents;
  std::size_t m_number_of_sets;
};

// The numbers of the nodes' components, from 1 in the order of their first edges; 0 for a node
// without an edge.
inline std::vector<std::size_t> component_numbers(
    std::size_t number_of_nodes, const std::vector<std::array<std::size_t, 2>>& edges)
{
  Disjoint_sets components(number_of_nodes);
  for(const auto& [v, w] : edges) components.unite(v, w);
  std::vector<std::size_t> numbers(number_of_nodes, 0);
  std::size_t count = 0;
  for(const auto& edge : edges) {
    std::size_t& number = numbers[components.find(edge[0])];
    if(number == 0) number = ++count;
  }
  for(std::size_t v = 0; v < number_of_nodes; ++v) numbers[v] = numbers[components.find(v)];
  return numbers;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DISJOINT_SETS_H
