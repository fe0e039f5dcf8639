// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_ALIGNMENT_H
#define CGAL_VOLUME_FILLING_CURVES_ALIGNMENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/unit_direction.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief returns how well curves follow a direction field: the mean by length of the squared cosine
 * of the angle between an edge and the field at its middle.
 *
 * It is 1 if all edges go along the field, 0 if all go across, and 1/3 for curves that prefer no
 * direction. Where the field is zero it asks for nothing, and edges do not count. Not a number if
 * none does. Dimensionless; takes linear time.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam DirectionField a function of `Traits::Point_3` whose result is convertible to
 * `std::array<double, 3>`
 *
 * \param curves the curves
 * \param field the direction field, as for `fill()`: neither sign nor length of the vectors matters
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the field is not finite in the middle of an edge, with the place
 * in the message
 */
template <typename Traits, typename DirectionField>
[[nodiscard]] double alignment(const Curve_network_3<Traits>& curves, const DirectionField& field)
{
  using internal::Vector;
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  double aligned = 0, length = 0;
  for(std::size_t e = 0; e < curves.number_of_edges(); ++e) {
    const Vector a = internal::to_vector(curves.point(curves.source(e)));
    const Vector b = internal::to_vector(curves.point(curves.target(e)));
    const Vector direction =
        internal::unit_direction(field, internal::to_point((a + b) / 2, curves.traits()));
    if(direction == Vector()) continue;
    const double cosine = (b - a).normalized().dot(direction);
    aligned += (b - a).norm() * cosine * cosine;
    length += (b - a).norm();
  }
  return length > 0 ? aligned / length : std::numeric_limits<double>::quiet_NaN();
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_ALIGNMENT_H
