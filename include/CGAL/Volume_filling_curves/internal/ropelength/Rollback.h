// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROLLBACK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROLLBACK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/measures/strand_measures.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Rollback of a curve's certified changes to its least ropelength. The motion back is certified
// like the motion there. All of 8,737 random motions could be undone (2026-11-22); since
// intermediate positions of several rounds may be rounded differently, each is checked. Only the
// changes since the least ropelength are stored, 24 bytes per node and motion: 28 motions and 0.6
// MB for a torus knot of 843 nodes.
template <typename Guard, typename ConcurrencyTag>
class Rollback
{
public:
  explicit Rollback(Guard& guard) : m_guard(guard), m_min(ropelength(guard.curve())) {}

  double min_ropelength() const { return m_min; }

  // Returns the certified fraction of the motion.
  double move(const Vector_field& targets)
  {
    const Stage_timer timer(m_seconds_back); // the motion back takes as long
    Vector_field before = coordinates(m_guard.curve());
    const Clearance_scope<Guard> scope(m_guard, 0);
    const double fraction = m_guard.template move_nodes<ConcurrencyTag>(targets, min_fraction);
    if(fraction > 0) m_changes.push_back({std::move(before), {}});
    return fraction;
  }

  // Halves all edges, and returns whether that was certified.
  bool halve_edges()
  {
    const Stage_timer timer(m_seconds_back);
    const std::size_t n = m_guard.curve().number_of_nodes();
    const std::size_t edges = m_guard.curve().number_of_edges();
    const Clearance_scope<Guard> scope(m_guard, 0);
    for(std::size_t e = 0; e < edges; ++e) halve_edge(m_guard, e);
    const std::vector<std::uint32_t> former = m_guard.collect_garbage();
    Change change;
    for(std::size_t v = 0; v < former.size(); ++v)
      if(former[v] >= n) change.inserted_nodes.push_back(v);
    if(!change.inserted_nodes.empty()) m_changes.push_back(std::move(change));
    return former.size() == n + edges;
  }

  // Stores the current curve as the point of return if its ropelength is the least so far.
  void note()
  {
    const double now = ropelength(m_guard.curve());
    if(!(now < m_min)) return;
    m_min = now;
    m_seconds_back = 0;
    m_changes.clear();
  }

  // the estimated time of the motion back
  double seconds_back() const { return m_seconds_back; }

  // Moves the curve back, and returns whether it arrived.
  bool return_to_min_ropelength()
  {
    const Clearance_scope<Guard> scope(m_guard, 0);
    try {
      for(; !m_changes.empty(); m_changes.pop_back())
        if(!undo(m_changes.back())) return false;
    } catch(const Run_stopped&) {
      return false;
    }
    return true;
  }

private:
  static constexpr double min_fraction = 1. / 64; // of a motion, as of a step of the flow

  // Data that undo a motion or an insertion.
  struct Change
  {
    Vector_field before;
    std::vector<std::size_t> inserted_nodes;
  };

  bool undo(const Change& change)
  {
    if(change.inserted_nodes.empty())
      return m_guard.template move_nodes<ConcurrencyTag>(change.before) == 1;
    bool is_done = true;
    for(const std::size_t v : change.inserted_nodes) is_done = m_guard.remove_node(v) && is_done;
    m_guard.collect_garbage();
    return is_done;
  }

  Guard& m_guard;
  double m_min; // ropelength
  double m_seconds_back = 0;
  std::vector<Change> m_changes;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROLLBACK_H
