// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_REPLAYED_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_REPLAYED_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/format.h>
#include <CGAL/Volume_filling_curves/internal/replay/Plain_grid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Curve of a replay: nodes with their numbers in the certificate, edges as pairs of nodes, and a
// grid of the edges. It makes every change without a check. Changes take constant time if edges
// have similar lengths.
class Replayed_curve
{
public:
  struct Edge
  {
    std::size_t a, b;
    Extent box;
  };

  Replayed_curve(std::vector<Position> points,
                 const std::vector<std::array<std::uint64_t, 2>>& edges)
      : m_points(std::move(points)), m_edges_at(m_points.size()), m_is_node(m_points.size(), true)
  {
    for(const auto& edge : edges) add_edge(edge[0], edge[1]);
    rebuild_grid();
  }

  // nodes and edges that have not been removed
  std::vector<std::size_t> nodes() const
  {
    return indices_below(m_points.size(), [&](std::size_t v) { return is_node(v); });
  }

  std::vector<std::size_t> edges() const
  {
    return indices_below(m_edges.size(), [&](std::size_t e) { return is_edge(e); });
  }

  const Position& point(std::size_t v) const { return m_points[v]; }
  std::size_t source(std::size_t e) const { return m_edges[e].a; }
  std::size_t target(std::size_t e) const { return m_edges[e].b; }

  bool is_node(std::uint64_t v) const { return v < m_points.size() && m_is_node[v]; }
  const std::vector<std::size_t>& edges_at(std::size_t v) const { return m_edges_at[v]; }
  bool is_at(std::size_t e, std::size_t v) const { return m_edges[e].a == v || m_edges[e].b == v; }

  std::size_t opposite(std::size_t v, std::size_t e) const
  {
    return m_edges[e].a == v ? m_edges[e].b : m_edges[e].a;
  }

  // Returns the edge between two nodes, or none.
  std::size_t edge_between(std::size_t v, std::size_t w) const
  {
    for(const std::size_t e : m_edges_at[v])
      if(opposite(v, e) == w) return e;
    return none;
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // Calls function(e) for all edges whose boxes meet the given one, for some of them several times.
  template <typename Function>
  void for_each_edge_meeting(const Extent& box, const Function& function)
  {
    const auto look_at = [&](std::size_t e) {
      if(is_edge(e) && m_edges[e].box.meets(box)) function(e);
    };
    if(m_grid.visit_cells(box, look_at)) return;
    for(std::size_t e = 0; e < m_edges.size(); ++e) look_at(e);
  }

  void move_node(std::size_t v, const Position& target)
  {
    m_points[v] = target;
    for(const std::size_t e : m_edges_at[v]) update_box(e);
    count_change();
  }

  void insert_node(std::size_t e, const Position& position)
  {
    const std::size_t a = m_edges[e].a, c = m_edges[e].b, b = m_points.size();
    m_points.push_back(position);
    m_edges_at.emplace_back();
    m_is_node.push_back(true);
    remove_edge(e);
    add_to_grid(add_edge(a, b));
    add_to_grid(add_edge(b, c));
    count_change();
  }

  // \pre the node has two edges
  void remove_node(std::size_t v)
  {
    const std::size_t e = m_edges_at[v][0], f = m_edges_at[v][1];
    const std::size_t a = opposite(v, e), c = opposite(v, f);
    remove_edge(e);
    remove_edge(f);
    m_is_node[v] = false;
    add_to_grid(add_edge(a, c));
    count_change();
  }

private:
  template <typename IsPresent>
  static std::vector<std::size_t> indices_below(std::size_t count, const IsPresent& is_present)
  {
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < count; ++i)
      if(is_present(i)) result.push_back(i);
    return result;
  }

  bool is_edge(std::size_t e) const { return m_edges[e].a != none; }

  Extent box_of(std::size_t e) const
  {
    Extent box;
    box.add(m_points[m_edges[e].a]);
    box.add(m_points[m_edges[e].b]);
    return box;
  }

  // Not into the grid.
  std::size_t add_edge(std::size_t a, std::size_t b)
  {
    std::size_t e = m_edges.size();
    if(m_free_edges.empty()) {
      m_edges.emplace_back();
    } else {
      e = m_free_edges.back();
      m_free_edges.pop_back();
    }
    m_edges[e] = {a, b, {}};
    m_edges[e].box = box_of(e);
    m_edges_at[a].push_back(e);
    m_edges_at[b].push_back(e);
    return e;
  }

  void add_to_grid(std::size_t e) { m_grid.add(e, m_edges[e].box); }

  void remove_edge(std::size_t e)
  {
    m_grid.remove(e, m_edges[e].box);
    for(const std::size_t v : {m_edges[e].a, m_edges[e].b}) {
      auto& edges = m_edges_at[v];
      edges.erase(std::find(edges.begin(), edges.end(), e));
    }
    m_edges[e].a = m_edges[e].b = none;
    m_free_edges.push_back(e);
  }

  void update_box(std::size_t e)
  {
    const Extent box = box_of(e);
    if(!m_grid.are_alike(m_edges[e].box, box)) {
      m_grid.remove(e, m_edges[e].box);
      m_grid.add(e, box);
    }
    m_edges[e].box = box;
  }

  // The lengths of edges change on the way.
  void count_change()
  {
    const std::size_t changes_per_edge = 8;
    if(++m_number_of_changes > changes_per_edge * m_edges.size()) rebuild_grid();
  }

  void rebuild_grid()
  {
    m_grid.reset(mean_size(), m_edges.size());
    for(const std::size_t e : edges()) add_to_grid(e);
    m_number_of_changes = 0;
  }

  // of the edges' boxes
  double mean_size() const
  {
    double sum = 0, count = 0;
    for(const std::size_t e : edges()) {
      double size = 0;
      for(std::size_t k = 0; k < 3; ++k)
        size = (std::max)(size, m_edges[e].box.upper[k] - m_edges[e].box.lower[k]);
      sum += size;
      ++count;
    }
    const double mean = sum / count;
    return std::isnormal(mean) ? mean : 1; // any cell size is right
  }

  std::vector<Position> m_points;
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_free_edges;
  std::vector<std::vector<std::size_t>> m_edges_at; // per node
  std::vector<bool> m_is_node;
  Plain_grid m_grid;
  std::size_t m_number_of_changes = 0;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_REPLAYED_CURVE_H
