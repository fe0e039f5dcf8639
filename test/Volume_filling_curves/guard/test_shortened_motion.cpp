// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

// Moving each node as far as those near it let it.
namespace test_shortened_motion {

using namespace guard_test;
using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;
using Guard = Isotopy_guard_3<>;
using Point = Network::Point_3;

// Anywhere on the lattice, or a step away.
Targets random_targets(const Curve& curve, bool is_planar, Random& random)
{
  const bool is_far = below(2, random) == 0;
  Targets targets(static_cast<Eigen::Index>(curve.points.size()), 3);
  for(std::size_t v = 0; v < curve.points.size(); ++v) {
    const Lattice_point step =
        random_point(3, is_planar, random) - Lattice_point{1, 1, is_planar ? 0 : 1};
    const Lattice_point p = is_far ? random_point(4, is_planar, random) : curve.points[v] + step;
    for(std::size_t i = 0; i < 3; ++i)
      targets(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(i)) =
          static_cast<double>(p[i]);
  }
  return targets;
}

TEST(Shortened_motion, is_an_isotopy_and_goes_straight)
{
  constexpr Integer scale = 64; // the least part of a way is 1 / 64
  Random random(1);
  std::size_t full = 0, shortened = 0;
  for(int k = 0; k < 3000; ++k) {
    const bool is_planar = k % 3 == 0;
    Network network = to_network(random_curve(4, is_planar, random));
    const Curve start = to_curve(network);
    const Targets targets = random_targets(start, is_planar, random);
    Guard guard(network);
    guard.start_recording();
    const Network before = network;
    const std::vector<double> fractions = guard.advance_nodes(targets);
    ASSERT_EQ(fractions.size(), start.points.size());
    const Curve after = to_curve(network, scale);
    for(std::size_t v = 0; v < fractions.size(); ++v)
      for(std::size_t i = 0; i < 3; ++i) {
        const double from = static_cast<double>(scale * start.points[v][i]);
        const double way =
            scale * targets(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(i)) - from;
        ASSERT_EQ(static_cast<double>(after.points[v][i]), from + fractions[v] * way);
      }
    ASSERT_TRUE(is_embedded(after));
    ASSERT_TRUE(verify_certificate(guard.certificate(), before, network).is_valid);
    for(const double fraction : fractions) ++(fraction == 1 ? full : shortened);
  }
  EXPECT_GT(full, 1000u);
  EXPECT_GT(shortened, 1000u);
}

TEST(Shortened_motion, goes_all_the_way_where_the_whole_can_be_certified)
{
  Random random(2);
  int count = 0;
  for(int k = 0; k < 1000; ++k) {
    Network together = to_network(random_curve(4, false, random)), each = together;
    const Targets targets = random_targets(to_curve(together), false, random);
    if(Guard(together).move_nodes(targets) < 1) continue;
    const std::vector<double> fractions = Guard(each).advance_nodes(targets);
    ASSERT_EQ(std::count(fractions.begin(), fractions.end(), 1), std::ptrdiff_t(fractions.size()));
    ASSERT_EQ(contents(together), contents(each));
    ++count;
  }
  EXPECT_GT(count, 100);
}

// n unit segments along x, each 10 above the last one, and one that stands between the first two.
Network ladder(std::size_t n)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  const auto add = [&](const Point& p, const Point& q) {
    edges.push_back({points.size(), points.size() + 1});
    points.push_back(p);
    points.push_back(q);
  };
  add({0.5, -1, 5}, {0.5, 1, 5});
  for(std::size_t k = 0; k < n; ++k)
    add({0, 0, 10. * static_cast<double>(k)}, {1, 0, 10. * static_cast<double>(k)});
  return {points, edges};
}

TEST(Shortened_motion, holds_only_what_is_in_the_way)
{
  Network network = ladder(100);
  Targets targets = internal::coordinates(network);
  for(Eigen::Index v = 2; v < targets.rows(); ++v) targets(v, 2) += 9;
  const std::vector<double> fractions = Guard(network).advance_nodes(targets);
  for(std::size_t v = 0; v < fractions.size(); ++v)
    EXPECT_EQ(fractions[v], v == 2 || v == 3 ? 0.5 : 1) << v; // that below the obstacle
}

TEST(Shortened_motion, keeps_the_clearance)
{
  Network network = ladder(3);
  Targets targets = internal::coordinates(network);
  targets(2, 2) = targets(3, 2) = 9;
  Guard guard(network);
  guard.set_clearance(1);
  EXPECT_EQ(guard.advance_nodes(targets)[2], 0.25); // not 0.5, which ends half a unit below
  EXPECT_EQ(network.point(2).z(), 2.25);
}

// An edge that is 2^-9 from another one cannot get past it, not even by a 64th of its way.
struct In_the_way
{
  In_the_way() { targets(2, 2) = targets(3, 2) = -1; }

  Network network{{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0x1p-9}, {0.5, 1, 0x1p-9}}, {{0, 1}, {2, 3}}};
  Targets targets = internal::coordinates(network);
};

TEST(Shortened_motion, holds_what_cannot_go_anywhere)
{
  In_the_way edges;
  const Network start = edges.network;
  Guard guard(edges.network);
  EXPECT_EQ(guard.advance_nodes(edges.targets), (std::vector<double>{1, 1, 0, 0}));
  EXPECT_EQ(contents(edges.network), contents(start));
}

TEST(Shortened_motion, lets_nothing_pass_whatever_the_limits)
{
  for(const double x : {-1., -100., std::numeric_limits<double>::quiet_NaN()}) {
    In_the_way edges;
    Guard guard(edges.network);
    guard.set_clearance(x);
    EXPECT_EQ(guard.advance_nodes(edges.targets)[2], 0) << x;
    EXPECT_EQ(guard.move_nodes(edges.targets), 0) << x;
    guard.set_bend_limits({1, 1, [x](const Point&) { return x; }});
    EXPECT_EQ(guard.advance_nodes(edges.targets)[2], 0) << x;
    EXPECT_EQ(guard.move_nodes(edges.targets), 0) << x;
  }
}

// Elsewhere an edge is in the way: otherwise the whole motion is tested at once.
TEST(Shortened_motion, folds_corners_unless_there_is_a_clearance)
{
  for(const double clearance : {0., 1e-3}) {
    Network network({Point(0, 0, 0), Point(1, 0, 0), Point(0.5, -1, 1), Point(0.5, 1, 1),
                     Point(9, 0, 0), Point(10, 0, 0), Point(11, 0, 0)},
                    {{0, 1}, {2, 3}, {4, 5}, {5, 6}});
    Targets targets = internal::coordinates(network);
    targets(2, 2) = targets(3, 2) = -1;
    targets(5, 1) = 100;
    Guard guard(network);
    guard.set_clearance(clearance);
    EXPECT_EQ(guard.advance_nodes(targets)[5] == 1, clearance == 0);
  }
}

TEST(Shortened_motion, refuses_targets_out_of_range)
{
  Network network = ladder(2);
  const Network start = network;
  Targets targets = internal::coordinates(network);
  targets(0, 0) = 1e200;
  Guard guard(network);
  EXPECT_EQ(guard.advance_nodes(targets), std::vector<double>(6, 0));
  EXPECT_EQ(contents(network), contents(start));
  EXPECT_EQ(guard.number_of_refused_changes(), 6u);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Shortened_motion, is_the_same_for_all_tags)
{
  Random random(3);
  std::uniform_real_distribution<double> offset(-20, 20);
  for(int repeat = 0; repeat < 10; ++repeat) {
    Network sequential = ladder(2000), parallel = sequential;
    Targets targets = internal::coordinates(sequential);
    for(Eigen::Index v = 0; v < targets.rows(); ++v) targets(v, 2) += offset(random);
    const auto expected = Guard(sequential).advance_nodes(targets);
    EXPECT_GT(std::count(expected.begin(), expected.end(), 1), 100);
    EXPECT_LT(std::count(expected.begin(), expected.end(), 1), 4000);
    ASSERT_EQ(Guard(parallel).advance_nodes<CGAL::Parallel_tag>(targets), expected);
    ASSERT_EQ(contents(parallel), contents(sequential));
  }
}
#endif

} // namespace test_shortened_motion
