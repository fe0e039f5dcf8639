// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TOUCHING_NODES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TOUCHING_NODES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Nodes that share a medial sphere with a node: those that touch one of its spheres, and those
// whose spheres it touches. Spheres are visited in parallel with a parallel tag; the distribution
// of the results to the other nodes is sequential, at a few nanoseconds each. Linear time.
class Touching_nodes
{
public:
  using Index = Medial_spheres::Index;

  template <typename ConcurrencyTag>
  Touching_nodes(ConcurrencyTag, const Medial_spheres& spheres, std::size_t number_of_nodes)
      : m_of_spheres((number_of_nodes + block - 1) / block),
        m_end_of_spheres(number_of_nodes),
        m_begin(number_of_nodes + 1, 0)
  {
    for_each_block<ConcurrencyTag>(number_of_nodes, block, [&](std::size_t v, std::size_t end) {
      std::size_t c = spheres.first_circle(v);
      for(; v < end; ++v) c = find_items(spheres, c, v);
    });
    deal_to_other_nodes();
  }

  // an upper bound of the number of nodes that share a sphere with node v
  std::size_t max_nodes(std::size_t v) const
  {
    const auto [first, last] = of_spheres(v);
    return static_cast<std::size_t>(last - first) + m_begin[v + 1] - m_begin[v];
  }

  // Calls f(w, radius) for all nodes w that share a sphere with node v, in the order of their
  // indices, with the least radius of such a sphere.
  template <typename Function>
  void for_each(std::size_t v, const Function& f) const
  {
    constexpr Item none = {Medial_spheres::no_node, 0};
    const auto [first, last] = of_spheres(v);
    const Item* const end = m_items.data() + m_begin[v + 1];
    for(const Item *a = first, *b = m_items.data() + m_begin[v]; a != last || b != end;) {
      const Item p = a == last ? none : *a, q = b == end ? none : *b;
      if(p.node <= q.node) ++a;
      if(q.node <= p.node) ++b;
      if(p.node == q.node)
        f(p.node, (std::min)(p.radius, q.radius));
      else
        f((std::min)(p.node, q.node), p.node < q.node ? p.radius : q.radius);
    }
  }

private:
  static constexpr std::size_t block = 256; // nodes per task

  struct Item
  {
    Index node;
    double radius; // of the smallest sphere
  };

  // the nodes that touch spheres of node v, in the order of their indices
  std::array<const Item*, 2> of_spheres(std::size_t v) const
  {
    const Item* const items = m_of_spheres[v / block].data();
    return {items + (v % block == 0 ? 0 : m_end_of_spheres[v - 1]), items + m_end_of_spheres[v]};
  }

  // Finds the nodes that touch spheres of node v, each once. Takes the first circle that is not of
  // a node before v, and returns the first one of a node after v.
  std::size_t find_items(const Medial_spheres& spheres, std::size_t c, std::size_t v)
  {
    std::vector<Item>& items = m_of_spheres[v / block];
    const std::size_t first = items.size();
    for(; c < spheres.circles().size() && spheres.circles()[c].node == v; ++c)
      for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
        const Index other = spheres.touching_node(c, l);
        if(other != Medial_spheres::no_node) add_item(other, spheres.radius(c, l), first, items);
      }
    std::sort(items.begin() + static_cast<std::ptrdiff_t>(first), items.end(),
              [](const Item& a, const Item& b) { return a.node < b.node; });
    m_end_of_spheres[v] = items.size();
    return c;
  }

  static void add_item(Index node, double radius, std::size_t first, std::vector<Item>& items)
  {
    std::size_t k = items.size(); // mostly the node found last
    while(k > first && items[k - 1].node != node) --k;
    if(k == first)
      items.push_back({node, radius});
    else
      items[k - 1].radius = (std::min)(items[k - 1].radius, radius);
  }

  void deal_to_other_nodes()
  {
    for(const std::vector<Item>& items : m_of_spheres)
      for(const Item& item : items) ++m_begin[item.node + 1];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_items.resize(m_begin.back());
    std::vector<std::size_t> end(m_begin.begin(), m_begin.end() - 1);
    for(std::size_t v = 0; v < m_end_of_spheres.size(); ++v) {
      const auto [first, last] = of_spheres(v);
      for(const Item* item = first; item != last; ++item)
        m_items[end[item->node]++] = {static_cast<Index>(v), item->radius};
    }
  }

  std::vector<std::vector<Item>> m_of_spheres; // of the nodes of each block
  std::vector<std::size_t> m_end_of_spheres;   // per node, in its block's items
  std::vector<Item> m_items; // per node: the nodes with a sphere that it touches, in order
  std::vector<std::size_t> m_begin;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_TOUCHING_NODES_H
