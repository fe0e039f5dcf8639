// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_POINT_TEXT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_POINT_TEXT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <locale>
#include <sstream>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// "(x, y, z)", for messages.
template <typename Point_3>
std::string point_text(const Point_3& p)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return text.str();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_POINT_TEXT_H
