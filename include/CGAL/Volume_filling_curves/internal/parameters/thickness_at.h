// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_AT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_AT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/text/point_text.h>

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws "thickness is VALUE at POINT, but DEMAND".
template <typename Point_3>
[[noreturn]] void refuse_thickness_at(const Point_3& p, double value, const std::string& demand)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "thickness is " << value << " at " << point_text(p) << ", but " << demand;
  throw std::invalid_argument(text.str());
}

// The thickness that a field has at a point. Throws std::invalid_argument if it is not positive and
// finite: a search for places that are as far apart as a NaN says never ends.
template <typename Field, typename Point_3>
double thickness_at(const Field& field, const Point_3& p)
{
  const double thickness = field(p);
  if(!is_positive(thickness)) refuse_thickness_at(p, thickness, demand<double>(Range::POSITIVE));
  return thickness;
}

// A field that throws std::invalid_argument where another one has a value that is not positive and
// finite, or larger than the domain, whose box has a diagonal of that size. None if that is none.
template <typename Field>
Field checked_thickness_field(Field field, double size)
{
  if(!field) return field;
  return [field = std::move(field), size](const auto& p) {
    const double thickness = thickness_at(field, p);
    if(thickness > size) refuse_thickness_at(p, thickness, not_larger_than("the domain", size));
    return thickness;
  };
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_THICKNESS_AT_H
