// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Color_scale.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vfc {
namespace {

using Lab = std::array<double, 3>;

// Returns the color at t on the scale's curve in CIELAB. Its chroma keeps all colors within sRGB.
Lab lab(double t)
{
  constexpr double first_lightness = 20, last_lightness = 92;
  constexpr double first_hue = 290, last_hue = 100; // degrees
  const double hue = (first_hue + t * (last_hue - first_hue)) * CGAL_PI / 180;
  const double chroma = 37 - 70 * t + 100 * t * t; // least where sRGB has only pale blues
  return {first_lightness + t * (last_lightness - first_lightness), chroma * std::cos(hue),
          chroma * std::sin(hue)};
}

double linear_of_lab(double f)
{
  return f > 6. / 29 ? f * f * f : 3 * 36. / 841 * (f - 4. / 29);
}

// CIELAB with the white D65, by the definitions of the CIE and of sRGB (IEC 61966-2-1)
Color srgb(const Lab& color)
{
  const double y = (color[0] + 16) / 116;
  const double X = 0.95047 * linear_of_lab(y + color[1] / 500), Y = linear_of_lab(y);
  const double Z = 1.08883 * linear_of_lab(y - color[2] / 200);
  Color result{3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
               0.0557 * X - 0.2040 * Y + 1.0570 * Z};
  for(double& channel : result) {
    channel = std::clamp(channel, 0., 1.);
    channel = channel <= 0.0031308 ? 12.92 * channel : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
    channel *= 255;
  }
  return result;
}

// Colors at equal distances along the curve.
std::vector<Color> even_colors(std::size_t number)
{
  constexpr int steps = 4096;
  std::vector<double> length{0}; // of the curve up to each step
  for(int i = 1; i <= steps; ++i) {
    const Lab a = lab((i - 1.) / steps), b = lab(static_cast<double>(i) / steps);
    length.push_back(length.back() + std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  std::vector<Color> colors;
  for(std::size_t k = 0; k < number; ++k) {
    const double wanted = length.back() * static_cast<double>(k) / static_cast<double>(number - 1);
    const auto found = std::lower_bound(length.begin(), length.end(), wanted);
    colors.push_back(srgb(lab(static_cast<double>(found - length.begin()) / steps)));
  }
  return colors;
}

// 1, 2 or 5 times a power of ten, at most a third of the range
double step_of(double range)
{
  const double power = std::pow(10, std::floor(std::log10(range / 3)));
  for(const double factor : {5., 2.})
    if(factor * power <= range / 3) return factor * power;
  return power;
}

} // namespace

Color scale_color(double share)
{
  static const std::vector<Color> colors = even_colors(257);
  const double position = std::clamp(share, 0., 1.) * static_cast<double>(colors.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(position), colors.size() - 2);
  return mix(colors[i], colors[i + 1], position - static_cast<double>(i));
}

Color_scale::Color_scale(std::vector<double> numbers)
{
  constexpr double outside = 0.01;
  std::sort(numbers.begin(), numbers.end());
  const auto rank = static_cast<std::size_t>(outside * static_cast<double>(numbers.size()));
  least = numbers[rank];
  largest = numbers[numbers.size() - 1 - rank];
  const double size = (std::max)(std::abs(least), std::abs(largest));
  constexpr double min_width = 1e-3; // relative; a smaller range counts as a single value
  if(largest - least > min_width * size) return;
  least -= size > 0 ? size / 20 : 0;
  largest += size > 0 ? size / 20 : 1;
}

double Color_scale::share(double number) const
{
  return std::clamp((number - least) / (largest - least), 0., 1.);
}

std::vector<double> Color_scale::ticks() const
{
  const double step = step_of(largest - least);
  std::vector<double> result;
  for(double k = std::ceil(least / step); k * step <= largest; ++k) result.push_back(k * step);
  return result;
}

} // namespace vfc
