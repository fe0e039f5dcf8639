// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Coarse phase of a flow, with longer edges and longer steps than required, while the curve shrinks
// fast. Nearly all of the work is done in this phase, and fewer nodes take less time; but tight
// strands with long edges oscillate, and a coarse flow hardly converges (8 knots of 24 with edges
// of at least 0.5 r all the time, 2026-11-23).
class Coarse_phase
{
public:
  // A curve that is nearly tight keeps its fine edges.
  void begin(double gradient_norm)
  {
    m_edges = gradient_norm > gradient_of_nearly_tight ? Edges::LONG : Edges::SHORT;
  }

  void end() { set(Edges::SHORT); }

  bool is_on() const { return m_edges == Edges::LONG; }

  // Takes the length after a step, and decides whether the next step is coarse.
  void note(double length)
  {
    m_lengths[m_count++ % m_lengths.size()] = length;
    if(m_count < m_lengths.size()) return;
    const double fall = 1 - length / m_lengths[m_count % m_lengths.size()];
    if(is_on() ? fall < slow : fall > fast) set(is_on() ? Edges::SHORT : Edges::LONG);
  }

private:
  static constexpr double gradient_of_nearly_tight = 0.1; // tangled curves have 0.2 to 0.5
  static constexpr std::size_t window = 10;
  // Relative decreases of the length in a window. They differ, since longer edges make a curve a
  // little shorter by themselves: 3 % for both take 10 % more node-iterations on the paper's
  // unknots (2026-11-23).
  static constexpr double slow = 0.02, fast = 0.05;

  enum class Edges
  {
    SHORT,
    LONG
  };

  void set(Edges edges)
  {
    m_edges = edges;
    m_count = 0;
  }

  std::array<double, window + 1> m_lengths = {}; // after the last steps, in turn
  std::size_t m_count = 0;                       // of the steps
  Edges m_edges = Edges::SHORT;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H
