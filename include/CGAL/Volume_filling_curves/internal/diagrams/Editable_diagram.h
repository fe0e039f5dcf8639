// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_EDITABLE_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_EDITABLE_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Diagram in which crossings are added and removed, each in constant time. The arc ends of crossing
// c are the slots 4 c ... 4 c + 3, counterclockwise from the incoming lower strand; each is joined
// to the slot at the other end of its arc. A slot also stands for its arc directed away from the
// crossing, and for the face on the left of that.
class Editable_diagram
{
public:
  using Slot = std::uint32_t;
  static constexpr Slot none = ~Slot(0);

  // \pre is_planar_diagram(diagram)
  explicit Editable_diagram(const Planar_diagram& diagram)
      : m_mates(4 * diagram.crossings.size(), none),
        m_is_positive(diagram.crossings.size()),
        m_is_used(diagram.crossings.size(), true),
        m_number_of_crossings(diagram.crossings.size()),
        m_number_of_free_loops(diagram.number_of_free_loops)
  {
    const Diagram_strands strands(diagram);
    for(std::size_t arc = 0; arc < 2 * diagram.crossings.size(); ++arc)
      join(slot(strands.source(arc)), slot(strands.target(arc)));
    for(std::size_t c = 0; c < diagram.crossings.size(); ++c)
      m_is_positive[c] = strands.sign(c) > 0;
  }

  std::size_t number_of_crossings() const { return m_number_of_crossings; }
  std::size_t number_of_slots() const { return m_mates.size(); }
  bool is_used(Slot s) const { return m_is_used[s / 4]; }

  Slot mate(Slot s) const { return m_mates[s]; }
  static Slot rotated(Slot s, unsigned by) { return (s & ~Slot(3)) | ((s + by) & 3); }
  static Slot across(Slot s) { return s ^ 2; } // on the same strand
  static bool is_over(Slot s) { return s % 2 == 1; }
  bool is_outgoing(Slot s) const
  {
    return s % 4 == 2 || (is_over(s) && m_is_positive[s / 4] == (s % 4 == 1));
  }

  // the next arc counterclockwise around the face
  Slot next_around_face(Slot s) const { return rotated(mate(s), 3); }

  void join(Slot a, Slot b) { m_mates[a] = b, m_mates[b] = a; }

  // Adds a crossing on the arc that leaves slot s with a strand that comes from the left. Returns
  // the slot at which the new strand arrives.
  Slot insert_crossing(Slot s, bool is_new_strand_over)
  {
    const bool is_along = is_outgoing(s);
    const Slot t = mate(s), first = new_crossing();
    // where the old arc arrives from s; the new strand arrives at the slot that is clockwise of it
    const Slot from_s = is_new_strand_over ? (is_along ? first : first + 2) : first + 1;
    m_is_positive[first / 4] = is_along == is_new_strand_over;
    join(s, from_s);
    join(across(from_s), t);
    return rotated(from_s, 3);
  }

  // Removes the strand through slot s from its crossing, and joins the two parts of the other
  // strand.
  void remove_crossing(Slot s)
  {
    const Slot p = rotated(s, 1), q = across(p), before = mate(p), after = mate(q);
    if(before == q)
      ++m_number_of_free_loops;
    else
      join(before, after);
    m_is_used[s / 4] = false;
    m_unused.push_back(s / 4);
    --m_number_of_crossings;
  }

  void add_free_loop() { ++m_number_of_free_loops; }

  Planar_diagram planar_diagram() const
  {
    Planar_diagram result;
    result.number_of_free_loops = m_number_of_free_loops;
    std::vector<std::uint32_t> arcs(m_mates.size(), none);
    std::uint32_t arc = 0;
    for(Slot first = 0; first < m_mates.size(); ++first) {
      if(!is_used(first) || !is_outgoing(first) || arcs[first] != none) continue;
      Slot s = first_of_component(first);
      for(; arcs[s] == none; s = across(mate(s))) arcs[s] = arcs[mate(s)] = arc++;
    }
    for(Slot s = 0; s < m_mates.size(); s += 4)
      if(is_used(s)) result.crossings.push_back({arcs[s], arcs[s + 1], arcs[s + 2], arcs[s + 3]});
    return result;
  }

private:
  static Slot slot(const Diagram_strands::End& end)
  {
    return static_cast<Slot>(4 * end.crossing + end.k);
  }

  // The first arc of a component: the one after its crossing with the smallest number, except for a
  // component of two arcs above all others, see Diagram_strands.
  Slot first_of_component(Slot s) const
  {
    const Slot next = across(mate(s));
    const bool is_pair_above = is_over(s) && is_over(next) && across(mate(next)) == s;
    return is_pair_above ? next : s;
  }

  Slot new_crossing()
  {
    ++m_number_of_crossings;
    std::size_t c = m_is_used.size();
    if(!m_unused.empty()) {
      c = m_unused.back();
      m_unused.pop_back();
      m_is_used[c] = true;
    } else {
      m_is_used.push_back(true);
      m_is_positive.push_back(false);
      m_mates.resize(m_mates.size() + 4, none);
    }
    return static_cast<Slot>(4 * c);
  }

  std::vector<Slot> m_mates;
  std::vector<bool> m_is_positive, m_is_used; // of each crossing
  std::vector<std::size_t> m_unused;
  std::size_t m_number_of_crossings, m_number_of_free_loops;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_EDITABLE_DIAGRAM_H
