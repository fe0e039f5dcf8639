// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_ESTIMATES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_ESTIMATES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/assertions.h>

#include <cmath>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// Length of a curve that fills a volume V with thickness r, as a multiple of V / r^2. On five
// domains of run_filling round fillings have 0.380 to 0.385, and others 0.277 to 0.283
// (2026-11-28).
constexpr double filling_density = 0.28, round_filling_density = 0.38;

// Length of a curve that fills an area A with thickness r, as a multiple of A / r: 0.48 to 0.52 on
// plates, an L-shape and a star.
constexpr double planar_filling_density = 0.49;

inline double length_of_planar_filling(double area, double thickness)
{
  return planar_filling_density * area / thickness;
}

inline double thickness_of_planar_filling(double area, double length)
{
  return planar_filling_density * area / length;
}

// Largest share of the volume that may be farther than 2 r from the curve in a filled domain.
constexpr double tolerated_unfilled_fraction = 0.01;

// The largest share of the length along which another strand may be nearer than r in a domain that
// counts as filled.
constexpr double tolerated_crowded_fraction = 0.05;

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief returns an estimate of the length of a curve that fills a volume, \f$0.38\, V / r^2\f$, or
 * \f$0.28\, V / r^2\f$ without round bends, to plan time and material before calling `fill()`.
 *
 * The factor was 0.380 to 0.385, and 0.277 to 0.283, on five domains; where these are narrow
 * compared with the thickness the curve is shorter.
 *
 * \param volume the volume \f$V\f$ of the domain, in the cube of the input's unit
 * \param thickness the thickness \f$r\f$, in the input's unit
 * \param round_bends `Filling_parameters::round_bends`
 *
 * \pre `thickness` is positive
 */
[[nodiscard]] inline double length_of_filling(double volume,
                                              double thickness,
                                              bool round_bends = true)
{
  CGAL_precondition_msg(thickness > 0, "`thickness` is positive");
  const double density = round_bends ? internal::round_filling_density : internal::filling_density;
  return density * volume / (thickness * thickness);
}

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/fill.h
 *
 * \brief returns an estimate of the thickness of a curve that fills a volume and has a given
 * length, \f$\sqrt{0.38\, V / L}\f$, or \f$\sqrt{0.28\, V / L}\f$ without round bends, see
 * `length_of_filling()`. `fill()` starts from this thickness if a length is required.
 *
 * \param volume the volume \f$V\f$ of the domain, in the cube of the input's unit
 * \param length the length \f$L\f$, in the input's unit
 * \param round_bends `Filling_parameters::round_bends`
 *
 * \pre `length` is positive
 */
[[nodiscard]] inline double thickness_of_filling(double volume,
                                                 double length,
                                                 bool round_bends = true)
{
  CGAL_precondition_msg(length > 0, "`length` is positive");
  return std::sqrt(length_of_filling(volume, 1, round_bends) / length);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_ESTIMATES_H
