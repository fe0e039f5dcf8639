// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_PIECES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_PIECES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_faces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Connected diagrams that are prime, whose connected sum or split union the link is: none has a
// nugatory crossing, or two arcs between the same two faces.
struct Diagram_pieces
{
  std::vector<Planar_diagram> diagrams;
  std::size_t number_of_splits = 0; // of the diagram: its connected parts but one
};

// Takes a diagram apart. A crossing is nugatory if two of its opposite corners belong to the same
// face; if it is smoothed, the diagram falls into two whose connected sum is the link. So it does
// if two arcs between the same two faces are cut, and the loose ends joined on either side of the
// circle through both. Near-linear for each crossing and cut.
class Diagram_divider
{
public:
  explicit Diagram_divider(const Planar_diagram& diagram) : m_diagram(diagram) {}

  Diagram_pieces operator()()
  {
    Diagram_pieces pieces;
    const Diagram_faces faces(m_diagram);
    const std::size_t parts = faces.number_of_parts() + m_diagram.number_of_free_loops;
    pieces.number_of_splits = parts == 0 ? 0 : parts - 1;
    while(smooth_nugatory_crossing() || cut_connected_sum()) check_run();
    add_parts(pieces.diagrams);
    return pieces;
  }

private:
  using Arcs = std::array<std::uint32_t, 4>;

  struct Signed_crossing
  {
    Arcs arcs;
    int sign;

    std::uint32_t& in() { return arcs[sign > 0 ? 3 : 1]; } // of the upper strand
    std::uint32_t& out() { return arcs[sign > 0 ? 1 : 3]; }
  };

  std::vector<Signed_crossing> crossings() const
  {
    const Diagram_strands strands(m_diagram);
    std::vector<Signed_crossing> result;
    for(std::size_t c = 0; c < m_diagram.crossings.size(); ++c)
      result.push_back({m_diagram.crossings[c], strands.sign(c)});
    return result;
  }

  // returns false if there is none
  bool smooth_nugatory_crossing()
  {
    const Diagram_faces faces(m_diagram);
    for(std::size_t c = 0; c < m_diagram.crossings.size(); ++c) {
      const auto face = [&](std::size_t k) { return faces.face(c, k); };
      if(face(0) != face(2) && face(1) != face(3)) continue;
      smooth(c);
      return true;
    }
    return false;
  }

  // Smooths a crossing: each incoming strand continues as the other outgoing one.
  void smooth(std::size_t c)
  {
    auto crossings = this->crossings();
    Signed_crossing smoothed = crossings[c];
    crossings.erase(crossings.begin() + static_cast<std::ptrdiff_t>(c));
    join(smoothed.arcs[0], smoothed.out(), crossings);
    join(smoothed.in(), smoothed.arcs[2], crossings);
    m_diagram = numbered_anew(std::move(crossings), m_diagram.crossings.size() * 2);
  }

  // returns false if no two arcs lie between the same faces
  // \pre there is no nugatory crossing
  bool cut_connected_sum()
  {
    const Diagram_faces faces(m_diagram);
    const Diagram_strands strands(m_diagram);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> arcs;
    for(std::size_t arc = 0; arc < 2 * m_diagram.crossings.size(); ++arc) {
      const auto [crossing, k] = strands.source(arc);
      const std::size_t left = faces.face(crossing, k), right = faces.face(crossing, k + 3);
      const auto [other, is_new] = arcs.emplace(std::minmax(left, right), arc);
      if(is_new) continue;
      const auto source = strands.source(other->second);
      auto crossings = this->crossings();
      std::swap(crossings[crossing].arcs[k], crossings[source.crossing].arcs[source.k]);
      m_diagram = numbered_anew(std::move(crossings), 2 * m_diagram.crossings.size());
      return true;
    }
    return false;
  }

  static void join(std::uint32_t arc, std::uint32_t next, std::vector<Signed_crossing>& crossings)
  {
    for(Signed_crossing& x : crossings) std::replace(x.arcs.begin(), x.arcs.end(), next, arc);
  }

  void add_parts(std::vector<Planar_diagram>& diagrams) const
  {
    const Diagram_faces faces(m_diagram);
    const auto all = crossings();
    std::vector<std::vector<Signed_crossing>> parts(faces.number_of_parts());
    for(std::size_t c = 0; c < all.size(); ++c)
      parts[faces.part(faces.face(c, 0))].push_back(all[c]);
    for(auto& part : parts) diagrams.push_back(numbered_anew(std::move(part), 2 * all.size()));
  }

  // The diagram of crossings whose arcs have any numbers below a bound.
  static Planar_diagram numbered_anew(std::vector<Signed_crossing> crossings, std::size_t bound)
  {
    constexpr auto none = ~std::uint32_t(0);
    std::vector<std::uint32_t> next(bound, none), number(bound, none);
    for(Signed_crossing& x : crossings) {
      next[x.arcs[0]] = x.arcs[2];
      next[x.in()] = x.out();
    }
    std::uint32_t count = 0;
    for(const Signed_crossing& x : crossings)
      for(std::uint32_t arc : x.arcs)
        for(; number[arc] == none; arc = next[arc]) number[arc] = count++;
    Planar_diagram diagram;
    for(const Signed_crossing& x : crossings)
      diagram.crossings.push_back(
          {number[x.arcs[0]], number[x.arcs[1]], number[x.arcs[2]], number[x.arcs[3]]});
    return diagram;
  }

  Planar_diagram m_diagram;
};

// \throws Run_stopped in a Watched_scope
inline Diagram_pieces diagram_pieces(const Planar_diagram& diagram)
{
  return Diagram_divider(diagram)();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_PIECES_H
