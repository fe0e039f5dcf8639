// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_BASIC_VIEWER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_BASIC_VIEWER_H

#include <CGAL/license/Volume_filling_curves.h>

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
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_BASIC_VIEWER_H
