// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_ORIGIN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_ORIGIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief The class `Curve_origin` tells from which place of the input a node of a result comes: an
 * edge of the input, and a number from 0 to 1 that tells where on it.
 *
 * The place is `(1 - parameter) * p + parameter * q` for the points `p` and `q` of the input with
 * the indices `source` and `target`. Colors, times, or whatever else is known along the input, are
 * carried over to the result in the same way.
 */
struct Curve_origin
{
  /// the index in the input of the node where the edge starts, see `Curve_network_3::origin()`
  std::size_t source;

  /// the index in the input of the node where the edge ends
  std::size_t target;

  /// how far from `source` to `target`
  double parameter;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_ORIGIN_H
