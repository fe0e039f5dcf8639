// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SIMPLIFIED_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SIMPLIFIED_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Editable_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Strand_rerouting.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Simplification of a diagram. First, strands that pass above or below all others are moved to
// shortest paths until none becomes shorter; near-linear in practice. Then strands move at random
// between paths of equal length, which frees others, until this stops helping.
class Diagram_simplification
{
  using Slot = Editable_diagram::Slot;

public:
  explicit Diagram_simplification(const Planar_diagram& diagram)
      : m_diagram(diagram), m_rerouting(m_diagram)
  {}

  Planar_diagram result() const { return m_diagram.planar_diagram(); }
  std::size_t number_of_crossings() const { return m_diagram.number_of_crossings(); }

  // Shortens strands until none gets shorter.
  // \throws Run_stopped in a Watched_scope
  void shorten_strands()
  {
    for(std::size_t before = number_of_crossings() + 1; number_of_crossings() < before;) {
      before = number_of_crossings();
      for(Slot s = 0; s < m_diagram.number_of_slots(); ++s) {
        check_run_sometimes(m_calls);
        if(!m_diagram.is_used(s) || !m_diagram.is_outgoing(s)) continue;
        if(Editable_diagram::is_over(s) != Editable_diagram::is_over(m_diagram.mate(s)))
          m_rerouting.shorten(s, all);
        else
          m_rerouting.lift_component(s);
      }
    }
  }

  // Whether the work has reached its limit, after about two seconds. A move through a face with as
  // many arcs as the diagram takes linear time: the torus knot T(2, 4001) took 11 s.
  bool is_work_done() const { return m_rerouting.number_of_seen_arcs() > max_seen_arcs; }

  // Moves strands at random, a number of times per crossing, until the work is done.
  void shake(std::size_t moves_per_crossing, Random_source& random)
  {
    for(std::size_t k = moves_per_crossing * number_of_crossings(); k > 0 && !is_work_done(); --k) {
      check_run_sometimes(m_calls);
      const Slot s = static_cast<Slot>(random.index(m_diagram.number_of_slots()));
      const std::size_t length = 1 + random.index(max_shaken_length);
      if(m_diagram.is_used(s) && m_diagram.is_outgoing(s))
        m_rerouting.move_at_random(s, length, random);
    }
  }

private:
  static constexpr std::size_t all = ~std::size_t(0);
  static constexpr std::size_t max_seen_arcs =
      200000000; // 50 times as many as shorten the strands of a random polygon of 100,000 nodes
  static constexpr std::size_t max_shaken_length =
      10; // in crossings; with 4 more crossings remained

  Editable_diagram m_diagram;
  Strand_rerouting m_rerouting;
  unsigned m_calls = 0;
};

// Returns a diagram of the same link with few crossings. 128 tangled prime knots of up to 10
// crossings, seen from 10 directions each, all reach their crossing number, in 0.6 ms on average; a
// random polygon of 100,000 nodes goes from 15,349 to 2,700 crossings in half a second.
// \throws Run_stopped in a Watched_scope
inline Planar_diagram simplified_diagram(const Planar_diagram& diagram)
{
  constexpr std::size_t moves_per_crossing = 16;
  // Rounds without success: 30 sufficed for the 128 knots, and 10 left one crossing in one of them.
  constexpr std::size_t min_rounds = 3, max_rounds = 100, max_work = 20000;
  Random_source random(0);
  Diagram_simplification simplification(diagram);
  simplification.shorten_strands();
  for(std::size_t failures = 0; simplification.number_of_crossings() > 0; ++failures) {
    const std::size_t before = simplification.number_of_crossings();
    if(failures >= std::clamp(max_work / before, min_rounds, max_rounds)) break;
    if(simplification.is_work_done()) break;
    simplification.shake(moves_per_crossing, random);
    simplification.shorten_strands();
    if(simplification.number_of_crossings() < before) failures = 0;
  }
  return simplification.result();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_SIMPLIFIED_DIAGRAM_H
