// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DISK_SWEEP_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DISK_SWEEP_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Coefficient.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Step of a sweep: the disk absorbs a crossing that is attached to its boundary by consecutive
// arcs. Before the step, the boundary is rotated to begin with these arcs.
struct Sweep_step
{
  std::size_t rotation; // of the boundary, to the left
  std::size_t crossing;
  std::size_t attached; // the number of these arcs
  std::size_t last_end; // the end at the crossing, 0 to 3, of the last of them; 0 if there are none
};

// Order in which a disk grows over a connected diagram without nugatory crossings, one crossing at
// a time. The boundary of the disk crosses the arcs between processed and remaining crossings,
// which are listed counterclockwise. A crossing can be added if its arcs to the disk are
// consecutive; otherwise a hole would remain. Such a crossing always exists: each crossing whose
// removal leaves the rest connected qualifies, as in an st-numbering (Lempel, Even, Cederbaum
// 1967). Of these, the crossing with the most arcs to the disk is next. Several first crossings are
// tried, and the order with the least sum of k! wins, where 2k arcs are on the boundary: about the
// time of HOMFLY-PT. O(n w^2) for w arcs.
class Disk_sweep
{
public:
  // \pre the diagram was returned by diagram_pieces(), or is a cable of such a diagram
  // \throws Polynomial_limit if all orders that were tried are wider than max_boundary
  // \throws Run_stopped in a Watched_scope
  explicit Disk_sweep(const Planar_diagram& diagram) : m_diagram(diagram), m_strands(diagram)
  {
    const std::size_t n = m_diagram.crossings.size();
    for(std::size_t c = 0; c < n; c += 1 + n / max_starts) {
      check_run();
      const double cost = sweep_from(c);
      if(cost >= m_cost) continue;
      m_cost = cost;
      m_best = m_steps;
    }
    if(m_best.empty()) throw Polynomial_limit();
  }

  const std::vector<Sweep_step>& steps() const { return m_best; }

private:
  static constexpr std::size_t max_starts = 64;
  static constexpr std::size_t max_boundary = 32; // 16! states are beyond all limits

  using End = Diagram_strands::End;

  // returns the cost, infinite unless it is less than that of the best sweep
  double sweep_from(std::size_t first)
  {
    m_steps.clear();
    m_boundary.clear();
    double cost = 0;
    for(Sweep_step step{0, first, 0, 0};; step = next_step()) {
      take_in(step);
      cost += std::tgamma(1 + static_cast<double>(m_boundary.size()) / 2);
      if(cost >= m_cost || m_boundary.size() > max_boundary)
        return std::numeric_limits<double>::infinity();
      if(m_boundary.empty()) return cost;
    }
  }

  void take_in(const Sweep_step& step)
  {
    m_steps.push_back(step);
    std::rotate(m_boundary.begin(), m_boundary.begin() + difference(step.rotation),
                m_boundary.end());
    m_boundary.erase(m_boundary.begin(), m_boundary.begin() + difference(step.attached));
    std::vector<End> added;
    for(std::size_t i = step.attached; i < 4; ++i)
      added.push_back(other_end(step.crossing, (step.last_end + i) % 4));
    m_boundary.insert(m_boundary.begin(), added.begin(), added.end());
  }

  static std::ptrdiff_t difference(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

  End other_end(std::size_t crossing, std::size_t k) const
  {
    const std::size_t arc = m_diagram.crossings[crossing][k];
    const End source = m_strands.source(arc);
    return source.crossing == crossing && source.k == k ? m_strands.target(arc) : source;
  }

  // Whether arcs i and i + 1 of the boundary go to the same crossing, with nothing between them.
  bool is_run(std::size_t i) const
  {
    const End &e = m_boundary[i], &f = m_boundary[(i + 1) % m_boundary.size()];
    return e.crossing == f.crossing && e.k == (f.k + 1) % 4;
  }

  Sweep_step next_step() const
  {
    const std::size_t n = m_boundary.size();
    Sweep_step best{0, 0, 0, 0};
    for(std::size_t i = 0; i < n; ++i) {
      if(n > 1 && is_run((i + n - 1) % n) && !is_closed_run()) continue;
      std::size_t length = 1;
      while(length < n && length < 4 && is_run((i + length - 1) % n)) ++length;
      const std::size_t c = m_boundary[i].crossing;
      if(length <= best.attached || length != number_of_arcs_to(c)) continue;
      best = {i, c, length, m_boundary[(i + length - 1) % n].k};
    }
    CGAL_assertion_msg(best.attached > 0, "the diagram is connected and reduced");
    return best;
  }

  // the last crossing, whose four arcs may be counted from any of them
  bool is_closed_run() const
  {
    return m_boundary.size() == 4 && is_run(0) && is_run(1) && is_run(2) && is_run(3);
  }

  std::size_t number_of_arcs_to(std::size_t crossing) const
  {
    return static_cast<std::size_t>(
        std::count_if(m_boundary.begin(), m_boundary.end(),
                      [crossing](const End& e) { return e.crossing == crossing; }));
  }

  const Planar_diagram& m_diagram;
  const Diagram_strands m_strands;
  std::vector<End> m_boundary; // the outer ends of its arcs
  std::vector<Sweep_step> m_steps, m_best;
  double m_cost = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DISK_SWEEP_H
