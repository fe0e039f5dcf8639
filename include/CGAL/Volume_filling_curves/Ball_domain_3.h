// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_BALL_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_BALL_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Ball_domain_3` is an open ball.
 *
 * `is_inside()` and `is_triangle_inside()` are exact; distances are computed in double arithmetic.
 * All operations take constant time and may be called concurrently.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \cgalModels{ScalableVolumeFillingDomain_3}
 */
template <typename Traits = Curve_flow_traits_3<>>
class Ball_domain_3
{
  using Vector = internal::Vector;

public:
  /// the point type of the traits
  using Point_3 = typename Traits::Point_3;

  /// the vector type of the traits
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * constructs the ball.
   *
   * \param center the center; its coordinates are rounded to `double`
   * \param radius the radius, in the input's unit
   *
   * \throws std::invalid_argument if a coordinate is not finite, or the radius is not positive and
   * finite
   */
  Ball_domain_3(const Point_3& center, double radius)
      : m_center(internal::to_vector(center)), m_radius(radius)
  {
    if(!m_center.allFinite() || !(radius > 0) || !std::isfinite(radius))
      throw std::invalid_argument("a ball needs a finite center and a positive, finite radius");
    m_scale = internal::scale_to_one(radius);
  }

  /// returns the ball with all coordinates multiplied by `factor`, a power of two.
  Ball_domain_3 scaled(double factor) const
  {
    Ball_domain_3 ball = *this;
    ball.m_center = factor * m_center;
    ball.m_radius *= factor;
    ball.m_scale = internal::scale_to_one(ball.m_radius);
    return ball;
  }

  /// returns a box that contains the ball.
  CGAL::Bbox_3 bbox() const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const Vector reach = Vector::constant(m_radius);
    Vector low = m_center - reach, high = m_center + reach;
    for(int i = 0; i < 3; ++i) {
      low[i] = std::nextafter(low[i], -infinity);
      high[i] = std::nextafter(high[i], infinity);
    }
    return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }

  /// returns whether `p` lies strictly inside.
  bool is_inside(const Point_3& p) const
  {
    const double d2 = (internal::to_vector(p) - m_center).squaredNorm(), r2 = m_radius * m_radius;
    // eight roundings, each of at most half an epsilon of the sum, and no underflow
    const double error = 4 * std::numeric_limits<double>::epsilon() * (d2 + r2);
    if(std::abs(d2 - r2) > error && error > (std::numeric_limits<double>::min)()) return d2 < r2;
    return is_inside_exactly(internal::to_vector(p));
  }

  /*!
   * returns whether the closed triangle `pqr`, which may be degenerate, lies strictly inside.
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3&, const Point_3& q, const Point_3& r) const
  {
    return is_inside(q) && is_inside(r); // the ball is convex
  }

  /// returns the distance from `p` to the sphere, or 0 if `p` is not inside.
  double distance(const Point_3& p) const
  {
    return (std::max)(0., m_scale * m_radius - from_center(p).norm()) / m_scale;
  }

  /// returns the distance from `p` to the sphere along the unit vector `direction`, at most
  /// `limit`; 0 if `p` is not inside.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    const Vector x = from_center(p);
    const double radius = m_scale * m_radius, norm = x.norm();
    const double along = x.dot(internal::to_vector(direction));
    const double power = (radius - norm) * (radius + norm);
    if(!(power > 0)) return 0;
    const double root = std::sqrt(along * along + power);
    // of the two formulas for the same number the one without cancellation
    return (std::min)((along > 0 ? power / (along + root) : root - along) / m_scale, limit);
  }

private:
  // times the scale
  Vector from_center(const Point_3& p) const
  {
    return m_scale * (internal::to_vector(p) - m_center);
  }

  bool is_inside_exactly(const Vector& p) const
  {
    if(!p.allFinite()) return false;
    using Number = CGAL::Exact_rational;
    Number d2 = 0;
    for(int i = 0; i < 3; ++i) {
      const Number x = Number(p[i]) - Number(m_center[i]);
      d2 += x * x;
    }
    return d2 < Number(m_radius) * Number(m_radius);
  }

  Vector m_center;
  double m_radius;
  double m_scale; // to a radius of about 1: squares neither overflow nor underflow
};

/// \cond SKIP_IN_MANUAL
template <typename Point_3>
Ball_domain_3(const Point_3&, double)
    -> Ball_domain_3<Curve_flow_traits_3<typename Kernel_traits<Point_3>::Kernel>>;
/// \endcond

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_BALL_DOMAIN_3_H
