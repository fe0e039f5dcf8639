// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PICTURE_SHADER_H
#define VFC_PICTURE_SHADER_H

#include "pictures/Scene_raster.h"
#include "pictures/Tube_colors.h"
#include "pictures/picture_colors.h"
#include "pictures/png_file.h"

#include <cstddef>
#include <limits>

namespace vfc {

// Shader of a raster: each pixel is the mean of its samples. The light comes from the upper left,
// over the viewer's shoulder; distant parts are pale, and tubes are darker at their outlines, which
// separates strands.
class Picture_shader
{
public:
  // A pixel has `samples_per_side` squared samples. Raster and colors must outlive the shader.
  // \pre the raster is complete, and `samples_per_side` divides its width and height
  Picture_shader(const Scene_raster& raster,
                 const Tube_colors& colors,
                 std::size_t samples_per_side);

  Rgb_image operator()() const;

private:
  Color pixel(std::size_t x, std::size_t y) const;
  Color shade(const Scene_raster::Sample& sample) const;
  Color tube_color(const Scene_raster::Sample& sample) const;

  const Scene_raster& m_raster;
  const Tube_colors& m_colors;
  std::size_t m_samples_per_side;
  // the depths of the farthest and the nearest sample of a tube
  float m_back = std::numeric_limits<float>::infinity(), m_front = -m_back;
};

} // namespace vfc

#endif // VFC_PICTURE_SHADER_H
