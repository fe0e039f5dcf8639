// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_WAY_BACK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_WAY_BACK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_scope.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Changes a curve by certified changes, and brings it back to where its ropelength was least. A
// motion is certified backwards as well as forwards, since the guard tries both orders of the
// nodes; and a node that was inserted in the middle of an edge can be taken out of there.
// Remembers what was done since the least ropelength only.
template <typename Guard>
class Way_back
{
public:
  explicit Way_back(Guard& guard) : m_guard(guard), m_least(ropelength(guard.curve())) {}

  double least_ropelength() const { return m_least; }

  // Returns the fraction of the way that was certified.
  double move(const Vector_field& targets)
  {
    Vector_field before = coordinates(m_guard.curve());
    const Clearance_scope<Guard> scope(m_guard, 0);
    const double fraction = m_guard.move_nodes(targets, least_fraction);
    if(fraction > 0) m_changes.push_back({std::move(before), {}});
    return fraction;
  }

  // Halves all edges, and returns whether that was certified.
  bool halve_edges()
  {
    const std::size_t n = m_guard.curve().number_of_nodes();
    const std::size_t edges = m_guard.curve().number_of_edges();
    const Clearance_scope<Guard> scope(m_guard, 0);
    for(std::size_t e = 0; e < edges; ++e) halve_edge(m_guard, e);
    const std::vector<std::uint32_t> former = m_guard.collect_garbage();
    Change change;
    for(std::size_t v = 0; v < former.size(); ++v)
      if(former[v] >= n) change.inserted_nodes.push_back(v);
    m_changes.push_back(std::move(change));
    return former.size() == n + edges;
  }

  // Takes note of the curve as it stands if it is the best one so far.
  void note()
  {
    const double now = ropelength(m_guard.curve());
    if(!(now < m_least)) return;
    m_least = now;
    m_changes.clear();
  }

  void return_to_least_ropelength()
  {
    const Clearance_scope<Guard> scope(m_guard, 0);
    for(; !m_changes.empty(); m_changes.pop_back()) {
      const Change& change = m_changes.back();
      if(change.inserted_nodes.empty())
        m_guard.move_nodes(change.before, least_fraction);
      else
        for(const std::size_t v : change.inserted_nodes) m_guard.remove_node(v);
      m_guard.collect_garbage();
    }
  }

private:
  static constexpr double least_fraction = 1. / 64; // of the way, as of a step of the flow

  // Of a motion or an insertion.
  struct Change
  {
    Vector_field before;
    std::vector<std::size_t> inserted_nodes;
  };

  Guard& m_guard;
  double m_least; // ropelength
  std::vector<Change> m_changes;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_WAY_BACK_H
