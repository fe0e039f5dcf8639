// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_BEND_LIMITS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_BEND_LIMITS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <functional>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Isotopy_guard_3.h
 *
 * \brief The bend radius R and the strand distance d that an `Isotopy_guard_3` keeps.
 *
 * After a change, the bend radius (see `min_bend_radius()`) at each changed corner must be at least
 * R or at least the former one, and strands must be at least d apart or at least as far apart as
 * before. Hence a limit that is kept once remains kept, provided that d is at most 2 R. Edges
 * belong to different strands if they are of different components, or at least \f$\pi \max(R,
 * d/2)\f$ of the curve lies between them. Decided in double arithmetic; no part of the proof of
 * isotopy.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3>
struct Bend_limits
{
  double bend_radius = 0;     ///< R, in the input's unit; 0 or less stands for none
  double strand_distance = 0; ///< d, in the input's unit; 0 or less stands for none

  /// a factor of both, as a function of the point, for a thickness that varies. A pair of edges has
  /// the smaller one of their values. It must be positive, and safe to call concurrently. None by
  /// default
  std::function<double(const Point_3&)> scale;

  /// returns whether there is any limit.
  bool is_active() const { return bend_radius > 0 || strand_distance > 0; }

  /// \cond SKIP_IN_MANUAL
  double scale_at(const Point_3& p) const { return scale ? scale(p) : 1; }

  // the least length of curve between edges of different strands, over scale
  double length_between_strands() const
  {
    return CGAL_PI * (std::max)(bend_radius, strand_distance / 2);
  }
  /// \endcond
};

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/fill.h
///
/// The point where a curve exceeds a limit of its shape most.
///
/// \tparam Point_3 the type of points
template <typename Point_3 = Curve_flow_traits_3<>::Point_3>
struct Shape_excess_3
{
  Point_3 point;       ///< on the curve
  double value = 0;    ///< the bend radius or the strand distance there, in the input's unit
  double limit = 0;    ///< the one that is required there
  bool is_bend = true; ///< whether it is a bend, or else a strand distance
};

namespace internal {

// Returns whether a value keeps a limit: it is at least the limit, or no less than `before()`, the
// former value.
template <typename Before>
bool keeps_limit(double after, double limit, const Before& before)
{
  return after >= limit || after >= before();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_BEND_LIMITS_H
