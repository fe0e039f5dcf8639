// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_THICKNESS_H
#define VFC_THICKNESS_H

#include "files/curve_files.h"
#include "files/mesh_files.h"

namespace vfc {

// Refuses typing errors: a thickness larger than the curve, or one that, with the spacing, requires
// more nodes than fit into memory. A thickness of 0 stands for none.
// \throws Usage_error that names the option
void check_thickness(double thickness, double spacing, const Curve& curve);

// The same for a curve that fills a mesh, with a thickness or a length; 0 stands for none.
void check_filling(double thickness, double length, double spacing, const Mesh& mesh);

} // namespace vfc

#endif // VFC_THICKNESS_H
