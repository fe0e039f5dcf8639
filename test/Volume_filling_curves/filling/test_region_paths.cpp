// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/filling/Region_paths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The way back from regions that a curve does not get to, and whether it then gets there.
namespace test_region_paths {

using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using exact_surface::Surface;
using meshes::Soup;
using Network = Curve_network_3<>;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Samples = Domain_samples_3<Curve_flow_traits_3<>, Mesh_domain>;
using Paths = internal::Region_paths<Network, Samples>;
using internal::Thinned_paths;
using Region = Empty_region_3<Point>;

Network triangle_in_left_leg()
{
  return {{{0.4, 2.4, 0.5}, {0.6, 2.4, 0.5}, {0.5, 2.6, 0.5}}, {{0, 1}, {1, 2}, {2, 0}}};
}

struct Two_legs
{
  Soup soup = exact_surface::two_legs(1e-3);
  Mesh_domain domain{meshes::to_mesh(soup)};
  Samples samples{domain, 100};
  Network curve = triangle_in_left_leg();

  Thinned_paths paths_from(const std::vector<Point>& points, double cell) const
  {
    std::vector<Region> regions;
    for(const Point& p : points) regions.push_back({p, 0.1, 1});
    return Paths(curve, samples, regions, cell).paths();
  }
};

TEST(Region_paths, lead_around_a_wall)
{
  const Two_legs legs;
  const Point region(1.5, 2.5, 0.5);
  for(const double cell : {0.05, 0.1}) {
    const Thinned_paths paths = legs.paths_from({region}, cell);
    ASSERT_FALSE(paths.are_empty());
    EXPECT_EQ(paths.thinning(region, 0.25), 0.25);
    EXPECT_EQ(paths.thinning(Point(0.5, 2.4, 0.5), 0.25), 0.25); // up to the curve
    double below_wall = 1;
    for(double y = 0.025; y < 1; y += 0.05)
      below_wall = (std::min)(below_wall, paths.thinning(Point(1, y, 0.5), 0.25));
    EXPECT_EQ(below_wall, 0.25);
  }
}

TEST(Region_paths, thin_a_curve_nearby_only_and_without_jumps)
{
  const Two_legs legs;
  const Thinned_paths paths = legs.paths_from({Point(1.5, 2.5, 0.5)}, 0.02);
  EXPECT_EQ(paths.thinning(Point(1.5, 2.5, 0.05), 0.5), 1);
  EXPECT_EQ(paths.thinning(Point(0.5, 2.95, 0.5), 0.5), 1);
  double last = paths.thinning(Point(1.5, 2.5, 0.5), 0.5);
  for(double z = 0.5; z < 1; z += 0.001) {
    const double factor = paths.thinning(Point(1.5, 2.5, z), 0.5);
    EXPECT_GE(factor, last - 1e-12);
    EXPECT_LE(factor, (std::min)(last + 0.5 * 0.001 / 0.08 + 1e-12, 1.));
    last = factor;
  }
  EXPECT_EQ(last, 1);
}

TEST(Region_paths, end_at_once_where_the_curve_is_near)
{
  const Two_legs legs;
  const Thinned_paths paths = legs.paths_from({Point(0.5, 2.3, 0.5)}, 0.1);
  EXPECT_FALSE(paths.are_empty());
  EXPECT_EQ(paths.thinning(Point(0.5, 1.4, 0.5), 0.5), 1);
}

TEST(Region_paths, lead_out_of_each_region)
{
  const Two_legs legs;
  const Thinned_paths paths = legs.paths_from({Point(1.5, 2.5, 0.5), Point(0.5, 0.5, 0.5)}, 0.05);
  EXPECT_EQ(paths.thinning(Point(1.5, 2.5, 0.5), 0.5), 0.5);
  EXPECT_EQ(paths.thinning(Point(0.5, 0.5, 0.5), 0.5), 0.5);
}

TEST(Region_paths, are_empty_if_there_is_no_way)
{
  const Soup soup = meshes::voxels({{0, 2, 0}, {2, 2, 0}});
  const Mesh_domain domain(meshes::to_mesh(soup));
  const Samples samples(domain, 100);
  const Network curve = triangle_in_left_leg();
  EXPECT_TRUE(Paths(curve, samples, {{Point(2.5, 2.5, 0.5), 0.1, 1}}, 0.1).paths().are_empty());
  EXPECT_FALSE(Paths(curve, samples, {{Point(0.1, 2.5, 0.5), 0.1, 1}}, 0.1).paths().are_empty());
  EXPECT_TRUE(Paths(curve, samples, {}, 0.1).paths().are_empty());
}

// The neck is 0.2 wide; a loop of the curve takes 2 r from strand to strand. At r = 0.2 one of the
// chambers stays empty without a path.
class Narrow_neck : public testing::TestWithParam<double>
{};

TEST_P(Narrow_neck, is_no_obstacle_to_a_filling)
{
  const double r = GetParam();
  const Soup soup = exact_surface::two_chambers();
  const Mesh_domain domain(meshes::to_mesh(soup));
  Network curve;
  const auto result = fill(curve, domain, parameters::thickness(r));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_TRUE(result.empty_regions.empty());
  const Samples samples(domain, 20000, 1);
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

INSTANTIATE_TEST_SUITE_P(Region_paths, Narrow_neck, testing::Values(0.15, 0.2));

} // namespace test_region_paths
