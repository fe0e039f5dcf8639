// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <cstddef>
#include <cstdio>

// Prints flows of a few generated knots bit by bit. It is compiled twice, with and without Eigen's
// vectorization, for test_vectorization.py.

namespace {

namespace VFC = CGAL::Volume_filling_curves;
using Network = VFC::Curve_network_3<>;

void print_flow(Network curve)
{
  VFC::Isotopy_guard_3<> guard(curve);
  VFC::Curve_flow_3<> flow(guard);
  for(int k = 0; k < 80 && flow.step(); ++k)
    std::printf("%a %a\n", flow.gradient_norm(), flow.length());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    std::printf("%a %a %a\n", curve.point(v).x(), curve.point(v).y(), curve.point(v).z());
}

} // namespace

int main()
{
  print_flow(VFC::make_torus_knot(2, 3, 60));
  print_flow(VFC::make_torus_knot(2, 4, 90));
  for(unsigned seed = 0; seed < 4; ++seed) print_flow(VFC::make_random_polygon(12, seed));
}
