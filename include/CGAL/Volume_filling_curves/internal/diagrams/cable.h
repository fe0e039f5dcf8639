// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CABLE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CABLE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Cable of a diagram: each strand is replaced by parallel strands, with the framing of the diagram.
// Each crossing becomes a square grid of crossings with its own arcs.
class Cable
{
public:
  Cable(const Planar_diagram& diagram, std::size_t strands)
      : m_diagram(diagram), m_strands(diagram), m_count(strands)
  {}

  Planar_diagram operator()() const
  {
    Planar_diagram result;
    result.number_of_free_loops = m_count * m_diagram.number_of_free_loops;
    for(std::size_t c = 0; c < m_diagram.crossings.size(); ++c)
      for(std::size_t row = 0; row < m_count; ++row)
        for(std::size_t column = 0; column < m_count; ++column)
          result.crossings.push_back(crossing(c, row, column));
    return result;
  }

private:
  using Arcs = std::array<std::uint32_t, 4>;

  // Lower strands are columns, counted from the left, and upper ones rows, counted from the left of
  // their own direction: from above if they go to the right, which is the positive crossing.
  Arcs crossing(std::size_t c, std::size_t row, std::size_t column) const
  {
    const bool is_positive = m_strands.sign(c) > 0;
    const std::size_t from_below = is_positive ? m_count - 1 - row : row;
    const std::size_t from_in = is_positive ? column : m_count - 1 - column;
    const Arcs& x = m_diagram.crossings[c];
    const std::uint32_t over_in = x[is_positive ? 3 : 1];
    const std::uint32_t lower = arc(x[0], column, from_below), upper = arc(over_in, row, from_in);
    const std::uint32_t lower_out = next(x[0], column, from_below);
    const std::uint32_t upper_out = next(over_in, row, from_in);
    return is_positive ? Arcs{lower, upper_out, lower_out, upper}
                       : Arcs{lower, upper, lower_out, upper_out};
  }

  // The part of a strand of the cable beside an arc, or `step` crossings further in the grid at its
  // end. Arc k has the parts k m ... k m + m - 1 on each of the m strands.
  std::uint32_t arc(std::size_t k, std::size_t strand, std::size_t step) const
  {
    std::size_t component = 0;
    while(m_strands.first_arc(component + 1) <= k) ++component;
    const std::size_t first = m_strands.first_arc(component);
    const std::size_t length = m_strands.first_arc(component + 1) - first;
    return static_cast<std::uint32_t>(m_count * (m_count * first + strand * length + (k - first)) +
                                      step);
  }

  std::uint32_t next(std::size_t k, std::size_t strand, std::size_t step) const
  {
    return step + 1 < m_count ? arc(k, strand, step + 1) : arc(m_strands.next(k), strand, 0);
  }

  const Planar_diagram& m_diagram;
  const Diagram_strands m_strands;
  const std::size_t m_count;
};

inline Planar_diagram cable(const Planar_diagram& diagram, std::size_t strands)
{
  return strands == 1 ? diagram : Cable(diagram, strands)();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CABLE_H
