// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Tube_colors.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vfc {
namespace {

constexpr double levels = 48; // hardly visible steps

} // namespace

Tube_colors::Tube_colors(Coloring coloring, const Edge_values& values)
{
  if(coloring == Coloring::COMPONENT || values.empty()) return;
  std::vector<double> numbers;
  for(const auto& [source, target] : values) {
    numbers.push_back(source);
    numbers.push_back(target);
  }
  m_scale.emplace(std::move(numbers));
}

Color Tube_colors::color(double value, double nearness) const
{
  constexpr double min_of_component = 0.4, min_of_scale = 0.85;
  const double least = m_scale ? min_of_scale : min_of_component;
  const Color full = m_scale ? scale_color(m_scale->share(value))
                             : component_color(static_cast<std::size_t>(value));
  return mix(fog_color, full, least + (1 - least) * nearness);
}

std::size_t Tube_colors::level(double value) const
{
  return static_cast<std::size_t>(m_scale ? std::round(levels * m_scale->share(value)) : value);
}

double Tube_colors::value_of_level(std::size_t level) const
{
  const auto number = static_cast<double>(level);
  return m_scale ? m_scale->least + number / levels * (m_scale->largest - m_scale->least) : number;
}

double Tube_colors::level_step() const
{
  return m_scale && m_scale->largest > m_scale->least ? (m_scale->largest - m_scale->least) / levels
                                                      : std::numeric_limits<double>::infinity();
}

} // namespace vfc
