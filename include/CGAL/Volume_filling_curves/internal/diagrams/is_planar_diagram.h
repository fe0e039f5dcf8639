// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Test whether crossings are the code of a planar diagram: each arc has two ends, the arcs of a
// component are numbered in its order, every lower strand runs forward, and the faces have Euler's
// number (codes of virtual knots do not). Linear.
class Planar_diagram_check
{
public:
  // The arcs are called by their numbers in the diagram plus `first_number`.
  explicit Planar_diagram_check(const Planar_diagram& diagram, std::size_t first_number = 0)
      : m_crossings(diagram.crossings), m_first_number(first_number)
  {}

  // Returns the reason why the crossings are no such code; empty if they are.
  std::string fault()
  {
    std::string fault = fault_of_ends();
    if(fault.empty()) fault = fault_of_order();
    if(fault.empty() && !has_euler_number())
      fault = "the crossings are those of a virtual link, not of a diagram in the plane";
    return fault;
  }

private:
  using Slot = std::size_t; // 4 c + k for the k-th arc end of crossing c
  static constexpr Slot none = ~Slot(0);

  std::size_t arc(Slot slot) const { return m_crossings[slot / 4][slot % 4]; }
  Slot other_end(Slot slot) const
  {
    const auto& ends = m_ends[arc(slot)];
    return ends[0] == slot ? ends[1] : ends[0];
  }
  static Slot rotated(Slot slot, std::size_t by) { return slot - slot % 4 + (slot + by) % 4; }

  std::string name(std::size_t arc) const { return "arc " + std::to_string(arc + m_first_number); }

  std::string fault_of_ends()
  {
    m_ends.assign(2 * m_crossings.size(), {none, none});
    for(Slot slot = 0; slot < 4 * m_crossings.size(); ++slot) {
      if(arc(slot) >= m_ends.size())
        return name(arc(slot)) + " is above the last one, " + name(m_ends.size() - 1);
      auto& ends = m_ends[arc(slot)];
      if(ends[1] != none) return name(arc(slot)) + " has more than two ends";
      ends[ends[0] == none ? 0 : 1] = slot;
    }
    return ""; // as many ends as arcs can have
  }

  // Follows each component from its first arc.
  std::string fault_of_order() const
  {
    for(std::size_t first = 0, end; first < m_ends.size(); first = end) {
      end = first;
      if(!walk(first, m_ends[first][0], end) && !walk(first, m_ends[first][1], end))
        return "the arcs from " + name(first) +
               " on are not numbered along their component, in the direction of its lower "
               "strands";
    }
    return "";
  }

  // Whether the component that leaves arc `first` at a slot is numbered in order; `end` is then
  // past its last arc.
  bool walk(std::size_t first, Slot slot, std::size_t& end) const
  {
    end = first;
    do {
      if(arc(slot) != end || slot % 4 == 2) return false; // out of order, or against a lower strand
      ++end;
      slot = other_end(rotated(slot, 2));
    } while(arc(slot) != first);
    return true;
  }

  bool has_euler_number() const
  {
    const std::size_t faces = number_of_cycles([this](Slot s) { return rotated(other_end(s), 1); });
    return faces == m_crossings.size() + 2 * number_of_parts();
  }

  template <typename Next>
  std::size_t number_of_cycles(Next next) const
  {
    std::vector<bool> is_seen(4 * m_crossings.size());
    std::size_t cycles = 0;
    for(Slot first = 0; first < is_seen.size(); ++first) {
      if(!is_seen[first]) ++cycles;
      for(Slot slot = first; !is_seen[slot]; slot = next(slot)) is_seen[slot] = true;
    }
    return cycles;
  }

  // Parts of the diagram, connected by arcs
  std::size_t number_of_parts() const
  {
    std::vector<bool> is_seen(m_crossings.size());
    std::size_t parts = 0;
    for(std::size_t first = 0; first < is_seen.size(); ++first) {
      if(!is_seen[first]) ++parts;
      std::vector<std::size_t> open{first};
      while(!open.empty()) {
        const std::size_t c = open.back();
        open.pop_back();
        if(is_seen[c]) continue;
        is_seen[c] = true;
        for(std::size_t k = 0; k < 4; ++k) open.push_back(other_end(4 * c + k) / 4);
      }
    }
    return parts;
  }

  const std::vector<std::array<std::uint32_t, 4>>& m_crossings;
  const std::size_t m_first_number;
  std::vector<std::array<Slot, 2>> m_ends; // of each arc
};

inline bool is_planar_diagram(const Planar_diagram& diagram)
{
  return Planar_diagram_check(diagram).fault().empty();
}

// \throws std::invalid_argument if the crossings are no planar diagram code, with a reason that
// numbers arcs from `first_number` on, or if there are more free loops than codes can number
inline void check_planar_diagram(const Planar_diagram& diagram, std::size_t first_number = 0)
{
  constexpr std::size_t max_free_loops = 100000000; // the largest number that read_number() reads
  if(diagram.number_of_free_loops > max_free_loops)
    throw std::invalid_argument("a diagram has at most 10^8 components without crossings, not " +
                                std::to_string(diagram.number_of_free_loops));
  const std::string fault = Planar_diagram_check(diagram, first_number).fault();
  if(!fault.empty())
    throw std::invalid_argument("the crossings are no planar diagram code: " + fault);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H
