// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_ORIENTATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_ORIENTATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Face_edges.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Cuts a closed triangle soup into shells, the sets of triangles that are connected through edges, and
// turns the triangles of each shell so that neighbors agree, most of them as they were. Linear time
// after sorting.
// \pre every edge has exactly two triangles, and none intersect
class Mesh_orientation
{
public:
  using Face = std::array<std::size_t, 3>;

  explicit Mesh_orientation(std::vector<Face>& faces)
      : m_faces(faces), m_neighbors(faces.size()), m_shell(faces.size(), unseen)
  {
    std::vector<std::size_t> degrees(faces.size(), 0);
    Face_edges(faces).for_each_edge([&](auto first, auto) {
      const auto second = first + 1;
      const bool agrees = first->is_forward != second->is_forward;
      m_neighbors[first->face][degrees[first->face]++] = {second->face, agrees};
      m_neighbors[second->face][degrees[second->face]++] = {first->face, agrees};
    });
    m_is_turned.assign(faces.size(), false);
    for(std::size_t f = 0; f < faces.size(); ++f)
      if(m_shell[f] == unseen) collect_shell(f);
    for(std::size_t f = 0; f < faces.size(); ++f)
      if(m_is_turned[f]) std::swap(m_faces[f][1], m_faces[f][2]);
  }

  std::size_t number_of_shells() const { return m_number_of_shells; }

  // returns the shell of every triangle
  const std::vector<std::size_t>& shells() const { return m_shell; }

  // returns the triangles that were turned over
  std::vector<std::size_t> turned() const
  {
    std::vector<std::size_t> result;
    for(std::size_t f = 0; f < m_is_turned.size(); ++f)
      if(m_is_turned[f]) result.push_back(f);
    return result;
  }

private:
  static constexpr std::size_t unseen = static_cast<std::size_t>(-1);

  struct Neighbor
  {
    std::size_t face;
    bool agrees;
  };

  void collect_shell(std::size_t first)
  {
    std::vector<std::size_t> members = {first};
    m_shell[first] = m_number_of_shells;
    std::size_t turned = 0;
    for(std::size_t i = 0; i < members.size(); ++i) {
      for(const auto& [g, agrees] : m_neighbors[members[i]]) {
        const bool is_turned = m_is_turned[members[i]] == agrees;
        if(m_shell[g] != unseen) continue; // a closed surface in space is orientable
        m_shell[g] = m_number_of_shells;
        m_is_turned[g] = is_turned;
        turned += is_turned;
        members.push_back(g);
      }
    }
    if(2 * turned > members.size())
      for(const std::size_t f : members) m_is_turned[f] = !m_is_turned[f];
    ++m_number_of_shells;
  }

  std::vector<Face>& m_faces;
  std::vector<std::array<Neighbor, 3>> m_neighbors;
  std::vector<bool> m_is_turned;
  std::size_t m_number_of_shells = 0;
  std::vector<std::size_t> m_shell; // of every triangle
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_ORIENTATION_H
