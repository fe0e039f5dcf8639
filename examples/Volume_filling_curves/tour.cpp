// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a knot and fills a ball.

//! [headers]
#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>
//! [headers]

#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

int main()
{
  //! [untangle]
  VFC::Curve_network_3<> curve = VFC::make_hard_unknot(100, 2000);
  const VFC::Untangling_result untangled = VFC::untangle(curve);
  std::cout << untangled.status << ", length " << VFC::length(curve) << '\n';
  CGAL::IO::write_curve_network("untangled.obj", curve);
  //! [untangle]

  //! [fill]
  const VFC::Ball_domain_3<> ball({0, 0, 0}, 1);
  VFC::Curve_network_3<> filling; // empty: fill() starts one
  const auto filled = VFC::fill(filling, ball, VFC::parameters::thickness(0.2));
  std::cout << filled.status << ", length " << VFC::length(filling) << '\n';
  CGAL::IO::write_curve_network("filling.obj", filling);
  //! [fill]

  const bool is_ok = untangled.status == VFC::Untangling_status::UNKNOTTED &&
                     filled.status == VFC::Filling_status::CONVERGED;
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
