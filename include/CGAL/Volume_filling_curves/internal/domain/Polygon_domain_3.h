// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_POLYGON_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_POLYGON_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Ring_tree.h>
#include <CGAL/Volume_filling_curves/internal/domain/check_rings.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/planar_predicates.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The class `Polygon_domain_3` is the inside of one or more polygons with holes in the plane
 * z = 0.
 *
 * A curve that fills it is planar: the z coordinates of its nodes are 0, and its closed components
 * are simple polygons. Points off the plane are outside.
 *
 * The boundaries must not touch or cross themselves or one another, not even in a corner. A polygon
 * may lie in a hole of another one. The orientation of boundaries does not matter, and consecutive
 * equal corners count as one.
 *
 * `is_inside()` and `is_triangle_inside()` are exact. Distances are computed in double arithmetic.
 *
 * Construction takes \cgalBigO{n \log n} time for `n` edges. A query takes \cgalBigO{\log n} time
 * for most points, and up to linear time for points at equal distances from many edges. The member
 * functions may be called concurrently. Copies share their data.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \cgalModels{PlanarVolumeFillingDomain_3}
 * \cgalModels{VolumeFillingDomainWithSurface_3}
 */
template <typename Traits = Curve_flow_traits_3<>>
class Polygon_domain_3
{
  using Rings = std::vector<internal::Ring>;

public:
  /// the point type of the traits
  using Point_3 = typename Traits::Point_3;

  /// the vector type of the traits
  using Vector_3 = typename Traits::Vector_3;

  /// the domain lies in a plane
  static constexpr int dimension = 2;

  /*!
   * constructs the domain from a polygon with holes. Coordinates are rounded to `double`.
   *
   * \throws std::invalid_argument if a boundary has fewer than three different corners, or meets
   * itself or another one; if a hole lies outside its polygon or within another hole; or if a
   * coordinate is not finite or beyond 1e100. The message lists the corners, numbered from 0
   */
  template <typename Kernel, typename Container>
  explicit Polygon_domain_3(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon)
  {
    Rings rings;
    add(rings, polygon, 0);
    store(std::move(rings));
  }

  /// constructs the domain from a polygon without holes, with the same exceptions.
  template <typename Kernel, typename Container>
  explicit Polygon_domain_3(const CGAL::Polygon_2<Kernel, Container>& polygon)
      : Polygon_domain_3(CGAL::Polygon_with_holes_2<Kernel, Container>(polygon))
  {}

  /*!
   * constructs the domain from several polygons, each of which becomes a connected part.
   *
   * \tparam Polygons a range of `CGAL::Polygon_with_holes_2`
   *
   * \throws std::invalid_argument like the first constructor, and if there are no polygons, or two
   * of them overlap
   */
  template <typename Polygons, typename = decltype(std::begin(std::declval<const Polygons&>()))>
  explicit Polygon_domain_3(const Polygons& polygons)
  {
    Rings rings;
    std::size_t number = 0;
    for(const auto& polygon : polygons) add(rings, polygon, number++);
    store(std::move(rings));
  }

  /// returns the domain with all coordinates multiplied by `factor`, a power of two. Takes as long
  /// as the construction.
  Polygon_domain_3 scaled(double factor) const
  {
    Rings rings = m_region->rings;
    for(internal::Ring& ring : rings)
      for(internal::Planar_point& p : ring.corners)
        p = internal::Planar_point(factor * p.x(), factor * p.y());
    return Polygon_domain_3(std::make_shared<const Region>(std::move(rings)));
  }

  /// returns a box that contains the domain, flat in the direction of z.
  CGAL::Bbox_3 bbox() const { return m_region->tree.bbox(); }

  /// returns whether `p` lies in the plane, strictly inside.
  bool is_inside(const Point_3& p) const
  {
    return is_in_plane(p) && m_region->tree.encloses(in_plane(p));
  }

  /*!
   * returns whether the closed triangle `pqr`, which may be degenerate, lies in the plane, strictly
   * inside.
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return is_in_plane(q) && is_in_plane(r) &&
           !m_region->tree.does_meet({in_plane(p), in_plane(q), in_plane(r)});
  }

  /// returns the distance from `p`, inside or outside, to the boundary, the edges of the polygons.
  double distance(const Point_3& p) const
  {
    return m_region->tree.distance(internal::to_vector(p));
  }

  /// returns the distance from `p` to the boundary along the unit vector `direction`, at most
  /// `limit`; 0 if `p` or `direction` does not lie in the plane.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    return distance_along(internal::to_vector(p), internal::to_vector(direction), limit);
  }

  /// returns the distance from `p` to the boundary, at most `limit`.
  double distance_up_to(const Point_3& p, double limit) const
  {
    return m_region->tree.distance(internal::to_vector(p), limit);
  }

  /// \cond SKIP_IN_MANUAL
  // see `VolumeFillingDomainWithSurface_3`
  void shorten(internal::Planar_rays& rays) const
  {
    for(std::size_t l = 0; l < rays.size(); ++l)
      if(rays.lengths[l] > 0)
        rays.lengths[l] = distance_along(rays.source, rays.direction(l), rays.lengths[l]);
  }

  // see `Triangle_mesh_domain_3`
  std::pair<double, double> distance_of_segment(const Point_3& p, const Point_3& q) const
  {
    const auto [d2, position] =
        m_region->tree.nearest_to_segment(internal::to_vector(p), internal::to_vector(q));
    return {std::sqrt(d2), position};
  }
  /// \endcond

  /// \name Connected Parts
  /// @{

  /// returns the index of the polygon that contains `p`, in the order of the input.
  ///
  /// \pre `is_inside(p)`
  std::size_t part(const Point_3& p) const
  {
    return m_region->part_boxes.size() == 1 ? 0 : m_region->innermost_polygon(in_plane(p));
  }

  /// returns the box of each polygon.
  const std::vector<CGAL::Bbox_3>& part_boxes() const { return m_region->part_boxes; }

  /// @}

private:
  /// \cond SKIP_IN_MANUAL
  struct Region
  {
    explicit Region(Rings all) : rings(std::move(all)), tree(rings)
    {
      for(const internal::Ring& ring : rings) {
        if(!ring.is_outer()) continue;
        part_boxes.emplace_back();
        for(const internal::Planar_point& p : ring.corners)
          part_boxes.back() += CGAL::Bbox_3(p.x(), p.y(), 0, p.x(), p.y(), 0);
      }
    }

    // The polygon of which an odd number of rings, the outer boundary alone, are around a point.
    std::size_t innermost_polygon(const internal::Planar_point& p) const
    {
      std::vector<bool> is_odd(part_boxes.size(), false);
      for(const std::size_t r : tree.rings_around(p))
        is_odd[rings[r].polygon] = !is_odd[rings[r].polygon];
      const auto found = std::find(is_odd.begin(), is_odd.end(), true);
      return static_cast<std::size_t>(found - is_odd.begin());
    }

    Rings rings;
    internal::Ring_tree tree;
    std::vector<CGAL::Bbox_3> part_boxes;
  };
  /// \endcond

  explicit Polygon_domain_3(std::shared_ptr<const Region> region) : m_region(std::move(region)) {}

  template <typename Polygon>
  static void add(Rings& rings, const Polygon& polygon, std::size_t number)
  {
    rings.push_back(ring_of(polygon.outer_boundary(), number, internal::Ring::outer));
    std::size_t hole = 0;
    for(auto it = polygon.holes_begin(); it != polygon.holes_end(); ++it)
      rings.push_back(ring_of(*it, number, hole++));
  }

  template <typename Boundary>
  static internal::Ring ring_of(const Boundary& boundary, std::size_t polygon, std::size_t hole)
  {
    internal::Ring ring;
    ring.polygon = polygon;
    ring.hole = hole;
    std::size_t number = 0;
    for(auto v = boundary.vertices_begin(); v != boundary.vertices_end(); ++v, ++number) {
      const internal::Planar_point p(CGAL::to_double(v->x()), CGAL::to_double(v->y()));
      if(!ring.corners.empty() && ring.corners.back() == p) continue;
      ring.corners.push_back(p);
      ring.numbers.push_back(number);
    }
    if(ring.corners.size() > 1 && ring.corners.front() == ring.corners.back()) {
      ring.corners.pop_back();
      ring.numbers.pop_back();
    }
    return ring;
  }

  void store(Rings rings)
  {
    internal::Ring_check(rings).check_each();
    m_region = std::make_shared<const Region>(std::move(rings));
    internal::Ring_check(m_region->rings).check_all(m_region->tree);
  }

  static bool is_in_plane(const Point_3& p) { return CGAL::to_double(p.z()) == 0; }

  static internal::Planar_point in_plane(const Point_3& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  }

  double distance_along(const internal::Vector& p, const internal::Vector& u, double limit) const
  {
    if(p.z() != 0 || u.z() != 0) return 0;
    return m_region->tree.distance_along(p, u, limit);
  }

  std::shared_ptr<const Region> m_region;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// Whether a type is a polygon, with or without holes, or a range of these.
template <typename T, typename = void>
struct Is_polygonal : std::false_type
{};

template <typename Kernel, typename Container>
struct Is_polygonal<CGAL::Polygon_2<Kernel, Container>> : std::true_type
{};

template <typename Kernel, typename Container>
struct Is_polygonal<CGAL::Polygon_with_holes_2<Kernel, Container>> : std::true_type
{};

template <typename T>
struct Is_polygonal<T,
                    std::void_t<decltype(std::begin(std::declval<const T&>())->outer_boundary())>>
    : std::true_type
{};

} // namespace internal
/// \endcond

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_POLYGON_DOMAIN_3_H
