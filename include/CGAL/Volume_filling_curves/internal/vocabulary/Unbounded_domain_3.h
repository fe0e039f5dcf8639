// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNBOUNDED_DOMAIN_3_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNBOUNDED_DOMAIN_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

#include <CGAL/Bbox_3.h>

#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesDomains
 * \headerfile CGAL/Volume_filling_curves/Isotopy_guard_3.h
 *
 * \brief The class `Unbounded_domain_3` is the whole space.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \cgalModels{VolumeFillingDomain_3}
 */
template <typename Traits = Curve_flow_traits_3<>>
class Unbounded_domain_3
{
public:
  /// the point type of the traits
  using Point_3 = typename Traits::Point_3;

  /// the vector type of the traits
  using Vector_3 = typename Traits::Vector_3;

  /// returns a box from minus to plus infinity.
  CGAL::Bbox_3 bbox() const
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, -infinity, -infinity, infinity, infinity, infinity};
  }

  /// returns `true`.
  bool is_inside(const Point_3&) const { return true; }

  /// returns `true`.
  bool is_triangle_inside(const Point_3&, const Point_3&, const Point_3&) const { return true; }

  /// returns infinity.
  double distance(const Point_3&) const { return std::numeric_limits<double>::infinity(); }

  /// returns `limit`.
  double distance_along(const Point_3&, const Vector_3&, double limit) const { return limit; }
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNBOUNDED_DOMAIN_3_H
