// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_THICKNESS_FIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_THICKNESS_FIT_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief The fit of a thickness to a domain: whether the domain is wide enough for it.
 *
 * A domain is too thin for r at a point if no ball of radius 0.8 r inside the domain has its center
 * within 1.5 r of the point: a curve of that thickness withdraws from it. Estimated from 300
 * samples; NaN if there was no time for it.
 */
struct Thickness_fit
{
  /// the thickness r, in the input's unit; if it varies, the mean in the domain
  double thickness = 0;

  /// the share of the volume where the domain is too thin for r
  double thin_fraction = 0;

  /// a thickness t that leaves strands room to keep it from one another, to within a factor of
  /// 0.71, in the input's unit: at most 1 % of the volume has no ball of radius 1.1 t with its
  /// center within 2.1 t; r itself if the domain is not too thin for it. If r varies, multiply it
  /// by the ratio of this value to `thickness`
  double fitting_thickness = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_THICKNESS_FIT_H
