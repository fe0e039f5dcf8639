// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_BOX_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_BOX_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Box_domain_3` is an open box with sides parallel to the coordinate planes.
 *
 * `is_inside()` and `is_triangle_inside()` are exact; distances are computed in double arithmetic.
 * All operations take constant time and may be called concurrently.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \cgalModels{ScalableVolumeFillingDomain_3}
 */
template <typename Traits = Curve_flow_traits_3<>>
class Box_domain_3
{
  using Vector = internal::Vector;

public:
  /// the point type of the traits
  using Point_3 = typename Traits::Point_3;

  /// the vector type of the traits
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * constructs the box from two opposite corners, whose coordinates are rounded to `double`.
   *
   * \throws std::invalid_argument if a coordinate is not finite or the box is flat
   */
  Box_domain_3(const Point_3& p, const Point_3& q) : m_box(internal::to_vector(p))
  {
    m_box.extend(internal::to_vector(q));
    if(!m_box.min().allFinite() || !m_box.max().allFinite())
      throw std::invalid_argument("a coordinate is not finite");
    if(!(m_box.sizes().minCoeff() > 0)) throw std::invalid_argument("the box is flat");
  }

  /// returns the box with all coordinates multiplied by `factor`, a power of two.
  Box_domain_3 scaled(double factor) const
  {
    Box_domain_3 box = *this;
    box.m_box = internal::Box(Vector(factor * m_box.min()), Vector(factor * m_box.max()));
    return box;
  }

  /// returns the box.
  CGAL::Bbox_3 bbox() const { return internal::to_bbox(m_box); }

  /// returns whether `p` lies strictly inside.
  bool is_inside(const Point_3& p) const { return is_strictly_inside(internal::to_vector(p)); }

  /*!
   * returns whether the closed triangle `pqr`, which may be degenerate, lies strictly inside.
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3&, const Point_3& q, const Point_3& r) const
  {
    return is_inside(q) && is_inside(r); // the box is convex
  }

  /// returns the distance from `p` to the nearest side, or 0 if `p` is not inside.
  double distance(const Point_3& p) const
  {
    const Vector x = internal::to_vector(p);
    if(!is_strictly_inside(x)) return 0;
    return (x - m_box.min()).cwiseMin(m_box.max() - x).minCoeff();
  }

  /// returns the distance from `p` to the first side along the unit vector `direction`, at most
  /// `limit`; 0 if `p` is not inside.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    const Vector x = internal::to_vector(p), u = internal::to_vector(direction);
    if(!is_strictly_inside(x)) return 0;
    double t = limit;
    for(int i = 0; i < 3; ++i) {
      if(u[i] != 0) t = (std::min)(t, ((u[i] > 0 ? m_box.max()[i] : m_box.min()[i]) - x[i]) / u[i]);
    }
    return t;
  }

private:
  bool is_strictly_inside(const Vector& x) const
  {
    for(int i = 0; i < 3; ++i)
      if(!(m_box.min()[i] < x[i] && x[i] < m_box.max()[i])) return false;
    return true;
  }

  internal::Box m_box;
};

/// \cond SKIP_IN_MANUAL
template <typename Point_3>
Box_domain_3(const Point_3&, const Point_3&)
    -> Box_domain_3<Curve_flow_traits_3<typename Kernel_traits<Point_3>::Kernel>>;
/// \endcond

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_BOX_DOMAIN_3_H
