// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_UNIT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_UNIT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Unit of length of a filling. Terms of degree 6 overflow in a domain of size 2^170 and underflow
// in one of size 2^-170. Such a run therefore uses the size of the domain's box as unit, rounded to
// a power of two, which rounds no coordinate.

inline double max_coordinate_of(const CGAL::Bbox_3& box)
{
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)({largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
  return largest;
}

[[noreturn]] inline void refuse_size(double size, const std::string& demand)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "the domain's box has a largest coordinate of " << size << ", but " << demand;
  throw std::invalid_argument(text.str());
}

// Returns the unit for a domain with that box; 1 unless the domain is very large or very small.
// \throws std::invalid_argument if it is larger or smaller than any domain may be
template <typename Domain>
double length_unit(const CGAL::Bbox_3& box)
{
  constexpr int max_exponent = 128; // leaves 2^40 between the domain's size and that of edges
  const double size = max_coordinate_of(box);
  if(!(size > 0) || !std::isfinite(size)) return 1; // the survey says what is wrong
  const int exponent = std::ilogb(size);
  if(std::abs(exponent) <= max_exponent) return 1;
  if(size > max_coordinate || size < min_extent)
    refuse_size(size, "must be between 1e-150 and 1e150");
  if(!Is_scalable<Domain>::value)
    refuse_size(size, "must be between 1e-38 and 1e38 if the domain has no member function "
                      "scaled(); scale it by a power of two, which changes no bits of the result");
  return std::ldexp(1., exponent);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_LENGTH_UNIT_H
