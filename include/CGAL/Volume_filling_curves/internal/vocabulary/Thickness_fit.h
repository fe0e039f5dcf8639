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
 * \brief Whether the walls of a domain are wide enough for a thickness.
 *
 * A place is too thin for r if no ball of radius 0.8 r that lies inside has its center within r of
 * it: a curve of that thickness draws back from there. Estimated with 300 samples; not a number if
 * there was no time for it.
 */
struct Thickness_fit
{
  /// the thickness r, in the input's unit; the mean in the domain if it varies
  double thickness = 0;

  /// the share of the volume that is too thin for r
  double thin_fraction = 0;

  /// the r for which at most 1 % of the volume is too thin, found to a factor of 0.71: r itself if
  /// that fits; if r varies, it is to be multiplied by the ratio
  double fitting_thickness = 0;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_THICKNESS_FIT_H
