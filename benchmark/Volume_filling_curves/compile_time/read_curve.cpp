// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// User code that only reads curves.

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <iostream>
#include <vector>

int main()
{
  CGAL::Volume_filling_curves::Curve_network_3<> curve;
  std::vector<CGAL::Volume_filling_curves::Curve_defect> defects;
  if(!CGAL::IO::read_curve_network("curve.obj", curve, defects)) return 1;
  std::cout << curve.number_of_nodes() << '\n';
}
