// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// User program that the tests of usage build.

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <cstdlib>

int main()
{
  using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
  using Point_3 = Network::Point_3;

  const Network triangle({Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0)},
                         {{0, 1}, {1, 2}, {2, 0}});
  return triangle.number_of_nodes() == 3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
