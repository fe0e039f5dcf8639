// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_FILL_TEST_SUPPORT_H
#define VFC_TEST_FILL_TEST_SUPPORT_H

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

// Common parts of the tests of filling.
namespace fill_test {

namespace VFC = CGAL::Volume_filling_curves;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Traits = VFC::Curve_flow_traits_3<Kernel>;
using Curve = VFC::Curve_network_3<Traits>;

// Parameters of a filling that is not rounded, for tests of anything else: it takes a third of the
// time.
template <typename Thickness>
auto preview(const Thickness& thickness)
{
  return VFC::parameters::thickness(thickness).round_bends(false);
}

template <typename Domain>
VFC::Coverage coverage(const Curve& curve, const Domain& domain, double thickness)
{
  const VFC::Domain_samples_3<Traits, Domain> samples(domain, 20000, 1);
  return VFC::coverage(samples, VFC::sample_distances(curve, samples), thickness);
}

template <typename Domain>
void expect_inside(const Curve& curve, const Domain& domain)
{
  const VFC::Containment outside = VFC::containment(curve, domain);
  EXPECT_EQ(outside.outside_nodes.size(), 0u);
  EXPECT_EQ(outside.outside_edges.size(), 0u);
}

inline Curve polyline(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t k = 1; k < points.size(); ++k) edges.push_back({k - 1, k});
  return Curve(points, edges);
}

} // namespace fill_test

#endif // VFC_TEST_FILL_TEST_SUPPORT_H
