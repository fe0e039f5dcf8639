// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Picture_shader.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vfc {
namespace {

constexpr Color white{255, 255, 255}, ink{20, 20, 40}, glass{108, 132, 160}, line{70, 88, 112};

double opacity(double optical_depth)
{
  return 1 - std::exp(-optical_depth);
}

} // namespace

Picture_shader::Picture_shader(const Scene_raster& raster,
                               const Tube_colors& colors,
                               std::size_t samples_per_side)
    : m_raster(raster), m_colors(colors), m_samples_per_side(samples_per_side)
{
  for(std::size_t y = 0; y < raster.height(); ++y)
    for(std::size_t x = 0; x < raster.width(); ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      if(!sample.has_tube()) continue;
      m_back = (std::min)(m_back, sample.depth);
      m_front = (std::max)(m_front, sample.depth);
    }
}

Rgb_image Picture_shader::operator()() const
{
  Rgb_image image{
      m_raster.width() / m_samples_per_side, m_raster.height() / m_samples_per_side, {}};
  image.bytes.reserve(3 * image.width * image.height);
  for(std::size_t y = 0; y < image.height; ++y)
    for(std::size_t x = 0; x < image.width; ++x)
      for(const double channel : pixel(x, y))
        image.bytes.push_back(static_cast<std::uint8_t>(std::clamp(channel + 0.5, 0., 255.)));
  return image;
}

Color Picture_shader::pixel(std::size_t x, std::size_t y) const
{
  Color sum{0, 0, 0};
  for(std::size_t j = 0; j < m_samples_per_side; ++j)
    for(std::size_t i = 0; i < m_samples_per_side; ++i) {
      const Color color =
          shade(m_raster.sample(m_samples_per_side * x + i, m_samples_per_side * y + j));
      for(std::size_t k = 0; k < 3; ++k) sum[k] += color[k];
    }
  for(double& channel : sum)
    channel /= static_cast<double>(m_samples_per_side * m_samples_per_side);
  return sum;
}

Color Picture_shader::shade(const Scene_raster::Sample& sample) const
{
  if(!sample.has_tube()) return mix(white, glass, opacity(sample.in_front + sample.behind));
  return mix(tube_color(sample), glass, opacity(sample.in_front));
}

Color Picture_shader::tube_color(const Scene_raster::Sample& sample) const
{
  if(sample.part == Scene_raster::Part::LINE) return line;
  const Vector normal(sample.normal[0], sample.normal[1], sample.normal[2]);
  const Vector light = Vector(-0.45, -0.6, 0.66).normalized();
  const Vector halfway = (light + Vector::UnitZ()).normalized();
  const double range = m_front - m_back, depth = sample.depth - m_back;
  const double nearness = range > 0 ? depth / range : 1;
  const Color base = m_colors.color(sample.value, nearness);
  if(sample.part == Scene_raster::Part::SECTION) return mix(base, white, 0.5);
  const double diffuse = (std::max)(0., normal.dot(light));
  const double highlight = std::pow((std::max)(0., normal.dot(halfway)), 40);
  const double shadow = 0.75 * (1 - diffuse) * (0.55 + 0.45 * (1 - normal.z()));
  return mix(mix(base, ink, shadow), white, 0.4 * highlight);
}

} // namespace vfc
