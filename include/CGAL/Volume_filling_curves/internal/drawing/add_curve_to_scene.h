// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_ADD_CURVE_TO_SCENE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_ADD_CURVE_TO_SCENE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/IO/Color.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of a curve to points and segments of a scene, which is a viewer in CGAL 5 and a
// graphics scene in CGAL 6.

// Successive hues differ by the golden angle: those of the first few components are far apart.
inline IO::Color component_color(std::size_t component)
{
  constexpr double first_hue = 215, golden_angle = 137.50776405003785, circle = 360; // degrees
  constexpr double saturation = 75, value = 85;                                      // percent
  IO::Color color;
  color.set_hsv(std::fmod(first_hue + golden_angle * static_cast<double>(component), circle),
                saturation, value);
  return color;
}

template <typename Network, typename Scene>
void add_curve_to_scene(const Network& curve, Scene& scene)
{
  for(const std::size_t v : curve.nodes())
    scene.add_point(curve.point(v),
                    curve.is_pinned(v) ? IO::black() : component_color(curve.component(v)));
  for(const std::size_t e : curve.edges())
    scene.add_segment(curve.point(curve.source(e)), curve.point(curve.target(e)),
                      component_color(curve.component(curve.source(e))));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_ADD_CURVE_TO_SCENE_H
