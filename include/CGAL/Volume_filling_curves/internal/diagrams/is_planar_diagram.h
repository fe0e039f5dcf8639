// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
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
  explicit Planar_diagram_check(const Planar_diagram& diagram) : m_crossings(diagram.crossings) {}

  bool operator()()
  {
    if(!find_ends()) return false;
    return are_numbered_in_order() && has_euler_number();
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

  bool find_ends()
  {
    m_ends.assign(2 * m_crossings.size(), {none, none});
    for(Slot slot = 0; slot < 4 * m_crossings.size(); ++slot) {
      if(arc(slot) >= m_ends.size()) return false;
      auto& ends = m_ends[arc(slot)];
      if(ends[1] != none) return false;
      ends[ends[0] == none ? 0 : 1] = slot;
    }
    return true; // as many ends as arcs can have
  }

  // Whether each component, followed from its first arc, is numbered in order.
  bool are_numbered_in_order() const
  {
    for(std::size_t first = 0, end; first < m_ends.size(); first = end) {
      end = first;
      if(!walk(first, m_ends[first][0], end) && !walk(first, m_ends[first][1], end)) return false;
    }
    return true;
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
  std::vector<std::array<Slot, 2>> m_ends; // of each arc
};

inline bool is_planar_diagram(const Planar_diagram& diagram)
{
  return Planar_diagram_check(diagram)();
}

// \throws std::invalid_argument unless it is one
inline void check_planar_diagram(const Planar_diagram& diagram)
{
  if(!is_planar_diagram(diagram))
    throw std::invalid_argument("the crossings are no planar diagram code");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_IS_PLANAR_DIAGRAM_H
