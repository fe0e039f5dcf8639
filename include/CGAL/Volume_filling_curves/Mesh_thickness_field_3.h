// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H
#define CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Face_tree.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
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

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Mesh_thickness_field_3` is a function of the point that is given by its values
 * at the vertices of a triangle mesh: at a point it has the barycentric value at the closest point
 * of the surface.
 *
 * The function is continuous wherever one point of the surface is closest. Values lie between the
 * least and the largest one of the closest face. The mesh is copied. Construction takes
 * \cgalBigO{n \log n} time for `n` faces, evaluation \cgalBigO{\log n} for most points. Evaluation
 * is computed in double arithmetic, and may be called concurrently.
 *
 * \tparam Kernel a model of \cgal's `Kernel`, as for `Triangle_mesh_domain_3`
 */
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Mesh_thickness_field_3
{
  using Faces = internal::Face_tree<Kernel>;
  using Mesh = typename Faces::Mesh;
  using Vector = internal::Vector;

public:
  /// the kernel's point type
  using Point_3 = typename Kernel::Point_3;

  /*!
   * constructs the function.
   *
   * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` with the kernel's points
   *
   * \param mesh the mesh
   * \param values the values at its vertices, in the order of `vertices(mesh)`
   *
   * \throws std::invalid_argument if a face is no triangle, there are fewer than two, or the values
   * are not as many as the vertices
   */
  template <typename TriangleMesh>
  Mesh_thickness_field_3(const TriangleMesh& mesh, const std::vector<double>& values)
  {
    if(faces(mesh).size() < 2 || !CGAL::is_triangle_mesh(mesh))
      throw std::invalid_argument(
          "the mesh has a face that is no triangle, or fewer than two faces");
    if(vertices(mesh).size() != values.size())
      throw std::invalid_argument("there is not one value per vertex");
    using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
    std::vector<std::pair<Vertex, typename Mesh::Vertex_index>> pairs;
    Mesh copy;
    CGAL::copy_face_graph(
        mesh, copy, CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
    std::unordered_map<Vertex, typename Mesh::Vertex_index> place(pairs.begin(), pairs.end());
    m_values.resize(values.size());
    std::size_t i = 0;
    for(const Vertex v : vertices(mesh)) m_values[place.at(v)] = values[i++];
    m_faces = std::make_unique<Faces>(std::move(copy));
  }

  /*!
   * constructs the function from a property map.
   *
   * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` with the kernel's points
   * \tparam VertexValueMap a model of `ReadablePropertyMap` whose key type is the mesh's vertex
   * descriptor and whose value type is convertible to `double`
   *
   * \param mesh the mesh
   * \param values the values at its vertices
   *
   * \throws std::invalid_argument if a face is no triangle, or there are fewer than two
   */
  template <typename TriangleMesh, typename VertexValueMap>
  Mesh_thickness_field_3(const TriangleMesh& mesh, const VertexValueMap& values)
      : Mesh_thickness_field_3(mesh, values_at_vertices(mesh, values))
  {}

  /// returns the value at the point of the surface that is closest to `p`.
  double operator()(const Point_3& p) const
  {
    const Vector x = internal::to_vector(p);
    const auto face = m_faces->nearest(x).face;
    const Mesh& mesh = m_faces->mesh();
    const auto h = mesh.halfedge(face);
    const std::array<typename Mesh::Vertex_index, 3> corners = {mesh.source(h), mesh.target(h),
                                                                mesh.target(mesh.next(h))};
    const std::array<double, 3> weights =
        internal::closest_barycentric_coordinates(x, {internal::to_vector(mesh.point(corners[0])),
                                                      internal::to_vector(mesh.point(corners[1])),
                                                      internal::to_vector(mesh.point(corners[2]))});
    double value = 0;
    for(std::size_t i = 0; i < 3; ++i) value += weights[i] * m_values[corners[i]];
    return value;
  }

private:
  template <typename TriangleMesh, typename VertexValueMap>
  static std::vector<double> values_at_vertices(const TriangleMesh& mesh,
                                                const VertexValueMap& values)
  {
    std::vector<double> result;
    for(const auto v : vertices(mesh)) result.push_back(get(values, v));
    return result;
  }

  std::unique_ptr<const Faces> m_faces; // behind a pointer, so that a function can be moved
  std::vector<double> m_values;         // by vertices of the copy
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H
