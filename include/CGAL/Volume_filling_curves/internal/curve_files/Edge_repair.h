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
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
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
    drop_unreadable_edges();
    warn_of_isolated_vertices();
    drop_duplicate_edges();
    contract_short_edges();
    drop_collapsed_loops();
    check_degrees();
  }

private:
  struct Turn
  {
    std::size_t source, target, line;
  };

  // Omits the edges of unreadable vertices.
  void drop_unreadable_edges()
  {
    m_file.remove_edges_if([this](std::size_t e) {
      const auto [v, w] = m_file.edges[e];
      m_has_edge[v] = m_has_edge[w] = true;
      return !m_file.is_readable(v) || !m_file.is_readable(w);
    });
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
    if(m_file.edges.empty())
      add_defect(Curve_defect_kind::NO_GEOMETRY, "there are no edges", line, {});
  }

  // Keeps the first of several equal edges. Turns are judged by the degrees that remain.
  void drop_duplicate_edges()
  {
    const std::vector<bool> turns = m_file.turns();
    const std::vector<std::size_t> firsts = m_file.first_equal_edges();
    m_file.remove_edges_if([&](std::size_t e) {
      if(firsts[e] == e) return false;
      const auto [v, w] = m_file.edges[e];
      if(turns[e])
        m_turns.push_back({v, w, m_file.edge_lines[e]});
      else
        add_defect(Curve_defect_kind::DUPLICATE_EDGE, "an edge is given again and is dropped",
                   m_file.edge_lines[e], {v, w});
      return true;
    });
  }

  // Merges the ends of edges of length zero into their first node.
  void contract_short_edges()
  {
    for(std::size_t e = 0; e < m_file.edges.size(); ++e) {
      const auto [v, w] = m_file.edges[e];
      if(m_file.points[v] == m_file.points[w]) merge_nodes(v, w, m_file.edge_lines[e]);
    }
    for(Curve_draft::Edge& edge : m_file.edges)
      for(std::size_t& v : edge) v = m_representatives.find(v);
    for(std::size_t& v : m_file.pinned) v = m_representatives.find(v);
    m_file.remove_edges_if([this](std::size_t e) {
      const auto [v, w] = m_file.edges[e];
      if(v == w) m_merged.push_back(v);
      return v == w;
    });
  }

  void merge_nodes(std::size_t v, std::size_t w, std::size_t line)
  {
    const auto [first, second] = std::minmax(v, w);
    if(first == second)
      add_defect(Curve_defect_kind::COINCIDENT_NODES, "a node follows itself and is taken once",
                 line, {first});
    else
      add_defect(Curve_defect_kind::COINCIDENT_NODES, "coincident nodes are merged",
                 m_file.point_lines[second], {first, second});
    m_representatives.unite(first, second);
  }

  // Edges that contraction made parallel were a loop with two distinct nodes.
  void drop_collapsed_loops()
  {
    if(m_merged.empty()) return;
    const std::vector<std::size_t> firsts = m_file.first_equal_edges();
    m_file.remove_edges_if([&](std::size_t e) {
      if(firsts[e] == e) return false;
      add_degenerate_loop(m_file.edges[e][0], m_file.edges[e][1], m_file.edge_lines[e]);
      return true;
    });
  }

  // If a merged node has no edges left, all nodes of a curve coincide.
  void check_degrees()
  {
    std::vector<std::size_t> degrees(m_file.points.size(), 0);
    for(const Curve_draft::Edge& edge : m_file.edges)
      for(const std::size_t v : edge) ++degrees[v];
    std::sort(m_merged.begin(), m_merged.end());
    m_merged.erase(std::unique(m_merged.begin(), m_merged.end()), m_merged.end());
    for(const std::size_t v : m_merged)
      if(degrees[v] == 0)
        add_defect(Curve_defect_kind::DEGENERATE_LOOP, "all nodes of a curve coincide",
                   m_file.point_lines[v], {v});
    for(const Turn& turn : m_turns) check_turn(turn, degrees);
  }

  void check_turn(const Turn& turn, const std::vector<std::size_t>& degrees)
  {
    const std::size_t v = m_representatives.find(turn.source);
    const std::size_t w = m_representatives.find(turn.target);
    if(v == w) return; // contracted
    if(degrees[v] == 1 && degrees[w] == 1)
      return add_degenerate_loop(turn.source, turn.target, turn.line);
    add_defect(Curve_defect_kind::SELF_CONTACT, "a line runs straight back over its last edge",
               turn.line, {turn.source, turn.target});
  }

  void add_degenerate_loop(std::size_t v, std::size_t w, std::size_t line)
  {
    add_defect(Curve_defect_kind::DEGENERATE_LOOP, "a closed curve needs three distinct nodes",
               line, {v, w});
  }

  void add_defect(Curve_defect_kind kind,
                  const std::string& message,
                  std::size_t line,
                  const std::vector<std::size_t>& nodes)
  {
    m_file.add_defect(kind, message, line, nodes, nodes.empty() ? 0 : m_components[nodes[0]]);
  }

  Curve_draft& m_file;
  std::vector<Turn> m_turns;         // edges that run straight back over the edge before them
  std::vector<std::size_t> m_merged; // nodes that represent several
  std::vector<bool> m_has_edge;
  std::vector<std::size_t> m_components;
  Disjoint_sets m_representatives;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_EDGE_REPAIR_H
