// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_COVERAGE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_COVERAGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/coverage.h
 *
 * \brief The struct `Coverage` describes how evenly a curve fills a domain: statistics of the
 * distances from uniform samples of the domain to the curve, divided by the thickness. Without
 * samples, for example if there was no time to measure, they are NaN.
 */
struct Coverage
{
  /// the number of samples
  std::size_t samples = 0;

  /// the mean distance
  double mean = std::numeric_limits<double>::quiet_NaN();

  /// the median
  double p50 = std::numeric_limits<double>::quiet_NaN();

  /// the distance that 95 % of the samples do not exceed
  double p95 = std::numeric_limits<double>::quiet_NaN();

  /// the distance that 99 % of the samples do not exceed
  double p99 = std::numeric_limits<double>::quiet_NaN();

  /// the largest distance
  double max = std::numeric_limits<double>::quiet_NaN();

  /// the share of the samples that are at most the thickness away
  double fraction_within_r = std::numeric_limits<double>::quiet_NaN();
};

/*!
 * \ingroup PkgVolumeFillingCurvesMeasures
 * \headerfile CGAL/Volume_filling_curves/coverage.h
 *
 * \brief The struct `Empty_region_3` is a connected part of a domain that a curve did not reach.
 *
 * \tparam Point_3 the type of points
 */
template <typename Point_3>
struct Empty_region_3
{
  /// the center of a ball that lies in the region
  Point_3 point;

  /// the radius of the ball, in the input's unit
  double radius;

  /// the volume of the region, or its area in a planar domain, estimated from its share of the
  /// samples
  double volume;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_COVERAGE_H
