// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_EXCESSES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_EXCESSES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

template <typename Point_3, typename Traits>
std::vector<Shape_excess_3<Point_3>> shape_excesses(const Shape_check& check, const Traits& traits)
{
  std::vector<Shape_excess_3<Point_3>> excesses;
  for(const bool is_bend : {true, false}) {
    const Shape_extreme& extreme = is_bend ? check.bend : check.strands;
    if(!extreme.is_kept())
      excesses.push_back({to_point(extreme.point, traits), extreme.value, extreme.limit, is_bend});
  }
  return excesses;
}

template <typename Point_3>
std::string shape_reason(const std::vector<Shape_excess_3<Point_3>>& excesses)
{
  std::ostringstream text;
  text << std::setprecision(3);
  for(const Shape_excess_3<Point_3>& excess : excesses)
    text << (text.tellp() > 0 ? "; " : "")
         << (excess.is_bend ? "the curve bends with a radius of " : "strands have a distance of ")
         << excess.value << ", not " << excess.limit << ", at " << point_text(excess.point);
  return text.str();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_EXCESSES_H
