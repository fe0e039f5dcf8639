// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PLANAR_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PLANAR_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesKnots
/// \headerfile CGAL/Volume_filling_curves/identify.h
///
/// The diagram of an oriented link, as planar diagram code (PD) in the convention of KnotTheory:
/// each crossing lists its four arcs counterclockwise, starting with the incoming lower strand. The
/// arcs 0 ... 2n - 1 of n crossings are numbered consecutively along each component, in its
/// orientation: arc k is followed by arc k + 1, and the last arc of a component by its first one.
struct Planar_diagram
{
  std::vector<std::array<std::uint32_t, 4>> crossings; ///< the arcs of each crossing
  std::size_t number_of_free_loops = 0; ///< components without crossings, at most 10^8
};

namespace internal {

// Strands of a diagram: the ends of its arcs, and the orientations of its components and upper
// strands. A component of two arcs that is the upper strand at both crossings can be read in either
// orientation, and lies above all others; it then passes the crossing with the smaller index from
// its first arc to its second one. Linear.
class Diagram_strands
{
public:
  static constexpr std::size_t none = ~std::size_t(0);

  // An end of an arc: the k-th of the four at a crossing.
  struct End
  {
    std::size_t crossing = none;
    std::size_t k = 0;
  };

  // \pre is_planar_diagram(diagram)
  explicit Diagram_strands(const Planar_diagram& diagram)
      : m_ends(2 * diagram.crossings.size()),
        m_first(m_ends.size(), none),
        m_signs(diagram.crossings.size())
  {
    for(std::size_t c = 0; c < diagram.crossings.size(); ++c)
      for(std::size_t k = 0; k < 4; ++k) {
        auto& ends = m_ends[diagram.crossings[c][k]];
        ends[ends[0].crossing == none ? 0 : 1] = {c, k};
      }
    for(std::size_t arc = 0; arc < m_ends.size(); arc = m_bounds.back())
      add_component(diagram, arc);
    for(std::size_t c = 0; c < m_signs.size(); ++c) m_signs[c] = sign(diagram, c);
    for(std::size_t arc = 0; arc < m_ends.size(); ++arc)
      if(does_leave(m_ends[arc][1])) std::swap(m_ends[arc][0], m_ends[arc][1]);
  }

  // components with crossings; the arcs of component c are first_arc(c) ... first_arc(c + 1) - 1
  std::size_t number_of_components() const { return m_bounds.size() - 1; }
  std::size_t first_arc(std::size_t c) const { return m_bounds[c]; }

  std::size_t next(std::size_t arc) const
  {
    return arc + 1 < m_ends.size() && m_first[arc + 1] == m_first[arc] ? arc + 1 : m_first[arc];
  }

  // the ends from which and to which an arc leads
  End source(std::size_t arc) const { return m_ends[arc][0]; }
  End target(std::size_t arc) const { return m_ends[arc][1]; }

  // +1 if the upper strand, turned counterclockwise, points along the lower one, else -1
  int sign(std::size_t crossing) const { return m_signs[crossing]; }

private:
  // the arcs along a component, from its first one on
  void add_component(const Planar_diagram& diagram, std::size_t first)
  {
    std::size_t last = first;
    std::vector<std::size_t> open{first};
    while(!open.empty()) {
      const std::size_t arc = open.back();
      open.pop_back();
      if(m_first[arc] != none) continue;
      m_first[arc] = first;
      last = (std::max)(last, arc);
      for(const End& end : m_ends[arc])
        open.push_back(diagram.crossings[end.crossing][(end.k + 2) % 4]);
    }
    m_bounds.push_back(last + 1);
  }

  int sign(const Planar_diagram& diagram, std::size_t c) const
  {
    const auto& x = diagram.crossings[c];
    const bool is_up = next(x[3]) == x[1], is_down = next(x[1]) == x[3];
    if(is_up != is_down) return is_up ? 1 : -1;
    return is_up_in_pair(diagram, c) ? 1 : -1;
  }

  // Orients the upper strand of a component of two arcs by its pass at the other crossing.
  bool is_up_in_pair(const Planar_diagram& diagram, std::size_t c) const
  {
    const std::size_t b = diagram.crossings[c][1], d = diagram.crossings[c][3];
    std::size_t other = c; // where both arcs end, too
    for(const End& end : m_ends[b])
      if(end.crossing != c) other = end.crossing;
    for(const End& end : m_ends[b]) {
      if(end.k == 0) return true;  // b goes below from here, so it has come from c
      if(end.k == 2) return false; // b has come from below, and goes to c
    }
    return (d < b) == (c < other);
  }

  bool does_leave(const End& end) const
  {
    return end.k == 2 || (end.k % 2 == 1 && (m_signs[end.crossing] > 0) == (end.k == 1));
  }

  std::vector<std::array<End, 2>> m_ends; // of each arc
  std::vector<std::size_t> m_first;       // the first arc of the component of each arc
  std::vector<std::size_t> m_bounds{0};
  std::vector<int> m_signs;
};

// Components, those without crossings included.
inline std::size_t number_of_components(const Planar_diagram& diagram)
{
  return Diagram_strands(diagram).number_of_components() + diagram.number_of_free_loops;
}

// The sum of the signs of the crossings.
inline int writhe(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  int sum = 0;
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) sum += strands.sign(c);
  return sum;
}

// The linking numbers of the components with crossings, in the order of their arcs, and then of
// those without.
inline std::vector<std::vector<int>> linking_matrix(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  const std::size_t n = number_of_components(diagram);
  std::vector<std::vector<int>> matrix(n, std::vector<int>(n, 0));
  std::vector<std::size_t> component; // of each arc
  for(std::size_t c = 0; c < strands.number_of_components(); ++c)
    component.resize(strands.first_arc(c + 1), c);
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    const auto& x = diagram.crossings[c];
    const std::size_t lower = component[x[0]], upper = component[x[1]];
    if(lower == upper) continue;
    matrix[lower][upper] += strands.sign(c);
    matrix[upper][lower] += strands.sign(c);
  }
  for(auto& row : matrix)
    for(int& number : row) number /= 2;
  return matrix;
}

// The diagram of the mirror image: upper and lower strands change places.
inline Planar_diagram mirror(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  Planar_diagram result = diagram;
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    auto& x = result.crossings[c];
    std::rotate(x.begin(), x.begin() + (strands.sign(c) > 0 ? 3 : 1), x.end());
  }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PLANAR_DIAGRAM_H
