// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fills a box with a thickness that doubles from the left to the right.

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Traits = VFC::Curve_flow_traits_3<>;
using Curve = VFC::Curve_network_3<Traits>;
using Point_3 = Curve::Point_3;
using Domain = VFC::Box_domain_3<Traits>;

constexpr double length = 2;

//! [field]
double thickness(const Point_3& p)
{
  return 0.09 * (1 + p.x() / length);
}
//! [field]

// In units of the local thickness, samples in the left and in the right half of the box are equally
// far from the curve.
struct Half
{
  double length = 0, mean_distance = 0;
  std::size_t samples = 0;
};

int main()
{
  //! [fill]
  const Domain box(Point_3(0, 0, 0), Point_3(length, 1, 1));
  Curve curve;
  const auto result = VFC::fill(curve, box, VFC::parameters::thickness(thickness));
  //! [fill]

  Half halves[2];
  const VFC::Domain_samples_3<Traits, Domain> samples(box);
  const auto distances = VFC::sample_distances(curve, samples);
  for(std::size_t k = 0; k < distances.size(); ++k) {
    const Point_3& p = samples.points()[k];
    Half& half = halves[p.x() < length / 2 ? 0 : 1];
    half.mean_distance += distances[k] / thickness(p);
    ++half.samples;
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const Point_3 &p = curve.point(curve.source(e)), &q = curve.point(curve.target(e));
    halves[p.x() < length / 2 ? 0 : 1].length += std::sqrt(CGAL::squared_distance(p, q));
  }
  for(Half& half : halves) {
    half.mean_distance /= static_cast<double>(half.samples);
    std::cout << "length " << half.length << ", mean distance " << half.mean_distance
              << " times the thickness\n";
  }
  const VFC::Coverage coverage = VFC::coverage(samples, distances, thickness);
  std::cout << 100 * coverage.fraction_within_r << " % of the volume are within the thickness, "
            << result.empty_regions.size() << " regions were not reached\n";

  const bool is_even = std::abs(halves[0].mean_distance - halves[1].mean_distance) < 0.1;
  return is_even && coverage.fraction_within_r > 0.7 ? EXIT_SUCCESS : EXIT_FAILURE;
}
