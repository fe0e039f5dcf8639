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
 * \brief The class `Curve_origin` is the point of the input that a node of a result corresponds to:
 * an edge of the input, and a position on it.
 *
 * The point is `(1 - parameter) * p + parameter * q`, where `p` and `q` are the points of the input
 * with the indices `source` and `target`. Colors, times and other data along the input can be
 * interpolated at the result in the same way.
 */
struct Curve_origin
{
  /// the index in the input of the edge's first node, see `Curve_network_3::origin()`
  std::size_t source;

  /// the index in the input of the edge's second node
  std::size_t target;

  /// the position on the edge, from 0 at `source` to 1 at `target`
  double parameter;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_ORIGIN_H
