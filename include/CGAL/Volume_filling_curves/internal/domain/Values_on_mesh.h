// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VALUES_ON_MESH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VALUES_ON_MESH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Face_tree.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Values at the vertices of a triangle mesh, which is copied, and their weights at a point: the
// barycentric coordinates of the closest point in its face.
template <typename Kernel, typename Value>
class Values_on_mesh
{
  using Faces = Face_tree<Kernel>;
  using Mesh = typename Faces::Mesh;

public:
  struct Corner
  {
    double weight;
    Value value;
  };

  // Takes the values in the order of `vertices(mesh)`. Throws std::invalid_argument if a face is no
  // triangle, there are fewer than two, the values are not as many as the vertices, or the mesh has
  // an invalid coordinate.
  template <typename TriangleMesh>
  Values_on_mesh(const TriangleMesh& mesh, const std::vector<Value>& values)
  {
    if(faces(mesh).size() < 2 || !CGAL::is_triangle_mesh(mesh))
      throw std::invalid_argument(
          "the mesh has a face that is not a triangle, or fewer than two faces");
    if(vertices(mesh).size() != values.size())
      throw std::invalid_argument("there is not one value per vertex");
    using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
    std::vector<std::pair<Vertex, typename Mesh::Vertex_index>> pairs;
    Mesh copy;
    CGAL::copy_face_graph(
        mesh, copy, CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
    std::unordered_map<Vertex, typename Mesh::Vertex_index> position(pairs.begin(), pairs.end());
    for(const auto& p : copy.points())
      if(const auto fault = coordinate_fault(p)) throw std::invalid_argument(fault->message);
    m_values.resize(copy.number_of_vertices());
    std::size_t i = 0;
    for(const Vertex v : vertices(mesh)) {
      const auto of_copy = position.find(v); // none for a vertex without faces
      if(of_copy != position.end()) m_values[of_copy->second] = values[i];
      ++i;
    }
    m_faces = std::make_unique<Faces>(std::move(copy));
  }

  // Throws std::invalid_argument if a coordinate is not finite or beyond 1e150: squared distances
  // overflow, and no face is the nearest.
  std::array<Corner, 3> at(const Vector& x) const
  {
    check_range(x, "the point");
    const auto face = m_faces->nearest(x).face;
    const Mesh& mesh = m_faces->mesh();
    const auto h = mesh.halfedge(face);
    const std::array<typename Mesh::Vertex_index, 3> corners = {mesh.source(h), mesh.target(h),
                                                                mesh.target(mesh.next(h))};
    const std::array<double, 3> weights = closest_barycentric_coordinates(
        x, {to_vector(mesh.point(corners[0])), to_vector(mesh.point(corners[1])),
            to_vector(mesh.point(corners[2]))});
    return {Corner{weights[0], m_values[corners[0]]}, Corner{weights[1], m_values[corners[1]]},
            Corner{weights[2], m_values[corners[2]]}};
  }

  template <typename TriangleMesh, typename VertexValueMap>
  static std::vector<Value> at_vertices(const TriangleMesh& mesh, const VertexValueMap& values)
  {
    std::vector<Value> result;
    for(const auto v : vertices(mesh)) result.push_back(get(values, v));
    return result;
  }

private:
  std::unique_ptr<const Faces> m_faces; // a pointer, since the mesh is copied first
  std::vector<Value> m_values;          // by vertices of the copy
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_VALUES_ON_MESH_H
