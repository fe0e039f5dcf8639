// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_MEDIAL_SPHERE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_MEDIAL_SPHERE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/Curve_flow_3.h
///
/// A sphere that touches a curve at a node and contains no other node.
template <typename Point_3>
struct Medial_sphere
{
  Point_3 center;           ///< the center, in the plane orthogonal to the curve at the node
  double radius;            ///< the radius, in the input's unit
  std::size_t touched_node; ///< the node that limits the radius, or `null_node()` if the cap does
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_MEDIAL_SPHERE_H
