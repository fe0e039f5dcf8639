// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// User code that fills a ball.

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <iostream>

int main()
{
  CGAL::Volume_filling_curves::Curve_network_3<> curve;
  const CGAL::Volume_filling_curves::Ball_domain_3<> ball({0, 0, 0}, 1);
  const auto result = CGAL::Volume_filling_curves::fill(curve, ball);
  std::cout << result.thickness << '\n';
}
