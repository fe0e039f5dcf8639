// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

// Fillings of regions beyond a neck.
namespace test_necks {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Surface;
using meshes::Soup;
using Network = Curve_network_3<>;
using Mesh_domain = Triangle_mesh_domain_3<>;

// The neck is 0.2 wide; a loop of the curve takes 2 r from strand to strand.
class Long_narrow_neck
    : public testing::TestWithParam<std::tuple<double, Filling_start, std::size_t>>
{};

TEST_P(Long_narrow_neck, is_no_obstacle_to_a_filling)
{
  const auto [r, start, max_iterations] = GetParam();
  const Soup soup = exact_surface::two_chambers();
  const Mesh_domain domain(meshes::to_mesh(soup));
  Network curve;
  const auto result = fill(curve, domain, parameters::thickness(r).start(start).round_bends(false));
  EXPECT_LE(result.unfilled_fraction, 0.01);
  EXPECT_EQ(result.status, result.crowded_fraction > 0.05 ? Filling_status::PARTIAL // in the neck
                                                          : Filling_status::CONVERGED);
  EXPECT_LE(result.statistics.iterations, max_iterations);
  EXPECT_TRUE(result.empty_regions.empty());
  const Domain_samples_3 samples(domain, 20000, 1);
  const std::vector<double> distances = sample_distances(curve, samples);
  std::array<std::size_t, 2> covered = {0, 0}, all = {0, 0};
  for(std::size_t k = 0; k < distances.size(); ++k) {
    const std::size_t chamber = samples.points()[k].x() < 1.4 ? 0 : 1;
    ++all[chamber];
    covered[chamber] += distances[k] < r;
  }
  for(const std::size_t chamber : {0u, 1u})
    EXPECT_GT(static_cast<double>(covered[chamber]), 0.7 * static_cast<double>(all[chamber]));
  EXPECT_EQ(Surface(soup).count_outside(curve), (std::array<std::size_t, 2>{0, 0}));
}

// Without fingers through the neck it took 500 iterations and more (2026-11-23).
INSTANTIATE_TEST_SUITE_P(From_a_tree,
                         Long_narrow_neck,
                         testing::Combine(testing::Values(0.15, 0.2),
                                          testing::Values(Filling_start::TREE),
                                          testing::Values(40u)));
INSTANTIATE_TEST_SUITE_P(From_a_circle,
                         Long_narrow_neck,
                         testing::Combine(testing::Values(0.15, 0.2),
                                          testing::Values(Filling_start::CIRCLE),
                                          testing::Values(150u)));

} // namespace test_necks
