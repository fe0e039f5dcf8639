// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_PICTURES_H
#define VFC_CURVE_PICTURES_H

#include "files/mesh_files.h"
#include "pictures/Picture_options.h"

#include <string>

namespace vfc {

// Pictures of a curve as the bytes of a file. Each component is a tube of its own color, paler the
// farther it is away, or the colors are those of a scale, which stands beside the curve. Pictures
// do not depend on the size and position of the curve, nor on any display or graphics card. With a
// mesh, which is empty for none, the surface is drawn around the curve.

// PNG: tubes are shaded, the surface is translucent.
std::string png_picture(const Curve& curve,
                        const Mesh& mesh = Mesh(),
                        const Picture_options& options = Picture_options());

// SVG: strands that pass under others are interrupted, the surface is drawn by outline and creases.
// O(n log n + k) for n nodes and k places where strands come close in the picture.
std::string svg_picture(const Curve& curve,
                        const Mesh& mesh = Mesh(),
                        const Picture_options& options = Picture_options());

} // namespace vfc

#endif // VFC_CURVE_PICTURES_H
