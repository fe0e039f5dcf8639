// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The conventions of polylines, from the named parameters of every function that takes polylines.

// the map that gives the points
template <typename Polylines, typename NamedParameters>
auto point_map_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map),
      CGAL::Identity_property_map<polyline_item_t<Polylines>>());
}

template <typename NamedParameters>
Closure closure_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, Volume_filling_curves::internal_np::closure),
      Closure::IF_REPEATED);
}

template <typename NamedParameters>
Junctions junctions_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, Volume_filling_curves::internal_np::junctions),
      Junctions::FORBIDDEN);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_POLYLINES_POLYLINE_PARAMETERS_H
