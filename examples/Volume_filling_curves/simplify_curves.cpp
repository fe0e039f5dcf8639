// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Simplifies a link of two wavy rings: as far as possible, and within a distance of the input.

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Curve = VFC::Curve_network_3<>;
using Point_3 = Curve::Point_3;

// Two linked rings with small waves
Curve wavy_link()
{
  const std::size_t n = 500;
  std::vector<std::vector<Point_3>> rings(2);
  for(std::size_t c = 0; c < 2; ++c)
    for(std::size_t i = 0; i < n; ++i) {
      const double t = 2 * CGAL_PI * static_cast<double>(i) / n;
      const double radius = 2 + 0.1 * std::cos(40 * t), height = 0.1 * std::sin(40 * t);
      const double x = radius * std::cos(t), y = radius * std::sin(t);
      rings[c].push_back(c == 0 ? Point_3(x, y, height) : Point_3(x + 2, height, y));
    }
  return Curve(rings, VFC::parameters::closure(VFC::Closure::CLOSED));
}

// Simplifies the link and prints the number of remaining nodes. The rings stay linked.
template <typename NamedParameters>
bool simplify(const char* how, const NamedParameters& np)
{
  Curve curve = wavy_link();
  const auto linking = VFC::linking_matrix(curve);
  const std::size_t removed = VFC::simplify_curves(curve, np);
  std::cout << how << ": " << removed << " nodes removed, " << curve.number_of_nodes() << " left\n";
  return removed > 0 && VFC::linking_matrix(curve) == linking;
}

int main()
{
  namespace params = VFC::parameters;
  //! [simplify]
  bool is_ok = simplify("as far as possible", params::default_values());
  is_ok &= simplify("within 0.25 of the input", params::max_distance(0.25));
  is_ok &= simplify("within 0.02 of the input", params::max_distance(0.02));
  is_ok &= simplify("strands 0.5 apart", params::clearance(0.5));
  //! [simplify]
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
