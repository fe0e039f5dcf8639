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

// Pictures of a curve as the bytes of a file. Each component is a tube in its own color, or in the
// colors of a scale, which stands beside the curve; distant parts are paler. Pictures do not depend
// on the size and position of the curve, nor on a display or graphics card. The surface of a mesh
// is drawn around the curve; an empty mesh means none.

// PNG: tubes are shaded, the surface is translucent.
std::string png_picture(const Curve& curve,
                        const Mesh& mesh = Mesh(),
                        const Picture_options& options = Picture_options());

// SVG: strands are interrupted under others, the surface has outline and creases. O(n log n + k)
// for n nodes and k pairs of strands that come close in the picture.
std::string svg_picture(const Curve& curve,
                        const Mesh& mesh = Mesh(),
                        const Picture_options& options = Picture_options());

} // namespace vfc

#endif // VFC_CURVE_PICTURES_H
