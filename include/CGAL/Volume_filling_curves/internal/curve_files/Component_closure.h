// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_COMPONENT_CLOSURE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_COMPONENT_CLOSURE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tool that closes the arcs of a file, or opens its closed curves, at the user's request. An arc
// gets an edge from its last node to its first, after its last edge in the file. A closed curve
// loses its last edge in the file, the one that closes a polyline. Components with junctions stay
// unchanged; loops and repeated edges, which `Edge_repair` drops, make no junction. New edges are
// checked later, with all others. O(n log n).
class Component_closure
{
public:
  explicit Component_closure(Curve_draft& file)
      : m_file(file),
        m_numbers(component_numbers(file.points.size(), file.edges)),
        m_degrees(file.points.size(), 0),
        m_originals(file.first_equal_edges())
  {
    const std::vector<bool> turns = file.turns();
    for(std::size_t e = 0; e < file.edges.size(); ++e) {
      if(turns[e]) m_originals[e] = e;
      add_edge(e);
    }
    for(std::size_t v = 0; v < m_degrees.size(); ++v)
      if(m_degrees[v] > 2) m_components[m_numbers[v] - 1].has_junction = true;
    for(std::size_t e = 0; e < file.edges.size(); ++e) add_ends(e);
  }

  void apply(Closure closure)
  {
    if(closure == Closure::CLOSED) close();
    if(closure == Closure::OPEN) open();
  }

private:
  struct Component
  {
    std::size_t number_of_edges = 0;
    // of positive length: the first point may be repeated twice at the end
    std::size_t last_edge = none;
    std::vector<std::size_t> ends; // of an arc: the first node and the last one
    bool has_junction = false;
  };

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  bool is_dropped(std::size_t e) const
  {
    return m_originals[e] != e || m_file.edges[e][0] == m_file.edges[e][1];
  }

  Component& component_of(std::size_t e) { return m_components[m_numbers[m_file.edges[e][0]] - 1]; }

  void add_edge(std::size_t e)
  {
    const auto [v, w] = m_file.edges[e];
    if(m_numbers[v] > m_components.size()) m_components.resize(m_numbers[v]);
    if(is_dropped(e)) return;
    ++component_of(e).number_of_edges;
    if(m_file.points[v] != m_file.points[w]) component_of(e).last_edge = e;
    ++m_degrees[v];
    ++m_degrees[w];
  }

  void add_ends(std::size_t e)
  {
    if(is_dropped(e)) return;
    const auto [v, w] = m_file.edges[e];
    std::vector<std::size_t>& ends = component_of(e).ends;
    if(m_degrees[v] == 1) ends.insert(ends.begin(), v);
    if(m_degrees[w] == 1) ends.push_back(w);
  }

  void close()
  {
    const auto edges = m_file.edges;
    const auto lines = m_file.edge_lines;
    m_file.edges.clear();
    m_file.edge_lines.clear();
    for(std::size_t e = 0; e < edges.size(); ++e) {
      const std::size_t number = m_numbers[edges[e][0]];
      const Component& component = m_components[number - 1];
      m_file.add_edge(edges[e][0], edges[e][1], lines[e]);
      if(component.has_junction || component.ends.size() != 2 || component.last_edge != e) continue;
      if(component.number_of_edges == 1)
        m_file.add_defect(Curve_defect_kind::DEGENERATE_LOOP,
                          "an arc of a single edge cannot be closed", lines[e], component.ends,
                          number);
      else
        m_file.add_edge(component.ends[1], component.ends[0], lines[e]);
    }
  }

  void open()
  {
    m_file.remove_edges_if([this](std::size_t e) {
      const Component& component = component_of(e);
      const bool is_closed = !component.has_junction && component.ends.empty();
      return is_closed && m_originals[e] == component.last_edge;
    });
  }

  Curve_draft& m_file;
  std::vector<std::size_t> m_numbers, m_degrees; // of nodes; component numbers start from 1
  std::vector<std::size_t> m_originals;          // of edges: the first with the same nodes
  std::vector<Component> m_components;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_COMPONENT_CLOSURE_H
