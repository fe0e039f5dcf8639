// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_FACES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_FACES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Faces of a diagram in two colors, as on a checkerboard, and its connected parts. Corner k of a
// crossing lies between its arcs k and k + 1. The outer face counts once for each part. Linear.
class Diagram_faces
{
public:
  static constexpr std::size_t none = ~std::size_t(0);

  // \pre is_planar_diagram(diagram)
  explicit Diagram_faces(const Planar_diagram& diagram)
      : m_mates(4 * diagram.crossings.size(), none), m_faces(m_mates.size(), none)
  {
    std::vector<std::size_t> ends(2 * diagram.crossings.size(), none);
    for(std::size_t slot = 0; slot < m_mates.size(); ++slot) {
      std::size_t& end = ends[diagram.crossings[slot / 4][slot % 4]];
      if(end == none)
        end = slot;
      else
        m_mates[m_mates[slot] = end] = slot;
    }
    for(std::size_t slot = 0; slot < m_mates.size(); ++slot)
      if(m_faces[slot] == none) walk(slot);
    color();
  }

  std::size_t number_of_faces() const { return m_parts.size(); }
  std::size_t number_of_parts() const { return m_number_of_parts; }
  std::size_t face(std::size_t crossing, std::size_t corner) const
  {
    return m_faces[4 * crossing + corner % 4];
  }
  std::size_t part(std::size_t face) const { return m_parts[face]; }
  bool is_black(std::size_t face) const { return m_is_black[face]; }

private:
  void walk(std::size_t start)
  {
    for(std::size_t slot = start; m_faces[slot] == none; slot = clockwise(m_mates[slot]))
      m_faces[slot] = m_parts.size();
    m_parts.push_back(none);
  }

  static std::size_t clockwise(std::size_t slot) { return slot - slot % 4 + (slot + 3) % 4; }

  // Corners side by side differ in color.
  void color()
  {
    m_is_black.resize(m_parts.size(), false);
    std::vector<bool> is_seen(m_faces.size() / 4, false);
    for(std::size_t first = 0; first < is_seen.size(); ++first) {
      if(is_seen[first]) continue;
      m_is_black[face(first, 0)] = true;
      std::vector<std::size_t> open{4 * first};
      while(!open.empty()) {
        const std::size_t slot = open.back(), crossing = slot / 4;
        open.pop_back();
        if(is_seen[crossing]) continue;
        is_seen[crossing] = true;
        const bool is_black = m_is_black[m_faces[slot]];
        for(std::size_t k = 0; k < 4; ++k) {
          m_parts[face(crossing, k)] = m_number_of_parts;
          m_is_black[face(crossing, k)] = is_black == (k % 2 == slot % 2);
          open.push_back(clockwise(m_mates[4 * crossing + k])); // on the same face as this corner
        }
      }
      ++m_number_of_parts;
    }
  }

  std::vector<std::size_t> m_mates, m_faces; // per arc end: the other end, and the face on its left
  std::vector<std::size_t> m_parts;          // of each face
  std::vector<bool> m_is_black;              // each face
  std::size_t m_number_of_parts = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_FACES_H
