// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_TRIANGLE_MESH_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_TRIANGLE_MESH_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Face_tree.h>
#include <CGAL/Volume_filling_curves/internal/domain/check_mesh.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/check_concepts.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Triangle_mesh_domain_3` is the inside of a closed triangle mesh.
 *
 * The mesh may have several shells; a shell within another one bounds a cavity. A point is inside
 * if a path from it to infinity crosses the surface an odd number of times. A nested shell must
 * have the opposite orientation of the shell around it; otherwise two solids may have been meant,
 * and the mesh is refused. The outermost shells may be oriented outward or inward.
 *
 * `is_inside()` and `is_triangle_inside()` are exact. Distances are computed in double arithmetic,
 * with an error of a few units in the last place of the coordinates; near a face so thin that its
 * normal is lost to rounding, a distance may come out too small.
 *
 * The mesh is copied and may change afterwards. Construction takes
 * \cgalBigO{n \log n} time for `n` faces. A query takes \cgalBigO{\log n} time for most points, and
 * up to linear time for points at equal distances from many faces. The member functions may be
 * called concurrently.
 *
 * \tparam Kernel a model of \cgal's `Kernel` with exact predicates, as for `Curve_flow_traits_3`
 *
 * \cgalModels{VolumeFillingDomainWithSurface_3}
 */
template <typename Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Triangle_mesh_domain_3
{
  using Faces = internal::Face_tree<Kernel>;
  using Mesh = typename Faces::Mesh;

public:
  /// the kernel's point type
  using Point_3 = typename Kernel::Point_3;

  /// the kernel's vector type
  using Vector_3 = typename Kernel::Vector_3;

  /*!
   * constructs the domain from a mesh.
   *
   * \tparam TriangleMesh a model of `FaceListGraph`
   * \tparam NamedParameters a sequence of Named Parameters
   *
   * \param mesh the mesh
   * \param np an optional sequence of named parameters among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map from the vertices of a mesh to their points}
   *     \cgalParamType{a model of `ReadablePropertyMap` whose key type is the mesh's vertex
   *       descriptor and whose value type is `Point_3`}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{check_mesh}
   *     \cgalParamDescription{whether to refuse meshes with faces that meet elsewhere than in a
   *       common vertex or edge, and with nested shells of the same orientation. Without this
   *       check, the former leave the inside undefined, and the latter bound cavities. It takes 1.5
   *       microseconds per face, 4 % of the time of a coarse filling}
   *     \cgalParamType{`bool`}
   *     \cgalParamDefault{`true`}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * \throws std::invalid_argument if the mesh has no faces, is not closed, has a face that is
   * degenerate or not a triangle, or has all its vertices in a plane; if a coordinate is not finite
   * or beyond 1e100, or the mesh is smaller than 1e-100; or if `check_mesh` finds a defect. The
   * message lists vertices and faces, numbered from 0 in their order in the mesh
   */
  template <typename TriangleMesh,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Triangle_mesh_domain_3(const TriangleMesh& mesh,
                                  const NamedParameters& np = CGAL::parameters::default_values())
      : m_faces(std::make_unique<Faces>(checked_copy(mesh, np)))
  {}

  /// returns the domain with all coordinates multiplied by `factor`, a power of two. Takes as long
  /// as the construction.
  Triangle_mesh_domain_3 scaled(double factor) const
  {
    Mesh mesh = m_faces->mesh();
    for(const auto v : vertices(mesh)) {
      const Point_3& p = mesh.point(v);
      mesh.point(v) = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
    }
    return Triangle_mesh_domain_3(std::make_unique<const Faces>(std::move(mesh)));
  }

  /// returns a box that contains the domain.
  CGAL::Bbox_3 bbox() const { return m_faces->bbox(); }

  /// returns whether `p` lies strictly inside.
  bool is_inside(const Point_3& p) const { return m_faces->encloses(p); }

  /*!
   * returns whether the closed triangle `pqr`, which may be degenerate, lies strictly inside.
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return !m_faces->does_meet({p, q, r});
  }

  /// returns the distance from `p`, inside or outside, to the surface.
  double distance(const Point_3& p) const
  {
    return std::sqrt(m_faces->nearest(internal::to_vector(p)).squared_distance);
  }

  /// returns the distance from `p` to the surface along the unit vector `direction`, at most
  /// `limit`.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    return m_faces->distance_along(internal::to_vector(p), internal::to_vector(direction), limit);
  }

  /// returns the distance from `p` to the surface, at most `limit`.
  double distance_up_to(const Point_3& p, double limit) const
  {
    const auto nearest = m_faces->nearest(internal::to_vector(p), limit * limit);
    return nearest.face == Mesh::null_face() ? limit : std::sqrt(nearest.squared_distance);
  }

  /// \cond SKIP_IN_MANUAL
  // see `VolumeFillingDomainWithSurface_3`
  void shorten(internal::Planar_rays& rays) const { m_faces->shorten(rays); }

  // the distance of a segment inside to the surface, and the position on the segment, from 0 to 1
  std::pair<double, double> distance_of_segment(const Point_3& p, const Point_3& q) const
  {
    const auto [d2, position] =
        m_faces->nearest_to_segment(internal::to_vector(p), internal::to_vector(q));
    return {std::sqrt(d2), position};
  }

  // the corners of all faces
  const std::vector<internal::Corners>& corners() const { return m_faces->corners(); }
  /// \endcond

  /// \name Connected Parts
  /// Shells that are not nested bound different parts, even if they touch in vertices or edges. A
  /// part may have cavities.
  /// @{

  /*!
   * returns the number of the connected part of the inside that contains `p`, which is the number
   * of the shell around it. Points of different parts have different numbers; some numbers belong
   * to no part.
   *
   * \pre `is_inside(p)`
   */
  std::size_t part(const Point_3& p) const { return m_faces->innermost_shell(p); }

  /// returns a box for each number that `part()` may return; the part with that number lies in the
  /// box.
  const std::vector<CGAL::Bbox_3>& part_boxes() const { return m_faces->shells().boxes(); }

  /// @}

private:
  explicit Triangle_mesh_domain_3(std::unique_ptr<const Faces> faces) : m_faces(std::move(faces)) {}

  template <typename TriangleMesh, typename NamedParameters>
  static Mesh checked_copy(const TriangleMesh& mesh, const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    if(faces(mesh).begin() == faces(mesh).end())
      throw std::invalid_argument("no geometry: there are no faces");
    if(!CGAL::is_triangle_mesh(mesh))
      throw std::invalid_argument(
          "a face is not a triangle; Polygon_mesh_processing::triangulate_faces() cuts it");
    const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                         CGAL::get_const_property_map(CGAL::vertex_point, mesh));
    Mesh copy;
    std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                          typename Mesh::Vertex_index>>
        copies;
    CGAL::copy_face_graph(
        mesh, copy,
        CGAL::parameters::vertex_point_map(points).vertex_to_vertex_output_iterator(
            std::back_inserter(copies)));
    const auto number_of = [&](typename Mesh::Vertex_index v) { // for messages
      const auto original = std::find_if(copies.begin(), copies.end(),
                                         [&](const auto& pair) { return pair.second == v; });
      const auto all = vertices(mesh);
      const auto position = std::find(all.begin(), all.end(), original->first);
      return static_cast<std::size_t>(std::distance(all.begin(), position));
    };
    internal::check_run(); // each of these takes 0.2 s with a million faces
    const internal::Mesh_check check(copy, number_of);
    check.check_faces();
    internal::check_run();
    if(choose_parameter(get_parameter(np, internal_np::check_mesh), true)) check.check_shells();
    internal::check_run();
    return copy;
  }

  std::unique_ptr<const Faces> m_faces; // a pointer, which keeps the domain movable
};

/// \cond SKIP_IN_MANUAL
template <typename TriangleMesh,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
explicit Triangle_mesh_domain_3(const TriangleMesh&,
                                const NamedParameters& = CGAL::parameters::default_values())
    -> Triangle_mesh_domain_3<typename CGAL::GetGeomTraits<TriangleMesh, NamedParameters>::type>;
/// \endcond

namespace internal {

// Returns the domain itself, or the domain that a mesh bounds.
template <typename Traits, typename Domain, typename NamedParameters>
decltype(auto) as_domain(const Domain& domain, const NamedParameters& np)
{
  using Kernel = typename Kernel_traits<typename Traits::Point_3>::Kernel;
  if constexpr(Is_domain<Domain>::value) {
    static_assert(check_domain<Domain, typename Traits::Point_3>());
    return (domain);
  } else {
    static_assert(allows<const Domain&>([](auto& mesh) -> decltype(faces(mesh), void()) {}),
                  "VolumeFillingDomain_3 requires is_inside(point), FaceListGraph faces(mesh)");
    return Triangle_mesh_domain_3<Kernel>(domain, np);
  }
}

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_TRIANGLE_MESH_DOMAIN_3_H
