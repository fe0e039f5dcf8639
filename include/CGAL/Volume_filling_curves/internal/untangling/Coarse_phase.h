// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <deque>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tells while a curve that untangles is to flow coarsely, with longer edges and longer steps than
// asked for: as long as it gets shorter fast. Nearly all of the work is done there, and fewer nodes
// take less time; but tight strands rattle on long edges, so that a coarse flow hardly converges
// (8 knots of 24 with edges of at least 0.5 r all the time, 2026-11-23).
class Coarse_phase
{
public:
  // A curve that is nearly tight is to stay as fine as it is.
  void begin(double gradient_norm) { m_is_on = gradient_norm > gradient_of_nearly_tight; }

  void end() { set(false); }

  bool is_on() const { return m_is_on; }

  // Takes the length after a step, and decides what the next one is to be like.
  void note(double length)
  {
    m_lengths.push_back(length);
    if(m_lengths.size() <= window) return;
    const double fall = 1 - m_lengths.back() / m_lengths.front();
    m_lengths.pop_front();
    if(m_is_on ? fall < slow : fall > fast) set(!m_is_on);
  }

  // Writes or reads everything, see State_writer.
  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(m_lengths, m_is_on);
  }

private:
  static constexpr double gradient_of_nearly_tight = 0.1; // tangled curves have 0.2 to 0.5
  static constexpr std::size_t window = 10;
  // Falls of the length in a window. They differ, since longer edges make a curve a little shorter
  // by themselves: 3 % for both take 10 % more node-iterations on the paper's unknots (2026-11-23).
  static constexpr double slow = 0.02, fast = 0.05;

  void set(bool is_on)
  {
    m_is_on = is_on;
    m_lengths.clear();
  }

  std::deque<double> m_lengths; // of the last steps
  bool m_is_on = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_COARSE_PHASE_H
