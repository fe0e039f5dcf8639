// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FLAT_MESH_H
#define VFC_FLAT_MESH_H

#include "files/mesh_files.h"

#include <CGAL/Polygon_with_holes_2.h>

#include <vector>

namespace vfc {

// Triangulates polygons whose boundaries do not meet; faces look upwards, in the direction of z.
Mesh flat_mesh(const std::vector<CGAL::Polygon_with_holes_2<Kernel>>& polygons);

} // namespace vfc

#endif // VFC_FLAT_MESH_H
