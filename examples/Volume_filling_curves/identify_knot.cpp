// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Names knots: the closure of a braid on four strands, and a random polygon.

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

//! [identify]
void print_identity(const VFC::Curve_network_3<>& curve)
{
  const VFC::Link_identity identity = VFC::identify(curve);
  std::cout << (identity.name.empty() ? "unknown" : identity.name)
            << (identity.is_proved ? ", proved, " : ", ") << identity.chirality << '\n'
            << "proof      " << identity.knottedness << '\n'
            << "crossings  " << identity.diagram.crossings.size() << '\n'
            << "HOMFLY-PT  " << identity.homfly_polynomial << '\n'
            << "Jones      " << identity.jones_polynomial << '\n';
}
//! [identify]

int main()
{
  const VFC::Curve_network_3<> curve = VFC::make_closed_braid({1, 1, -2, 1, 3, -2, 3}, 300);
  print_identity(curve);
  print_identity(VFC::make_random_polygon(300, 7));
  return VFC::identify(curve).name == "7_6" ? EXIT_SUCCESS : EXIT_FAILURE;
}
