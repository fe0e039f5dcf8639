// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_THICKNESS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_THICKNESS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The thickness that a curve fills a domain with, or starts from if it is a length that is asked
// for.

// The largest share of the volume farther than 2 r from the curve with which a domain counts as
// filled.
constexpr double tolerated_unfilled_fraction = 0.01;

// Throws std::invalid_argument if a domain with a box of that size cannot be filled.
template <typename Point_3>
void check_filling(const Filling_parameters<Point_3>& parameters, double size)
{
  check_parameters(parameters);
  check_thickness(parameters.thickness, size, "the domain");
  if(parameters.length > 0 && (parameters.thickness > 0 || parameters.thickness_field))
    refuse_value(internal_np::length_t(), parameters.length,
                 "there is a thickness, too, and only one of them can be asked for");
}

// The mean at some points.
template <typename Field, typename Points>
double mean_thickness(const Field& field, const Points& points)
{
  double sum = 0;
  for(const auto& p : points) sum += field(p);
  return sum / static_cast<double>(points.size());
}

// The thickness wherever there is no field of it.
template <typename Point_3>
double filling_thickness(const Filling_parameters<Point_3>& parameters,
                         double widest_radius,
                         double volume)
{
  constexpr double default_share = 0.25; // of the widest ball
  if(parameters.thickness > 0) return parameters.thickness;
  if(parameters.length > 0) return thickness_of_filling(volume, parameters.length);
  return default_share * widest_radius;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_THICKNESS_H
