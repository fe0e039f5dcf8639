// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_WRITERS_H
#define VFC_WRITERS_H

#include "formats/Node_columns.h"

#include <CGAL/Volume_filling_curves/internal/polylines/Curve_paths.h>

#include <string>

namespace vfc {

// Writers of formats beyond those of the library, which compose the whole text in memory. PLY and
// VTP files have a value per node and column, and mark pinned nodes, if there are any. Linear time.
using CGAL::Volume_filling_curves::internal::Curve_paths;
std::string to_ply(const Curve_paths& curve, const Node_columns& columns);
std::string to_vtp(const Curve_paths& curve, const Node_columns& columns);
std::string to_vect(const Curve_paths& curve);
std::string to_point_list(const Curve_paths& curve);

// A planar curve seen from above, at true scale if its unit is a millimeter.
std::string to_svg(const Curve_paths& curve);

} // namespace vfc

#endif // VFC_WRITERS_H
