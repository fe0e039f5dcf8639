// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IMPLICIT_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_IMPLICIT_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 *
 * \brief The class `Implicit_domain_3` is the set where a function, for example a signed distance,
 * is negative.
 *
 * The function `f` has a Lipschitz bound `L`: `|f(p) - f(q)| <= L |p - q|` for all points of the
 * box. A signed distance has `L = 1`; for a differentiable function, `L` bounds the norm of the
 * gradient. If the bound holds, the sign of `f` does not change within `|f(p)| / L` of `p`. All
 * answers rest on this:
 *
 * - `is_triangle_inside()` divides the triangle and returns `true` only if such a ball around the
 *   center of each piece covers the piece. Hence `f` is negative *everywhere* on an accepted
 *   triangle, not only at samples, provided that the bound holds and the values of `f` are exact.
 *   If the values have errors of at most `e`, pass `f + e`. Triangles that are closer to the
 *   boundary than about a sixtieth of their size, times `L` over the norm of the gradient, are
 *   refused even if they lie inside.
 * - `distance()` and `distance_along()` are lower bounds.
 *
 * If the bound is too small, a curve can leave the domain; if it is too large, it costs time and
 * keeps the curve away from the boundary.
 *
 * A triangle takes at most 8191 calls of `f`, and usually one; a distance along a direction takes
 * at most 1000, and usually fewer than ten. The member functions may be called concurrently if `f`
 * may.
 *
 * \tparam Function a functor with <tt>double operator()(Point_3 p) const</tt>, or with another
 * result type that `CGAL::to_double()` converts
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \cgalModels{ScalableVolumeFillingDomain_3}
 */
template <typename Function, typename Traits = Curve_flow_traits_3<>>
class Implicit_domain_3
{
  using Vector = internal::Vector;

public:
  /// the point type of the traits
  using Point_3 = typename Traits::Point_3;

  /// the vector type of the traits
  using Vector_3 = typename Traits::Vector_3;

  /*!
   * constructs the domain.
   *
   * \param function the function, negative inside
   * \param bbox a box that contains the domain
   * \param lipschitz_bound the Lipschitz bound of the function in the box; 1 for a signed distance
   * \param traits the traits object
   *
   * \throws std::invalid_argument if the box or the Lipschitz bound is not finite, or the bound is
   * not positive
   *
   * \pre the function is negative nowhere outside the box
   */
  Implicit_domain_3(Function function,
                    const CGAL::Bbox_3& bbox,
                    double lipschitz_bound = 1,
                    const Traits& traits = Traits())
      : m_function(std::move(function)),
        m_bbox(bbox),
        m_lipschitz(lipschitz_bound),
        m_traits(traits)
  {
    if(!(lipschitz_bound > 0) || !std::isfinite(lipschitz_bound))
      throw std::invalid_argument("the Lipschitz bound is not a positive, finite number");
    if(!std::isfinite(diagonal())) throw std::invalid_argument("the box is not finite");
  }

  /// returns the domain with all coordinates multiplied by `factor`, a power of two. The function
  /// is still called with points in its original unit.
  Implicit_domain_3 scaled(double factor) const
  {
    Implicit_domain_3 domain = *this;
    domain.m_unit /= factor;
    domain.m_bbox = {factor * m_bbox.xmin(), factor * m_bbox.ymin(), factor * m_bbox.zmin(),
                     factor * m_bbox.xmax(), factor * m_bbox.ymax(), factor * m_bbox.zmax()};
    return domain;
  }

  /// returns the box passed to the constructor.
  CGAL::Bbox_3 bbox() const { return m_bbox; }

  /// returns whether the function is negative at `p`.
  bool is_inside(const Point_3& p) const { return value(p) < 0; }

  /*!
   * returns whether the closed triangle `pqr`, which may be degenerate, is proved to lie inside.
   * \pre `is_inside(p)`
   */
  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    return is_covered({internal::to_vector(p), internal::to_vector(q), internal::to_vector(r)},
                      max_bisections);
  }

  /// returns a lower bound of the distance from `p` to the boundary, or 0 if `p` is not inside.
  double distance(const Point_3& p) const { return (std::max)(0., -value(p) / m_lipschitz); }

  /// returns a lower bound of the distance from `p` to the boundary along the unit vector
  /// `direction`, at most `limit`. The search ends where the boundary is nearer than a thousandth
  /// of `limit` and does not recede: there it also ends for a direction along the boundary.
  double distance_along(const Point_3& p, const Vector_3& direction, double limit) const
  {
    const Vector origin = internal::to_vector(p), u = internal::to_vector(direction);
    const double farthest = (std::min)(limit, diagonal());
    double t = 0, last_step = 0;
    for(int i = 0; i < max_steps && t < farthest; ++i) {
      const double step = (std::max)(0., -value(origin + t * u) / m_lipschitz); // 0 for NaN
      t += step;
      if(step <= march_end * farthest && step <= last_step) break; // neither far nor getting away
      last_step = step;
    }
    return (std::min)(t, limit);
  }

private:
  // of the longest edge: a triangle without short edges ends in pieces a 64th of its size
  static constexpr int max_bisections = 12;

  static constexpr double march_end = 1e-3; // of the limit; the steps shrink geometrically
  static constexpr int max_steps = 1000;

  // margin for the rounding of centers and radii, relative to the size of the coordinates
  static constexpr double margin = 1e-14;

  double value(const Point_3& p) const
  {
    if(m_unit == 1) return CGAL::to_double(m_function(p));
    const Vector q = m_unit * internal::to_vector(p);
    return CGAL::to_double(m_function(internal::to_point(q, m_traits))) / m_unit;
  }

  double value(const Vector& p) const { return value(internal::to_point(p, m_traits)); }

  double diagonal() const
  {
    return internal::stable_norm(Vector(m_bbox.x_span(), m_bbox.y_span(), m_bbox.z_span()));
  }

  // Returns whether balls in which the function is negative cover the triangle.
  bool is_covered(const std::array<Vector, 3>& t, int bisections) const
  {
    const Vector center = (t[0] + t[1] + t[2]) / 3;
    const double negative_radius = -value(center) / m_lipschitz;
    double radius = 0;
    for(const Vector& corner : t) radius = (std::max)(radius, norm(corner - center));
    radius += margin * center.cwiseAbs().maxCoeff();
    if(radius < negative_radius) return true;
    if(bisections == 0 || !(negative_radius > 0)) return false;
    return are_halves_covered(t, bisections - 1);
  }

  bool are_halves_covered(const std::array<Vector, 3>& t, int bisections) const
  {
    std::size_t apex = 0; // opposite the longest edge
    for(std::size_t i = 1; i < 3; ++i)
      if(is_longer(edge_opposite(t, i), edge_opposite(t, apex))) apex = i;
    const Vector &a = t[apex], &b = t[(apex + 1) % 3], &c = t[(apex + 2) % 3];
    const Vector middle = (b + c) / 2;
    return is_covered({a, b, middle}, bisections) && is_covered({a, middle, c}, bisections);
  }

  // If the square underflowed to 0, triangles across the boundary would pass for points.
  static double norm(const Vector& v)
  {
    const double square = v.squaredNorm();
    return std::isnormal(square) ? std::sqrt(square) : internal::stable_norm(v);
  }

  static bool is_longer(const Vector& v, const Vector& w)
  {
    const double a = v.squaredNorm(), b = w.squaredNorm();
    if(std::isnormal(a) && std::isnormal(b)) return a > b;
    return internal::stable_norm(v) > internal::stable_norm(w);
  }

  static Vector edge_opposite(const std::array<Vector, 3>& t, std::size_t i)
  {
    return t[(i + 2) % 3] - t[(i + 1) % 3];
  }

  Function m_function;
  CGAL::Bbox_3 m_bbox;
  double m_lipschitz;
  double m_unit = 1; // of the function, a power of two
  Traits m_traits;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IMPLICIT_DOMAIN_3_H
