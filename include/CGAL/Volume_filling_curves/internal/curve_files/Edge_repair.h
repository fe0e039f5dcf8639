// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_EDGE_REPAIR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_EDGE_REPAIR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Harmless repairs of the edges of a file, each with a warning: an edge that occurs twice is
// dropped, and an edge of length zero is contracted to its first node. A repair must not change the
// curve: a loop that would become an arc or a point is an error, and so is a line that runs
// straight back. Afterwards no edge is a loop, parallel to another edge, or of length zero.
// O(n log n).
class Edge_repair
{
public:
  explicit Edge_repair(Curve_draft& file)
      : m_file(file),
        m_has_edge(file.points.size(), false),
        m_components(component_numbers(file.points.size(), file.edges)),
        m_representatives(file.points.size())
  {}

  void run()
  {
    collect_edges();
    warn_of_isolated_vertices();
    drop_duplicate_edges();
    contract_short_edges();
    drop_collapsed_loops();
    check_degrees();
    store();
  }

private:
  struct Edge
  {
    std::size_t source, target, line;
  };

  // Omits the edges of unreadable vertices.
  void collect_edges()
  {
    for(std::size_t e = 0; e < m_file.edges.size(); ++e) {
      const auto [v, w] = m_file.edges[e];
      m_has_edge[v] = m_has_edge[w] = true;
      if(m_file.is_readable(v) && m_file.is_readable(w))
        m_edges.push_back({v, w, m_file.edge_lines[e]});
    }
  }

  // After an error a vertex may lack edges only because their record is unreadable.
  void warn_of_isolated_vertices()
  {
    if(m_file.defects.has_error()) return;
    std::vector<std::size_t> isolated;
    for(std::size_t v = 0; v < m_has_edge.size(); ++v)
      if(!m_has_edge[v]) isolated.push_back(v);
    if(isolated.empty()) return;
    const std::size_t count = isolated.size();
    if(count > Defect_list::max_listed) isolated.resize(Defect_list::max_listed);
    const std::size_t line = m_file.point_lines[isolated.front()];
    add_defect(Curve_defect_kind::ISOLATED_VERTEX,
               count == 1 ? "a vertex is in no line and is ignored"
                          : std::to_string(count) + " vertices are in no line and are ignored",
               line, isolated);
    if(m_edges.empty()) add_defect(Curve_defect_kind::NO_GEOMETRY, "there are no edges", line, {});
  }

  // Keeps the first of several equal edges. An edge directly after its reverse is not a repetition:
  // there the line turns back.
  void drop_duplicate_edges()
  {
    const std::vector<std::size_t> turns = find_turns(), duplicates = find_parallel_edges();
    for(const std::size_t e : duplicates) {
      const Edge& edge = m_edges[e];
      if(std::binary_search(turns.begin(), turns.end(), e))
        m_turns.push_back(edge);
      else
        add_defect(Curve_defect_kind::DUPLICATE_EDGE, "an edge is given again and is dropped",
                   edge.line, {edge.source, edge.target});
    }
    remove_edges(duplicates);
  }

  std::vector<std::size_t> find_turns() const
  {
    std::vector<std::size_t> turns;
    const Edge* previous = nullptr;
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      const Edge& edge = m_edges[e];
      if(edge.source == edge.target) continue;
      if(previous && previous->line == edge.line && previous->source == edge.target &&
         previous->target == edge.source)
        turns.push_back(e);
      previous = &edge;
    }
    return turns;
  }

  // Returns the edges that have both nodes in common with an earlier edge.
  std::vector<std::size_t> find_parallel_edges() const
  {
    std::vector<std::array<std::size_t, 3>> keys;
    keys.reserve(m_edges.size());
    check_run();
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      const auto [lower, upper] = std::minmax(m_edges[e].source, m_edges[e].target);
      if(lower != upper) keys.push_back({lower, upper, e});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::size_t> parallel;
    for(std::size_t i = 1; i < keys.size(); ++i)
      if(keys[i][0] == keys[i - 1][0] && keys[i][1] == keys[i - 1][1])
        parallel.push_back(keys[i][2]);
    std::sort(parallel.begin(), parallel.end());
    return parallel;
  }

  // Merges the ends of edges of length zero into their first node.
  void contract_short_edges()
  {
    for(const Edge& edge : m_edges)
      if(m_file.points[edge.source] == m_file.points[edge.target]) merge_nodes(edge);
    std::vector<std::size_t> contracted;
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      Edge& edge = m_edges[e];
      edge.source = m_representatives.find(edge.source);
      edge.target = m_representatives.find(edge.target);
      if(edge.source != edge.target) continue;
      contracted.push_back(e);
      m_merged.push_back(edge.source);
    }
    remove_edges(contracted);
  }

  void merge_nodes(const Edge& edge)
  {
    const auto [first, second] = std::minmax(edge.source, edge.target);
    if(first == second)
      add_defect(Curve_defect_kind::COINCIDENT_NODES, "a node follows itself and is taken once",
                 edge.line, {first});
    else
      add_defect(Curve_defect_kind::COINCIDENT_NODES, "coincident nodes are merged",
                 m_file.point_lines[second], {first, second});
    m_representatives.unite(first, second);
  }

  // Edges that contraction made parallel were a loop with two distinct nodes.
  void drop_collapsed_loops()
  {
    if(m_merged.empty()) return;
    const std::vector<std::size_t> parallel = find_parallel_edges();
    for(const std::size_t e : parallel) add_degenerate_loop(m_edges[e]);
    remove_edges(parallel);
  }

  // If a merged node has no edges left, all nodes of a curve coincide.
  void check_degrees()
  {
    std::vector<std::size_t> degrees(m_file.points.size(), 0);
    for(const Edge& edge : m_edges)
      for(const std::size_t v : {edge.source, edge.target}) ++degrees[v];
    std::sort(m_merged.begin(), m_merged.end());
    m_merged.erase(std::unique(m_merged.begin(), m_merged.end()), m_merged.end());
    for(const std::size_t v : m_merged)
      if(degrees[v] == 0)
        add_defect(Curve_defect_kind::DEGENERATE_LOOP, "all nodes of a curve coincide",
                   m_file.point_lines[v], {v});
    for(const Edge& edge : m_turns) check_turn(edge, degrees);
  }

  void check_turn(const Edge& edge, const std::vector<std::size_t>& degrees)
  {
    const std::size_t v = m_representatives.find(edge.source);
    const std::size_t w = m_representatives.find(edge.target);
    if(v == w) return; // contracted
    if(degrees[v] == 1 && degrees[w] == 1) return add_degenerate_loop(edge);
    add_defect(Curve_defect_kind::SELF_CONTACT, "a line runs straight back over its last edge",
               edge.line, {edge.source, edge.target});
  }

  // \pre the indices are sorted
  void remove_edges(const std::vector<std::size_t>& indices)
  {
    auto next = indices.begin();
    std::size_t kept = 0;
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      if(next != indices.end() && *next == e)
        ++next;
      else
        m_edges[kept++] = m_edges[e];
    }
    m_edges.resize(kept);
  }

  void store()
  {
    m_file.edges.clear();
    m_file.edge_lines.clear();
    for(const Edge& edge : m_edges) m_file.add_edge(edge.source, edge.target, edge.line);
    for(std::size_t& v : m_file.pinned) v = m_representatives.find(v);
  }

  void add_degenerate_loop(const Edge& edge)
  {
    add_defect(Curve_defect_kind::DEGENERATE_LOOP, "a closed curve needs three distinct nodes",
               edge.line, {edge.source, edge.target});
  }

  void add_defect(Curve_defect_kind kind,
                  const std::string& message,
                  std::size_t line,
                  const std::vector<std::size_t>& nodes)
  {
    m_file.add_defect(kind, message, line, nodes, nodes.empty() ? 0 : m_components[nodes[0]]);
  }

  Curve_draft& m_file;
  std::vector<Edge> m_edges;
  std::vector<Edge> m_turns;         // edges that run straight back over the edge before them
  std::vector<std::size_t> m_merged; // nodes that represent several
  std::vector<bool> m_has_edge;
  std::vector<std::size_t> m_components;
  Disjoint_sets m_representatives;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_EDGE_REPAIR_H
