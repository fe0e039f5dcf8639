// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills a box with a curve whose strands wind around an axis, like fibers around a pin. Compares
// the alignment with that of a filling without a direction field.

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <array>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Traits = VFC::Curve_flow_traits_3<>;
using Curve = VFC::Curve_network_3<Traits>;
using Point_3 = Curve::Point_3;
using Domain = VFC::Box_domain_3<Traits>;

//! [field]
// Sign and length do not matter. On the axis the vector is zero: no direction is preferred.
std::array<double, 3> around_z_axis(const Point_3& p)
{
  return {-p.y(), p.x(), 0};
}
//! [field]

int main()
{
  //! [fill]
  const Domain box(Point_3(-1, -1, -0.5), Point_3(1, 1, 0.5));
  // round bends follow a field less
  const auto parameters = VFC::parameters::thickness(0.12).round_bends(false);
  Curve any, around;
  VFC::fill(any, box, parameters);
  const auto result = VFC::fill(around, box, parameters.direction_field(around_z_axis));
  //! [fill]

  const double without = VFC::alignment(any, around_z_axis);
  const double with = VFC::alignment(around, around_z_axis);
  std::cout << "mean squared cosine with the field: " << with << ", without it " << without << '\n'
            << 100 * result.coverage.fraction_within_r << " % of the volume are within r\n";
  return with > 0.5 && without < 0.45 ? EXIT_SUCCESS : EXIT_FAILURE;
}
