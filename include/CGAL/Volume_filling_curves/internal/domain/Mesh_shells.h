// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_SHELLS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_SHELLS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Shells of a triangle mesh: its faces, connected across edges. Shells that only share a vertex are
// distinct. Near-linear time.
template <typename Mesh>
class Mesh_shells
{
  using Face = typename Mesh::Face_index;

public:
  // \pre the mesh has no garbage
  explicit Mesh_shells(const Mesh& mesh) : m_number_of_face(mesh.number_of_faces())
  {
    Disjoint_sets sets(mesh.number_of_faces());
    for(const auto h : mesh.halfedges())
      if(!mesh.is_border(mesh.edge(h)))
        sets.unite(index(mesh.face(h)), index(mesh.face(mesh.opposite(h))));
    for(const Face f : mesh.faces()) add(mesh, f, sets.find(index(f)));
  }

  std::size_t number() const { return m_boxes.size(); }

  // shells are numbered in the order of their first faces
  std::size_t shell(Face f) const { return m_number_of_face[index(f)]; }

  const std::vector<CGAL::Bbox_3>& boxes() const { return m_boxes; }

  // The volume that a closed shell encloses: of shells that enclose the same point, which are
  // nested, the innermost one has the least.
  double volume(std::size_t shell) const { return std::abs(m_volumes[shell]) / 6; }

private:
  static std::size_t index(Face f) { return static_cast<std::size_t>(f); }

  // `first` is the first face of the same shell.
  void add(const Mesh& mesh, Face f, std::size_t first)
  {
    const auto h = mesh.halfedge(f);
    if(first == index(f)) {
      m_number_of_face[first] = m_boxes.size();
      m_boxes.emplace_back();
      m_volumes.push_back(0);
      m_origins.push_back(to_vector(mesh.point(mesh.source(h))));
    }
    const std::size_t shell = m_number_of_face[index(f)] = m_number_of_face[first];
    Vector corners[3];
    auto side = h;
    for(Vector& corner : corners) {
      corner = to_vector(mesh.point(mesh.source(side))) - m_origins[shell];
      m_boxes[shell] += mesh.point(mesh.source(side)).bbox();
      side = mesh.next(side);
    }
    m_volumes[shell] += corners[0].dot(corners[1].cross(corners[2]));
  }

  std::vector<std::size_t> m_number_of_face;
  std::vector<CGAL::Bbox_3> m_boxes;
  std::vector<double> m_volumes; // six times, with signs
  std::vector<Vector> m_origins; // a vertex of each, for the rounding
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_SHELLS_H
