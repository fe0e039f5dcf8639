// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H
#define CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Values_on_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

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

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_MESH_THICKNESS_FIELD_3_H
