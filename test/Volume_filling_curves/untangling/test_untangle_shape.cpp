// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

// Curves like cables, which bend no more tightly and come no closer to themselves than they may.
namespace test_untangle_shape {

using namespace untangle_test;
namespace VFC = CGAL::Volume_filling_curves;
using VFC::Untangling_strategy;

// By the measures, which count strands from half of a turn of the bend radius on.
void expect_shape(const Network& curve, double bend_radius, double strand_distance)
{
  const double half_turn = CGAL_PI * (std::max)(bend_radius, strand_distance / 2);
  EXPECT_GE(VFC::min_bend_radius(curve), (1 - 1e-9) * bend_radius);
  EXPECT_GE(VFC::min_clearance(curve, half_turn), (1 - 1e-9) * strand_distance);
}

// Expects limits to be kept, with a record that proves the curve isotopic to the start.
template <typename NamedParameters>
void expect_shape_of(Network curve,
                     double bend_radius,
                     double strand_distance,
                     const NamedParameters& np)
{
  const Network start = curve;
  VFC::Isotopy_certificate certificate;
  const Untangling_result result = untangle(curve, np.bend_radius(bend_radius)
                                                       .strand_distance(strand_distance)
                                                       .certificate(std::ref(certificate)));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_TRUE(result.shape_excesses.empty());
  EXPECT_TRUE(result.is_closure_kept);
  expect_shape(curve, bend_radius, strand_distance);
  EXPECT_TRUE(VFC::verify_certificate(certificate, start, curve).is_valid);
  for(const std::size_t v : curve.nodes())
    EXPECT_TRUE(!curve.is_pinned(v) || curve.point(v) == start.point(curve.origin(v)));
}

Network trefoil()
{
  return tangled(braid("1 1 1", 60), 1);
}

// Two hooked arcs with pinned ends.
Network clasp()
{
  std::vector<Vector> points;
  Edges edges;
  for(const bool is_first : {true, false})
    for(int k = -10; k <= 10; ++k) {
      const double x = 0.1 * k, y = 0.8 - 1.3 * x * x;
      points.push_back(is_first ? Vector(x, 0.05 * x, y) : Vector(0.05 * x, x, -y));
      if(k > -10) edges.push_back({points.size() - 2, points.size() - 1});
    }
  Network curve = network_of(points, edges);
  curve.pin_ends();
  return curve;
}

TEST(Untangle_shape, keeps_bends_and_strands_of_a_trefoil)
{
  for(const auto& [radius, distance] :
      std::vector<std::pair<double, double>>{{0.1, 0.15}, {0.1, 0}, {0, 0.15}, {0.05, 0.3}})
    expect_shape_of(trefoil(), radius, distance, parameters::random_seed(0));
}

// The descent of the ropelength alone ends with bends of half a thickness.
TEST(Untangle_shape, keeps_bends_of_a_tightened_trefoil)
{
  Network tight = trefoil();
  const Untangling_result result =
      untangle(tight, parameters::thickness(0.15).lower_ropelength(true));
  ASSERT_TRUE(result.is_ropelength_lowered);
  ASSERT_LT(VFC::min_bend_radius(tight), 0.1);
  expect_shape_of(trefoil(), 0.1, 0.14, parameters::thickness(0.15).lower_ropelength(true));
}

TEST(Untangle_shape, keeps_bends_and_strands_of_a_clasp)
{
  expect_shape_of(clasp(), 0.1, 0.1, parameters::random_seed(0));
  expect_shape_of(clasp(), 0.1, 0.3, parameters::random_seed(0));
}

// A proved unknot does not flow at all.
TEST(Untangle_shape, rounds_the_corners_of_a_triangle)
{
  Network triangle = internal::closed_network({{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}});
  const Untangling_result result = untangle(
      triangle, parameters::strategy(Untangling_strategy::FLOW).bend_radius(2).strand_distance(1));
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_FALSE(result.is_round);
  expect_shape(triangle, 2, 1);
  EXPECT_GT(VFC::length(triangle), 20);
}

TEST(Untangle_shape, leaves_a_ring_round)
{
  Network ring = braid("", 40);
  const Untangling_result result = untangle(ring, parameters::bend_radius(0.5));
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_TRUE(result.is_round);
  expect_shape(ring, 0.5, 0);
}

TEST(Untangle_shape, leaves_the_thickness_if_it_is_large_enough)
{
  Network curve = braid("1 1 1", 60);
  const double usual = VFC::default_thickness(curve);
  const Untangling_result result =
      untangle(curve, parameters::bend_radius(0.01 * usual).strategy(Untangling_strategy::FLOW));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_EQ(result.thickness, usual);
}

// A trefoil is at least 16 times as long as its strands are apart.
TEST(Untangle_shape, says_where_a_knot_is_too_short_for_it)
{
  Network curve = braid("1 1 1", 60);
  const double distance = VFC::length(curve) / 15;
  ASSERT_LT(distance, internal::box_diagonal(curve));
  const Untangling_result result =
      untangle(curve, parameters::strand_distance(distance).keep_length(true));
  EXPECT_EQ(result.status, Untangling_status::CONSTRAINT_NOT_REACHED);
  ASSERT_EQ(result.shape_excesses.size(), 1u);
  const auto& excess = result.shape_excesses.front();
  EXPECT_FALSE(excess.is_bend);
  EXPECT_EQ(excess.limit, distance);
  EXPECT_NEAR(excess.value, VFC::min_clearance(curve, CGAL_PI / 2 * distance), 1e-9);
}

TEST(Untangle_shape, is_told_in_a_domain_without_room_for_it)
{
  const VFC::Box_domain_3<> box({-1, -1, -0.3}, {1, 1, 0.3});
  const Network ring = braid("", 40);
  for(const double radius : {0.5, 1.1}) {
    Network curve = transformed(ring, 0.4);
    const auto result = untangle(curve, box, parameters::bend_radius(radius));
    const bool fits = radius < 1;
    EXPECT_EQ(result.status,
              fits ? Untangling_status::UNKNOTTED : Untangling_status::CONSTRAINT_NOT_REACHED);
    EXPECT_EQ(result.shape_excesses.empty(), fits);
    EXPECT_EQ(VFC::min_bend_radius(curve) >= radius * (1 - 1e-9), fits);
  }
}

TEST(Untangle_shape, is_refused_if_it_makes_no_sense)
{
  Network curve = trefoil();
  EXPECT_THROW(untangle(curve, parameters::bend_radius(100)), std::invalid_argument);
  EXPECT_THROW(untangle(curve, parameters::strand_distance(100)), std::invalid_argument);
  EXPECT_THROW(untangle(curve, parameters::bend_radius(-1)), std::invalid_argument);
  EXPECT_THROW(untangle(curve, parameters::bend_radius(0.1).strategy(Untangling_strategy::SEARCH)),
               std::invalid_argument);
}

TEST(Untangle_shape, is_the_same_in_parallel)
{
  const auto asked_for = parameters::thickness(0.15).lower_ropelength(true).bend_radius(0.1);
  Network once = trefoil(), again = once;
  untangle<CGAL::Sequential_tag>(once, asked_for);
  untangle<CGAL::Parallel_if_available_tag>(again, asked_for);
  EXPECT_EQ(contents(once), contents(again));
}

} // namespace test_untangle_shape
