// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Shows a link in a window: two linked curves in two colors, one of them with a pinned node.

#include <CGAL/Volume_filling_curves/draw_curve_network_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <cstdlib>

namespace VFC = CGAL::Volume_filling_curves;

int main()
{
  //! [draw]
  VFC::Curve_network_3<> link = VFC::make_torus_knot(2, 4, 80);
  link.set_pinned(0);
  CGAL::draw(link);
  //! [draw]
  return EXIT_SUCCESS;
}
