// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KAUFFMAN_BRACKET_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KAUFFMAN_BRACKET_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Disk_sweep.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polynomial_work.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Kauffman bracket <D> in A, of a connected diagram without nugatory crossings or of its cable: a
// crossing is A times one smoothing plus 1/A times the other one, a loop -A^2 - A^-2, and the empty
// diagram 1. A disk sweeps over the diagram; its content is a combination of pairings of the arcs
// on its boundary, of which 2k arcs have at most a Catalan number, (2k)! / (k! (k + 1)!).
class Kauffman_bracket
{
public:
  explicit Kauffman_bracket(Polynomial_work& work) : m_work(work) {}

  Laurent_polynomial operator()(const Planar_diagram& diagram)
  {
    m_states = {{Pairing{}, Laurent_polynomial::monomial(0)}};
    m_width = 0;
    const Disk_sweep sweep(diagram);
    for(const Sweep_step& step : sweep.steps()) take_in(step);
    const Laurent_polynomial sum = m_states.empty() ? Laurent_polynomial() : m_states[0].factor;
    Laurent_polynomial bracket; // the factors are in A^2, without 1/A for each crossing
    bracket.add_multiple(sum.with_exponents_times(2), -static_cast<int>(diagram.crossings.size()));
    return bracket;
  }

private:
  static constexpr std::size_t max_width = 28; // 14 pairs have 2,674,440 pairings

  using Index = std::uint8_t;
  using Pairing = std::array<Index, max_width + 4>; // the partner of each arc, 0 beyond the width

  struct State
  {
    Pairing pairing;
    Laurent_polynomial factor;
  };

  // A smoothed state, whose factor is that of an old one times A^2 or 1, times loops.
  struct Change
  {
    Pairing pairing;
    std::uint32_t state;
    Index exponent, loops;
  };

  void take_in(const Sweep_step& step)
  {
    const std::size_t width = m_width + 4 - 2 * step.attached;
    if(width > max_width) throw Polynomial_limit();
    std::vector<Change> changes;
    changes.reserve(2 * m_states.size());
    for(std::size_t s = 0; s < m_states.size(); ++s)
      for(const Index exponent : {Index(0), Index(1)})
        changes.push_back(smoothed(static_cast<std::uint32_t>(s), step, exponent));
    m_width = width;
    collect(changes);
  }

  // The smoothing of A joins the ends 0 and 1 and 2 and 3 of the crossing, counterclockwise from
  // the incoming lower strand; the one of 1/A joins the ends 1 and 2, 3 and 0.
  Change smoothed(std::uint32_t s, const Sweep_step& step, Index exponent) const
  {
    const std::size_t old = m_width, attached = step.attached;
    std::array<Index, max_width + 8> partners{}; // of the old arcs, and of the ends from old on
    for(std::size_t i = 0; i < old; ++i)
      partners[i] = static_cast<Index>(
          (m_states[s].pairing[(i + step.rotation) % old] + old - step.rotation) % old);
    for(std::size_t k = 0; k < 4; ++k) partners[old + k] = static_cast<Index>(old + (k ^ 1));
    if(exponent == 0)
      for(std::size_t k = 0; k < 4; ++k) partners[old + k] = static_cast<Index>(old + (3 - k));
    Change change{{}, s, exponent, 0};
    for(std::size_t i = 0; i < attached; ++i)
      glue(partners, i, old + (step.last_end + attached - 1 - i) % 4, change.loops);
    number_anew(partners, step, change.pairing);
    return change;
  }

  static void glue(std::array<Index, max_width + 8>& partners,
                   std::size_t i,
                   std::size_t j,
                   Index& loops)
  {
    const Index p = partners[i], q = partners[j];
    if(p == j) {
      ++loops;
      return;
    }
    partners[p] = q;
    partners[q] = p;
  }

  // The boundary begins with the ends that were not attached, followed by the old arcs.
  void number_anew(const std::array<Index, max_width + 8>& partners,
                   const Sweep_step& step,
                   Pairing& pairing) const
  {
    const std::size_t old = m_width, attached = step.attached, added = 4 - attached;
    const auto old_index = [&](std::size_t i) {
      return i < added ? old + (step.last_end + attached + i) % 4 : i - added + attached;
    };
    const auto new_index = [&](std::size_t i) {
      return i < old ? i - attached + added : (i - old + 8 - step.last_end - attached) % 4;
    };
    for(std::size_t i = 0; i < old + added - attached; ++i)
      pairing[i] = static_cast<Index>(new_index(partners[old_index(i)]));
  }

  void collect(std::vector<Change>& changes)
  {
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& c, const Change& d) { return c.pairing < d.pairing; });
    std::vector<State> states;
    for(const Change& c : changes) {
      if(states.empty() || states.back().pairing != c.pairing) states.push_back({c.pairing, {}});
      Laurent_polynomial p = m_states[c.state].factor;
      m_work.use(1 + static_cast<std::size_t>(p.end() - p.low()));
      for(int i = 0; i < c.loops; ++i) p = times_loop(p);
      states.back().factor.add_multiple(p, c.exponent);
    }
    m_states = std::move(states);
  }

  static Laurent_polynomial times_loop(const Laurent_polynomial& p)
  {
    Laurent_polynomial product;
    product.add_multiple(p, 1, -1);
    product.add_multiple(p, -1, -1);
    return product;
  }

  std::vector<State> m_states; // sorted by pairings, none twice
  std::size_t m_width = 0;     // arcs on the boundary
  Polynomial_work& m_work;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KAUFFMAN_BRACKET_H
