// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INSET_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INSET_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The class `Inset_domain_3` is the set of the points of a domain that are farther than a
 * distance c from its boundary.
 *
 * `is_inside()` and `is_triangle_inside()` are as certain as the distances of the domain: a
 * triangle is halved until every part is known to lie deep enough. Triangles that come within 1/64
 * of their size of the limit may be refused. A query takes one of the domain where there is room,
 * and some hundreds near the limit.
 *
 * A filling of the inset ends at about the thickness from the boundary of the inset. To fill the
 * domain itself and still keep a distance, use `fill()` with `wall_distance`.
 *
 * If `Domain` is a model of `ScalableVolumeFillingDomain_3` or `PlanarVolumeFillingDomain_3`, so is
 * the inset.
 *
 * \tparam Domain a model of `VolumeFillingDomain_3`, bounded, whose distances are lower bounds
 *
 * \cgalModels{VolumeFillingDomain_3}
 */
template <typename Domain>
class Inset_domain_3
{
public:
  /// the domain's point type
  using Point_3 = typename Domain::Point_3;

  /// the domain's vector type
  using Vector_3 = typename Domain::Vector_3;

  /// the dimension of the domain
  static constexpr int dimension = internal::dimension_of<Domain>;

  /// constructs the inset of `domain`, which must outlive it, by the distance `c`, in the input's
  /// unit.
  ///
  /// \throws std::invalid_argument if `c` is negative or not finite, or the box of `domain` is
  /// narrower than 2 c in some direction
  Inset_domain_3(const Domain& domain, double c) : m_domain(&domain), m_c(c) { check(); }

  /// constructs the inset of a domain that it owns, with the same exceptions.
  Inset_domain_3(Domain&& domain, double c)
      : m_owned(std::make_shared<const Domain>(std::move(domain))), m_domain(m_owned.get()), m_c(c)
  {
    check();
  }

  /// returns the inset with all coordinates multiplied by `factor`, a power of two.
  template <typename D = Domain, std::enable_if_t<internal::Is_scalable<D>::value, int> = 0>
  Inset_domain_3 scaled(double factor) const
  {
    return Inset_domain_3(m_domain->scaled(factor), factor * m_c);
  }

  /// returns the distance c.
  double wall_distance() const { return m_c; }

  /// returns a box that contains the inset.
  CGAL::Bbox_3 bbox() const
  {
    const CGAL::Bbox_3 box = m_domain->bbox();
    const double z = is_plane ? 0 : m_c;
    return {box.xmin() + m_c, box.ymin() + m_c, box.zmin() + z,
            box.xmax() - m_c, box.ymax() - m_c, box.zmax() - z};
  }

  /// returns whether `p` lies strictly inside.
  bool is_inside(const Point_3& p) const
  {
    return m_domain->is_inside(p) && m_domain->distance(p) > m_limit;
  }

  /// returns whether the closed triangle `pqr`, which may be degenerate, lies strictly inside.
  /// \pre `is_inside(p)`
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    using internal::to_vector;
    return m_domain->is_triangle_inside(p, q, r) &&
           internal::Depth_test<Domain>(*m_domain, m_limit)(to_vector(p), to_vector(q),
                                                            to_vector(r));
  }

  /// returns a lower bound of the distance of `p` to the inset's boundary; 0 outside.
  double distance(const Point_3& p) const
  {
    return m_domain->is_inside(p) ? (std::max)(m_domain->distance(p) - m_limit, 0.) : 0;
  }

  /// returns a lower bound of the distance of `p` to the inset's boundary along the unit vector
  /// `direction`, at most `limit`.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    // each step is as long as the known depth
    const internal::Vector start = internal::to_vector(p), u = internal::to_vector(direction);
    double length = 0;
    for(int k = 0; k < max_steps && length < limit; ++k) {
      const internal::Vector x = start + length * u;
      const double step = distance(Point_3(x.x(), x.y(), x.z()));
      length += step;
      if(!(step > min_step * limit)) break;
    }
    return (std::min)(length, limit);
  }

private:
  static constexpr bool is_plane = internal::Space_of<Domain>::is_plane;
  static constexpr int max_steps = 32;
  static constexpr double min_step = 1e-2; // of the limit: medial spheres need no more
  static constexpr double slack = 1e-12;   // of distances, in units of the diagonal, for rounding

  void check()
  {
    const CGAL::Bbox_3 box = m_domain->bbox();
    if(!(m_c >= 0) || !std::isfinite(m_c))
      throw std::invalid_argument("the distance of an inset must be finite and not negative");
    const internal::Vector sides(box.x_span(), box.y_span(), box.z_span());
    if(!(2 * m_c < (is_plane ? (std::min)(sides.x(), sides.y()) : sides.minCoeff())))
      throw std::invalid_argument("the domain has no inset by that distance: its box is narrower "
                                  "than twice as much");
    m_limit = m_c + internal::rounding_in(box, slack * internal::stable_norm(sides));
  }

  std::shared_ptr<const Domain> m_owned; // or none, if it is borrowed; shared by copies
  const Domain* m_domain;
  double m_c;
  double m_limit = 0; // c and what rounding may add to a distance
};

/// \cond SKIP_IN_MANUAL
template <typename Domain>
Inset_domain_3(const Domain&, double) -> Inset_domain_3<Domain>;
/// \endcond

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_INSET_DOMAIN_3_H
