// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/picture_option_texts.h"

#include "options/lists.h"
#include "options/numbers.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace vfc {
namespace {

// returns the numbers of a list with commas, or none if an item is not a number
std::vector<double> numbers(const std::string& list)
{
  std::vector<double> result;
  for(const std::string& item : items_of_list(list))
    if(!parse(item, result.emplace_back())) return {};
  return result;
}

bool is_direction(const Vector& v)
{
  return v.norm() > 0 && std::isfinite(v.squaredNorm());
}

} // namespace

std::optional<Vector> parse_direction(const std::string& text)
{
  const std::vector<double> values = numbers(text);
  if(values.size() == 3) {
    const Vector direction(values[0], values[1], values[2]);
    return is_direction(direction) ? std::optional<Vector>(direction) : std::nullopt;
  }
  if(values.size() != 2 || std::abs(values[1]) > 90) return std::nullopt;
  const double azimuth = values[0] * CGAL_PI / 180, elevation = values[1] * CGAL_PI / 180;
  return Vector(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                std::cos(elevation) * std::cos(azimuth));
}

std::optional<Picture_size> parse_size(const std::string& text)
{
  const std::size_t cross = (std::min)(text.find('x'), text.size());
  const auto is_side = [](unsigned long long side) { return side >= 100 && side <= 4000; };
  unsigned long long width = 0, height = 0;
  if(!parse(text.substr(0, cross), width) || !is_side(width)) return std::nullopt;
  if(cross == text.size()) return Picture_size{width, width};
  if(!parse(text.substr(cross + 1), height) || !is_side(height)) return std::nullopt;
  return Picture_size{width, height};
}

std::optional<Plane> parse_plane(const std::string& text)
{
  const std::string axes = "xyz";
  const std::size_t axis = text.size() > 2 && text[1] == '=' ? axes.find(text[0]) : axes.npos;
  if(axis != axes.npos) {
    double offset = 0;
    if(!parse(text.substr(2), offset)) return std::nullopt;
    return Plane{Vector::Unit(static_cast<Eigen::Index>(axis)), offset};
  }
  const std::vector<double> values = numbers(text);
  if(values.size() != 4) return std::nullopt;
  const Plane plane{{values[0], values[1], values[2]}, values[3]};
  return is_direction(plane.normal) ? std::optional<Plane>(plane) : std::nullopt;
}

} // namespace vfc
