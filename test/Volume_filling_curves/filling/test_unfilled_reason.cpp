// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Neck_search.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

// Reasons for what a curve has left empty are true.
namespace test_unfilled_reason {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using Box = VFC::Box_domain_3<Kernel>;
using Mesh_domain = VFC::Triangle_mesh_domain_3<Kernel>;
using Unfilled = VFC::internal::Unfilled_space<Curve, VFC::Domain_samples_3<Traits, Box>>;

bool never()
{
  return false;
}

const Curve small_triangle(std::vector<Point>{
    {0.2, 0.2, 0.2}, {0.3, 0.2, 0.2}, {0.2, 0.3, 0.2}, {0.2, 0.2, 0.2}});

TEST(Neck, is_narrower_than_r_or_is_none)
{
  // the neck between the chambers is 0.2 wide
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_chambers()));
  const VFC::internal::Vector beyond(2.3, 0.5, 0.5), on_this_side(0.5, 0.5, 0.5);
  VFC::internal::Neck_search<Curve, Mesh_domain> necks(small_triangle, domain, never);
  EXPECT_TRUE(necks.is_behind_neck(beyond, 0.45));
  EXPECT_FALSE(necks.is_behind_neck(beyond, 0.1));
  EXPECT_FALSE(necks.is_behind_neck(on_this_side, 0.3));
}

TEST(Neck, is_not_claimed_after_a_search_that_was_ended)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::two_chambers()));
  VFC::internal::Neck_search<Curve, Mesh_domain> necks(small_triangle, domain, [] { return true; });
  EXPECT_FALSE(necks.is_behind_neck({2.3, 0.5, 0.5}, 0.45));
}

TEST(Unfilled_reason, is_no_neck_in_a_convex_box)
{
  const Box box(Point(0, 0, 0), Point(4, 2, 1));
  Curve curve;
  const auto result = VFC::fill(curve, box,
                                preview(0.2)
                                    .direction_field([](const Point&) {
                                      return std::array<double, 3>{1, 0, 0};
                                    })
                                    .direction_weight(50));
  ASSERT_EQ(result.status, Filling_status::PARTIAL);
  ASSERT_EQ(result.empty_regions.size(), 2u);
  EXPECT_GT(result.crowded_fraction, 0.05); // strands stay together that cannot turn
  EXPECT_NE(result.reason.find("; the curve did not reach 2 empty regions"), std::string::npos)
      << result.reason;
}

// Two cubes of side 1 that a neck of width 0.02 joins.
meshes::Soup cubes_and_neck()
{
  std::vector<std::array<int, 3>> voxels = {{3, 1, 1}};
  for(int x : {0, 1, 2, 4, 5, 6})
    for(int y = 0; y < 3; ++y)
      for(int z = 0; z < 3; ++z) voxels.push_back({x, y, z});
  const std::vector<double> places = {0, 0.49, 0.51, 1};
  const auto soup = exact_surface::stretched(
      exact_surface::stretched(meshes::voxels(voxels), 1, places), 2, places);
  return exact_surface::stretched(soup, 0, {0, 0.3, 0.7, 1, 1.5, 1.8, 2.2, 2.5});
}

TEST(Unfilled_reason, is_a_neck_where_there_is_one)
{
  const Mesh_domain domain(meshes::to_mesh(cubes_and_neck()));
  Curve curve = small_triangle;
  const auto result = VFC::fill(curve, domain, preview(0.2));
  EXPECT_EQ(result.status, Filling_status::PARTIAL);
  EXPECT_EQ(result.reason,
            "the curve did not get through a neck narrower than r to 1 empty region");
}

// The space that a curve leaves, with too little time to find the empty regions in it.
struct Slow_unfilled_space : Unfilled
{
  using Unfilled::Unfilled;

  template <typename Thickness>
  std::vector<VFC::Empty_region_3<Point>> regions(const Curve&,
                                                  const std::vector<double>&,
                                                  const Thickness&) const
  {
    throw VFC::internal::Run_stopped();
  }
};

TEST(Empty_regions, are_unknown_if_there_was_no_time_to_search)
{
  const Box box(Point(0, 0, 0), Point(4, 2, 1));
  const VFC::Domain_samples_3<Traits, Box> samples(box, 2000, 1);
  const Unfilled::Distances boundary_distances(box, samples.points());
  const auto thickness = [](const Point&) { return 0.2; };
  const auto measured = [&](const auto& unfilled) {
    VFC::internal::Run_watch watch;
    VFC::Filling_result<Point> result;
    VFC::internal::measure_filling(result, unfilled, small_triangle, thickness, watch, [] {});
    return result;
  };
  const auto known = measured(Unfilled(samples, boundary_distances, VFC::Wall::COVER));
  EXPECT_TRUE(known.are_empty_regions_known);
  EXPECT_FALSE(known.empty_regions.empty());
  const auto unknown = measured(Slow_unfilled_space(samples, boundary_distances, VFC::Wall::COVER));
  EXPECT_FALSE(unknown.are_empty_regions_known);
  EXPECT_EQ(unknown.uncovered_fraction, known.uncovered_fraction);
}

TEST(Uncovered_fraction, is_of_the_whole_volume_if_the_boundary_is_kept_clear)
{
  const Box box(Point(0, 0, 0), Point(4, 2, 1));
  Curve curve;
  const auto result = VFC::fill(curve, box, preview(0.2).wall(VFC::Wall::KEEP_CLEAR));
  const VFC::Domain_samples_3<Traits, Box> samples(box, 20000, 1);
  const double whole = VFC::unfilled_fraction(samples, VFC::sample_distances(curve, samples), 0.2);
  EXPECT_GT(whole, 0.05);
  EXPECT_NEAR(result.uncovered_fraction, whole, 0.01);
  EXPECT_LE(result.unfilled_fraction, 0.01);
}

TEST(Spacing, is_refused_above_the_thickness)
{
  Curve curve;
  try {
    (void)VFC::fill(curve, Box(Point(0, 0, 0), Point(1, 1, 1)), np::spacing(5));
    FAIL();
  } catch(const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "spacing is 5, but must be positive and at most 1");
  }
}

} // namespace test_unfilled_reason
