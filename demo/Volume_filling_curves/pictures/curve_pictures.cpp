// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/curve_pictures.h"

#include "pictures/Curve_view.h"
#include "pictures/Picture_shader.h"
#include "pictures/Scene_raster.h"
#include "pictures/Stroke_layers.h"
#include "pictures/Svg_painter.h"
#include "pictures/corner_normals.h"

#include <cstddef>
#include <locale>
#include <sstream>

namespace vfc {
namespace {

Curve_view view_of(const Curve& curve, const Mesh& mesh)
{
  return mesh.is_empty() ? Curve_view(curve) : Curve_view(curve, Triangle_soup(mesh));
}

} // namespace

std::string png_picture(const Curve& curve, const Mesh& mesh)
{
  constexpr std::size_t pixels = 800, samples_per_side = 2;
  Curve_view view = view_of(curve, mesh);
  view.scale(pixels * samples_per_side / Curve_view::picture_size);
  Scene_raster raster(pixels * samples_per_side, pixels * samples_per_side);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    raster.add_capsule(view.point(curve.source(e)), view.point(curve.target(e)), view.width() / 2,
                       curve.component(curve.source(e)));
  raster.add_surface(view.surface(), corner_normals(view.surface()));
  return to_png(Picture_shader(raster, samples_per_side)());
}

std::string svg_picture(const Curve& curve, const Mesh& mesh)
{
  const Curve_view view = view_of(curve, mesh);
  const Stroke_layers layers(curve, view);
  std::ostringstream out;
  out.imbue(std::locale::classic());
  Svg_painter(layers, view.width(), out)(curve, view);
  return out.str();
}

} // namespace vfc
