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
#include <memory>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Mesh_thickness_field_3` is a function of the point, given by values at the
 * vertices of a triangle mesh: its value is interpolated barycentrically at the closest point of
 * the surface.
 *
 * The function is continuous wherever the closest point is unique. Up to rounding, its values lie
 * between the minimum and the maximum at the corners of the closest face. The mesh is copied;
 * copies of the function share it. Construction takes \cgalBigO{n \log n} time for `n` faces,
 * evaluation \cgalBigO{\log n} for most points. Evaluation uses double arithmetic and may be called
 * concurrently.
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
   * \throws std::invalid_argument if a face is not a triangle, if there are fewer than two faces,
   * if the values and the vertices differ in number, or if a coordinate is not finite or beyond
   * 1e100
   */
  template <typename TriangleMesh>
  Mesh_thickness_field_3(const TriangleMesh& mesh, const std::vector<double>& values)
      : m_values(std::make_shared<const Values>(mesh, values))
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
   * \throws std::invalid_argument if a face is not a triangle, if there are fewer than two faces,
   * or if a coordinate is not finite or beyond 1e100
   */
  template <typename TriangleMesh, typename VertexValueMap>
  Mesh_thickness_field_3(const TriangleMesh& mesh, const VertexValueMap& values)
      : Mesh_thickness_field_3(mesh, Values::at_vertices(mesh, values))
  {}

  /*!
   * returns the value at the point of the surface that is closest to `p`.
   *
   * \throws std::invalid_argument if a coordinate is not finite or beyond 1e150
   */
  double operator()(const Point_3& p) const
  {
    double value = 0;
    for(const auto& corner : m_values->at(internal::to_vector(p)))
      value += corner.weight * corner.value;
    return value;
  }

private:
  std::shared_ptr<const Values> m_values; // shared by copies
};

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Mesh_direction_field_3` is a field of directions, given by vectors at the
 * vertices of a triangle mesh: its direction is that of the barycentric mean at the closest point
 * of the surface.
 *
 * The sign of a vector does not matter: before taking the mean, the vectors at the corners of a
 * face are flipped where they point away from the first. Lengths act as weights; where all vectors
 * are zero there is no direction. The mesh is copied; copies of the field share it. Construction
 * takes \cgalBigO{n \log n} time for `n` faces, evaluation \cgalBigO{\log n} for most points.
 * Evaluation uses double arithmetic and may be called concurrently.
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
   * \throws std::invalid_argument if a face is not a triangle, if there are fewer than two faces,
   * if the vectors and the vertices differ in number, or if a coordinate is not finite or beyond
   * 1e100
   */
  template <typename TriangleMesh>
  Mesh_direction_field_3(const TriangleMesh& mesh,
                         const std::vector<std::array<double, 3>>& vectors)
      : m_values(std::make_shared<const Values>(mesh, vectors))
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
   * \throws std::invalid_argument if a face is not a triangle, if there are fewer than two faces,
   * or if a coordinate is not finite or beyond 1e100
   */
  template <typename TriangleMesh, typename VertexVectorMap>
  Mesh_direction_field_3(const TriangleMesh& mesh, const VertexVectorMap& vectors)
      : Mesh_direction_field_3(mesh, Values::at_vertices(mesh, vectors))
  {}

  /*!
   * returns a vector along the direction at the point of the surface that is closest to `p`.
   *
   * \throws std::invalid_argument if a coordinate is not finite or beyond 1e150
   */
  std::array<double, 3> operator()(const Point_3& p) const
  {
    using internal::Vector;
    const auto corners = m_values->at(internal::to_vector(p));
    const auto vector = [](const std::array<double, 3>& v) { return Vector(v[0], v[1], v[2]); };
    Vector first, sum;
    for(const auto& corner : corners) {
      const Vector v = vector(corner.value);
      const Vector scaled = internal::in_own_units(v); // products neither underflow nor overflow
      if(first == Vector()) first = scaled;
      sum += (scaled.dot(first) < 0 ? -corner.weight : corner.weight) * v;
    }
    return {sum.x(), sum.y(), sum.z()};
  }

private:
  std::shared_ptr<const Values> m_values; // shared by copies
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MESH_FIELDS_3_H
