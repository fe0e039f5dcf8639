// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MESH_FIELDS_3_H
#define CGAL_VOLUME_FILLING_CURVES_MESH_FIELDS_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Values_on_mesh.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
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
  using Values = internal::Values_on_mesh<Kernel, double>;

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
      : m_values(mesh, values)
  {}

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
      : Mesh_thickness_field_3(mesh, Values::at_vertices(mesh, values))
  {}

  /// returns the value at the point of the surface that is closest to `p`.
  double operator()(const Point_3& p) const
  {
    double value = 0;
    for(const auto& corner : m_values.at(internal::to_vector(p)))
      value += corner.weight * corner.value;
    return value;
  }

private:
  Values m_values;
};

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Mesh_direction_field_3` is a direction at each point that is given by vectors
 * at the vertices of a triangle mesh: the barycentric mean at the closest point of the surface.
 *
 * The sign of a vector does not matter: those at the corners of a face are turned so that none
 * points away from the first. Their lengths are weights; where all are zero there is no direction.
 * The mesh is copied. Construction takes \cgalBigO{n \log n} time for `n` faces, evaluation
 * \cgalBigO{\log n} for most points. Evaluation is computed in double arithmetic, and may be called
 * concurrently.
 *
 * \tparam Kernel a model of \cgal's `Kernel`, as for `Triangle_mesh_domain_3`
 */
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Mesh_direction_field_3
{
  using Values = internal::Values_on_mesh<Kernel, std::array<double, 3>>;

public:
  /// the kernel's point type
  using Point_3 = typename Kernel::Point_3;

  /*!
   * constructs the function.
   *
   * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` with the kernel's points
   *
   * \param mesh the mesh
   * \param vectors the vectors at its vertices, in the order of `vertices(mesh)`
   *
   * \throws std::invalid_argument if a face is no triangle, there are fewer than two, or the
   * vectors are not as many as the vertices
   */
  template <typename TriangleMesh>
  Mesh_direction_field_3(const TriangleMesh& mesh,
                         const std::vector<std::array<double, 3>>& vectors)
      : m_values(mesh, vectors)
  {}

  /*!
   * constructs the function from a property map.
   *
   * \tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` with the kernel's points
   * \tparam VertexVectorMap a model of `ReadablePropertyMap` whose key type is the mesh's vertex
   * descriptor and whose value type is convertible to `std::array<double, 3>`
   *
   * \param mesh the mesh
   * \param vectors the vectors at its vertices
   *
   * \throws std::invalid_argument if a face is no triangle, or there are fewer than two
   */
  template <typename TriangleMesh, typename VertexVectorMap>
  Mesh_direction_field_3(const TriangleMesh& mesh, const VertexVectorMap& vectors)
      : Mesh_direction_field_3(mesh, Values::at_vertices(mesh, vectors))
  {}

  /// returns a vector along the direction at the point of the surface that is closest to `p`.
  std::array<double, 3> operator()(const Point_3& p) const
  {
    using internal::Vector;
    const auto corners = m_values.at(internal::to_vector(p));
    const auto vector = [](const std::array<double, 3>& v) { return Vector(v[0], v[1], v[2]); };
    Vector first, sum;
    for(const auto& corner : corners) {
      const Vector v = vector(corner.value);
      if(first == Vector()) first = v;
      sum += (v.dot(first) < 0 ? -corner.weight : corner.weight) * v;
    }
    return {sum.x(), sum.y(), sum.z()};
  }

private:
  Values m_values;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MESH_FIELDS_3_H
