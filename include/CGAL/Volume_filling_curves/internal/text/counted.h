// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_COUNTED_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_COUNTED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Returns a number with its noun, such as "1 vertex" or "2 vertices".
inline std::string counted(std::size_t number,
                           const std::string& singular,
                           const std::string& plural)
{
  return std::to_string(number) + ' ' + (number == 1 ? singular : plural);
}

// the same for a noun whose plural is formed by an s
inline std::string counted(std::size_t number, const std::string& singular)
{
  return counted(number, singular, singular + 's');
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_COUNTED_H
