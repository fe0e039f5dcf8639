// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_ARC_WRITERS_H
#define VFC_ARC_WRITERS_H

#include "arc_files/Length_unit.h"
#include "files/curve_files.h"

#include <CGAL/Volume_filling_curves/arc_spline.h>

#include <string>

namespace vfc {

// Writers of arc splines, which compose the whole text in memory, with all digits, in any locale.
// Linear time.

using Arcs = CGAL::Volume_filling_curves::Arc_spline<Curve::Point_3>;

// A line per piece, after one with the names of the columns. Segments have no radius.
std::string to_csv(const Arcs& arcs);

// ISO 10303-21 with the schema AP214: a composite curve of lines and circles per path, in
// millimeters if there is no unit. \throws std::invalid_argument if there is no path, or one so
// short that readers would take it for a point
std::string to_step(const Arcs& arcs, Length_unit unit);

// A path of lines and arcs per path, seen from above. \throws std::invalid_argument if there is no
// path or z varies
std::string to_svg(const Arcs& arcs, Length_unit unit);

} // namespace vfc

#endif // VFC_ARC_WRITERS_H
