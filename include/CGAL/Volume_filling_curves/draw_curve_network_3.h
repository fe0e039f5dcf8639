// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_DRAW_CURVE_NETWORK_3_H
#define CGAL_VOLUME_FILLING_CURVES_DRAW_CURVE_NETWORK_3_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>

#include <CGAL/IO/Color.h>

#include <cmath>
#include <cstddef>

// CGAL's viewer. CGAL 6 collects points and segments in a scene, which a window then shows; in CGAL
// 5 the window itself collects them.

#if __has_include(<CGAL/Graphics_scene.h>)
#define CGAL_VOLUME_FILLING_CURVES_HAS_GRAPHICS_SCENE
#include <CGAL/Graphics_scene.h>
#endif

#ifdef CGAL_USE_BASIC_VIEWER
#ifdef CGAL_VOLUME_FILLING_CURVES_HAS_GRAPHICS_SCENE
#include <CGAL/Qt/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#endif
#endif

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

#ifdef CGAL_USE_BASIC_VIEWER

// Calls `add(scene)` to fill a scene, and shows it in a window until the user closes the window.

#ifdef CGAL_VOLUME_FILLING_CURVES_HAS_GRAPHICS_SCENE

template <typename Add>
void show_scene(const Add& add, const char* title)
{
  Graphics_scene scene;
  add(scene);
  draw_graphics_scene(scene, title);
}

#else

template <typename Add>
void show_scene(const Add& add, const char* title)
{
  if(qEnvironmentVariableIsSet("CGAL_TEST_SUITE")) return;
  CGAL::Qt::init_ogl_context(4, 3);
  int argc = 1;
  char name[] = "curve_viewer";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  const bool draws_vertices = true;
  Basic_viewer_qt viewer(application.activeWindow(), title, draws_vertices);
  add(viewer);
  viewer.show();
  application.exec();
}

#endif
#endif // CGAL_USE_BASIC_VIEWER

} // namespace internal
} // namespace Volume_filling_curves

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
