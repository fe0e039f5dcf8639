// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills a vessel with a channel that leads from one port to another one. The vessel is given by a
// signed distance.

#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VFC = CGAL::Volume_filling_curves;

using Traits = VFC::Curve_flow_traits_3<>;
using Curve = VFC::Curve_network_3<Traits>;
using Point_3 = Curve::Point_3;

// The signed distance to a capsule of radius 0.5 around a segment on the x-axis
double distance_to_capsule(const Point_3& p)
{
  const double x = p.x() - (std::max)(-0.5, (std::min)(0.5, p.x()));
  return std::sqrt(x * x + p.y() * p.y() + p.z() * p.z()) - 0.5;
}

using Domain = VFC::Implicit_domain_3<double (*)(const Point_3&)>;

int main()
{
  //! [ports]
  const Domain domain(distance_to_capsule, CGAL::Bbox_3(-1, -0.5, -0.5, 1, 0.5, 0.5));
  const std::vector<VFC::Port<Point_3>> ports = {{Point_3(-1, 0, 0)}, {Point_3(1, 0, 0)}};
  const double thickness = 0.12;
  Curve curve;
  const auto result = VFC::fill(curve, domain, VFC::parameters::thickness(thickness).ports(ports));
  //! [ports]

  const VFC::Domain_samples_3<Traits, Domain> samples(domain);
  const auto coverage =
      VFC::coverage(samples, VFC::sample_distances(curve, samples), result.thickness);
  std::cout << "length " << VFC::length(curve) << ", " << 100 * coverage.fraction_within_r
            << " % of the volume are within " << thickness << ", all within "
            << coverage.max * thickness << '\n';

  for(const auto& neck : result.necks)
    std::cout << "from " << neck.wall << " straight for " << neck.length
              << (neck.is_free ? ", free\n" : ", not free\n");
  const bool is_ok = result.status == VFC::Filling_status::CONVERGED && result.necks.size() == 2 &&
                     result.necks[0].is_free && result.necks[1].is_free &&
                     coverage.fraction_within_r > 0.7;
  return is_ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
