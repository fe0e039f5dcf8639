// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_SHELLS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_SHELLS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/IO/Mesh_file.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// How the shells of a closed surface lie in one another, and whether they are turned accordingly: a
// shell within an odd number of others bounds a cavity and is turned inward, all others outward. A
// whole nest that is turned the wrong way is turned inside out; a shell that is turned like the one
// around it is ambiguous, since its author may have meant two solids or a cavity. Exact. Shells whose
// boxes are nested are tested pairwise, O(log n) each.
// \pre the shells do not intersect
class Mesh_shells
{
public:
  using Mesh = CGAL::Surface_mesh<Mesh_file::Point>;

  // `shell` gives the shell of every triangle, `is_mixed` whether its triangles disagreed
  Mesh_shells(Mesh_file& file,
              const std::vector<std::size_t>& shell,
              const std::vector<bool>& is_mixed)
      : m_file(file), m_is_mixed(is_mixed), m_shells(is_mixed.size())
  {
    for(std::size_t f = 0; f < shell.size(); ++f) m_shells[shell[f]].faces.push_back(f);
    for(Shell& s : m_shells) build(s);
    for(std::size_t i = 0; i < m_shells.size(); ++i) find_parent(i);
  }

  // Reports what is ambiguous, or else turns what is inside out and reports it.
  void orient()
  {
    for(std::size_t i = 0; i < m_shells.size(); ++i)
      if(is_ambiguous(i)) report_ambiguity(i);
    if(m_file.has_error) return;
    for(std::size_t i = 0; i < m_shells.size(); ++i)
      if(!is_right(i)) turn(i);
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Shell
  {
    std::vector<std::size_t> faces;
    Mesh mesh;
    CGAL::Bbox_3 box;
    std::unique_ptr<CGAL::Side_of_triangle_mesh<Mesh, Mesh_file::Kernel>> side;
    bool is_outward = true;
    std::size_t depth = 0, parent = none; // the innermost shell around
  };

  void build(Shell& shell) const
  {
    std::vector<Mesh_file::Face> faces;
    for(const std::size_t f : shell.faces) faces.push_back(m_file.faces[f]);
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(m_file.points, faces, shell.mesh);
    for(const auto v : shell.mesh.vertices())
      if(shell.mesh.is_isolated(v)) shell.mesh.remove_vertex(v);
    shell.mesh.collect_garbage();
    for(const auto& p : shell.mesh.points()) shell.box += p.bbox();
    shell.is_outward = CGAL::Polygon_mesh_processing::is_outward_oriented(shell.mesh);
    shell.side = std::make_unique<CGAL::Side_of_triangle_mesh<Mesh, Mesh_file::Kernel>>(shell.mesh);
  }

  void find_parent(std::size_t i)
  {
    std::vector<std::size_t> around;
    for(std::size_t j = 0; j < m_shells.size(); ++j)
      if(j != i && is_within(m_shells[i], m_shells[j])) around.push_back(j);
    m_shells[i].depth = around.size();
    for(const std::size_t j : around)
      if(m_shells[i].parent == none || is_within(m_shells[j], m_shells[m_shells[i].parent]))
        m_shells[i].parent = j;
  }

  static bool is_within(const Shell& inner, const Shell& outer)
  {
    const CGAL::Bbox_3 both = inner.box + outer.box;
    if(both != outer.box) return false;
    for(const auto& p : inner.mesh.points()) { // shells may touch in a vertex
      const CGAL::Bounded_side side = (*outer.side)(p);
      if(side != CGAL::ON_BOUNDARY) return side == CGAL::ON_BOUNDED_SIDE;
    }
    return false;
  }

  bool is_right(std::size_t i) const
  {
    return m_shells[i].is_outward == (m_shells[i].depth % 2 == 0);
  }

  bool is_ambiguous(std::size_t i) const
  {
    const std::size_t parent = m_shells[i].parent;
    return parent != none && is_right(i) != is_right(parent) && !m_is_mixed[i] &&
           !m_is_mixed[parent];
  }

  void report_ambiguity(std::size_t i) const
  {
    const std::size_t parent = m_shells[i].parent;
    m_file.add(Mesh_defect_kind::AMBIGUOUS_SHELLS,
               "shell " + std::to_string(i + 1) + " lies within shell " +
                   std::to_string(parent + 1) + " and is turned the same way",
               {}, {m_shells[i].faces.front(), m_shells[parent].faces.front()}, i + 1);
  }

  void turn(std::size_t i) const
  {
    for(const std::size_t f : m_shells[i].faces) std::swap(m_file.faces[f][1], m_file.faces[f][2]);
    if(!m_is_mixed[i])
      m_file.add(Mesh_defect_kind::INVERTED_ORIENTATION,
                 "shell " + std::to_string(i + 1) + " was turned inside out", {}, {}, i + 1);
  }

  Mesh_file& m_file;
  const std::vector<bool>& m_is_mixed;
  std::vector<Shell> m_shells;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_SHELLS_H
