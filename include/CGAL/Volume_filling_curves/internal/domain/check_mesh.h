// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_MESH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_MESH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/intersecting_faces.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_holes.h>
#include <CGAL/Volume_filling_curves/internal/domain/nested_shells.h>

#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Check of a mesh that should bound a domain, which reports the first kind of fault found and the
// number of its faults. Vertices and faces are numbered from 0, in the order of the original mesh.
// Copying changes the order of vertices; the check takes a function that returns the original
// number of a vertex.
// \pre all faces are triangles
template <typename Mesh>
class Mesh_check
{
  using Vertex = typename Mesh::Vertex_index;
  using Face = typename Mesh::Face_index;

public:
  Mesh_check(const Mesh& mesh, std::function<std::size_t(Vertex)> number_of)
      : m_mesh(mesh), m_number_of(std::move(number_of))
  {}

  // \throws std::invalid_argument if it is not closed, or if a face is invalid
  void check_faces() const
  {
    check_coordinates();
    if(const auto fault = size_fault(m_mesh.points())) refuse(*fault, 1, {}, {});
    check_shapes();
    const auto holes = holes_of(m_mesh);
    if(!holes.empty())
      refuse(hole_fault(m_mesh, holes[0]), holes.size(), holes[0].vertices, {},
             "Polygon_mesh_processing::triangulate_hole() closes holes");
  }

  // \throws std::invalid_argument if faces intersect, or if the orientations of nested shells leave
  // the inside undefined \pre check_faces() has not thrown
  void check_shells() const
  {
    const auto pairs = intersecting_faces(m_mesh, Points_in_run<Mesh>(m_mesh));
    if(!pairs.empty())
      refuse(intersection_fault(m_mesh, pairs[0]), pairs.size(), {},
             {pairs[0].first, pairs[0].second}, "alpha_wrap_3() makes a mesh without");
    const auto shells = nested_shells(m_mesh);
    std::vector<std::size_t> ambiguous;
    for(std::size_t i = 0; i < shells.size(); ++i)
      if(is_ambiguous(shells, i)) ambiguous.push_back(i);
    if(ambiguous.empty()) return;
    const auto& inner = shells[ambiguous[0]];
    refuse(ambiguity_fault(shells, ambiguous[0]), ambiguous.size(), {},
           {inner.faces[0], shells[*inner.parent].faces[0]},
           "if it bounds a cavity, orient it inward");
  }

private:
  void check_coordinates() const
  {
    for(const Vertex v : m_mesh.vertices())
      if(const auto fault = coordinate_fault(m_mesh.point(v))) refuse(*fault, 1, {v}, {});
  }

  void check_shapes() const
  {
    std::vector<Face> flat;
    for(const Face f : m_mesh.faces())
      if(CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, m_mesh)) flat.push_back(f);
    if(flat.empty()) return;
    const auto corners = corners_of(m_mesh, flat[0]);
    refuse(flat_face_fault(m_mesh.point(corners[0]), m_mesh.point(corners[1]),
                           m_mesh.point(corners[2])),
           flat.size(), {corners.begin(), corners.end()}, {flat[0]},
           "Polygon_mesh_processing::remove_degenerate_faces() removes them");
  }

  // " (faces 3 7)", with at most ten of the numbers
  template <typename Index, typename Number>
  static std::string list(const char* one,
                          const char* many,
                          const std::vector<Index>& indices,
                          const Number& number_of)
  {
    constexpr std::size_t max_listed = 10;
    if(indices.empty()) return "";
    std::string text = std::string(" (") + (indices.size() == 1 ? one : many);
    for(std::size_t i = 0; i < (std::min)(indices.size(), max_listed); ++i)
      text += ' ' + std::to_string(number_of(indices[i]));
    return text + (indices.size() > max_listed ? " ...)" : ")");
  }

  [[noreturn]] void refuse(const Mesh_fault& fault,
                           std::size_t number,
                           const std::vector<Vertex>& vertices,
                           const std::vector<Face>& faces,
                           const std::string& remedy = "") const
  {
    std::string text = fault.kind + ": " + fault.message;
    if(number > 1) text += ", the first of " + std::to_string(number);
    if(!remedy.empty()) text += "; " + remedy;
    const auto face_number = [](Face f) { return static_cast<std::size_t>(f); };
    throw std::invalid_argument(text + list("vertex", "vertices", vertices, m_number_of) +
                                list("face", "faces", faces, face_number));
  }

  const Mesh& m_mesh;
  std::function<std::size_t(Vertex)> m_number_of;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_CHECK_MESH_H
