// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/svg_number.h"

#include <cmath>

namespace vfc {

std::string svg_number(double x)
{
  const long hundredths = std::lround(100 * x), rest = std::abs(hundredths) % 100;
  std::string text = std::to_string(std::abs(hundredths) / 100);
  if(rest > 0) text += '.';
  if(rest > 0) text += static_cast<char>('0' + rest / 10);
  if(rest % 10 > 0) text += static_cast<char>('0' + rest % 10);
  return hundredths < 0 ? '-' + text : text;
}

std::string svg_coordinates(const Vector& p)
{
  return svg_number(p.x()) + ' ' + svg_number(p.y());
}

std::string svg_color(const Color& color)
{
  static const char* const digits = "0123456789abcdef";
  std::string text = "#";
  for(const double channel : color) {
    const long value = std::lround(channel);
    text += digits[value / 16];
    text += digits[value % 16];
  }
  return text;
}

} // namespace vfc
