// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_DRAW_CURVE_NETWORK_3_H
#define CGAL_VOLUME_FILLING_CURVES_DRAW_CURVE_NETWORK_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/drawing/Basic_viewer.h>
#include <CGAL/Volume_filling_curves/internal/drawing/add_curve_to_scene.h>

namespace CGAL {

#ifdef DOXYGEN_RUNNING

/*!
 * \ingroup PkgVolumeFillingCurvesDraw
 *
 * \brief opens a new window and draws a curve.
 *
 * Components differ in color, and pinned nodes are black; the key V shows or hides nodes. The call
 * blocks until the window is closed, and has no effect if the environment variable
 * `CGAL_TEST_SUITE` is set. This function requires `CGAL_Qt5` with \cgal 5 and `CGAL_Qt6` with
 * \cgal 6, and is only available if the macro `CGAL_USE_BASIC_VIEWER` is defined. Linking with the
 * CMake target `CGAL::CGAL_Basic_viewer` provides both.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param title the title of the window
 */
template <typename Traits>
void draw(const Volume_filling_curves::Curve_network_3<Traits>& curve,
          const char* title = "Curve_network_3 Basic Viewer");

/*!
 * \ingroup PkgVolumeFillingCurvesDraw
 *
 * \brief adds the nodes and edges of a curve to a graphics scene, next to other objects.
 *
 * Components differ in color, and pinned nodes are black. This function requires \cgal 6, but
 * neither Qt nor a display; `CGAL::draw_graphics_scene()` shows the scene.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 *
 * \param curve the curve
 * \param scene the scene to which the curve is added
 */
template <typename Traits>
void add_to_graphics_scene(const Volume_filling_curves::Curve_network_3<Traits>& curve,
                           Graphics_scene& scene);

#else

#ifdef CGAL_VOLUME_FILLING_CURVES_HAS_GRAPHICS_SCENE

template <typename Traits>
void add_to_graphics_scene(const Volume_filling_curves::Curve_network_3<Traits>& curve,
                           Graphics_scene& scene)
{
  Volume_filling_curves::internal::add_curve_to_scene(curve, scene);
}

#endif

#ifdef CGAL_USE_BASIC_VIEWER

template <typename Traits>
void draw(const Volume_filling_curves::Curve_network_3<Traits>& curve,
          const char* title = "Curve_network_3 Basic Viewer")
{
  Volume_filling_curves::internal::show_scene(
      [&](auto& scene) { Volume_filling_curves::internal::add_curve_to_scene(curve, scene); },
      title);
}

#endif

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_DRAW_CURVE_NETWORK_3_H
