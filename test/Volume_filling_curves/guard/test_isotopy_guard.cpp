// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace test_isotopy_guard {

using namespace guard_test;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Point = Network::Point_3;

Network ring(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 0; v < points.size(); ++v) edges.push_back({v, (v + 1) % points.size()});
  return {points, edges};
}

// Carries out random certified operations on random curves, and compares every answer with the
// criterion and with the truth.
struct Comparison
{
  enum Operation
  {
    MOVE,
    INSERT,
    REMOVE
  };

  explicit Comparison(unsigned seed) : random(seed) {}

  void run(std::size_t number_of_curves, std::size_t side, bool is_planar)
  {
    for(std::size_t k = 0; k < number_of_curves && !testing::Test::HasFatalFailure(); ++k) {
      Network network = to_network(random_curve(side, is_planar, random));
      Guard guard(network);
      for(int change = 0; change < 25 && !testing::Test::HasFatalFailure(); ++change)
        try_change(network, guard, random_point(side, is_planar, random));
      const auto number = guard.number_of_certified_changes() + guard.number_of_refused_changes();
      EXPECT_EQ(number, 25u);
    }
  }

  void try_change(const Network& network, Guard& guard, const Lattice_point& place)
  {
    const Curve before = to_curve(network);
    const std::vector<double> contents_before = contents(network);
    const std::size_t certified = guard.number_of_certified_changes();
    const std::size_t v = below(network.number_of_nodes(), random);
    const std::size_t e = below(network.number_of_edges(), random);
    const auto operation = static_cast<Operation>(below(3, random));
    bool is_expected = false, is_accepted = false;
    if(operation == MOVE) {
      is_expected = may_move(before, v, place);
      ASSERT_EQ(is_expected, stays_embedded(before, v, place));
      is_accepted = guard.move_node(v, to_point(place));
    } else if(operation == INSERT && before.points.size() < 12) {
      is_expected = may_insert(before, e, place);
      is_accepted = guard.insert_node(e, to_point(place));
    } else {
      is_expected = may_remove(before, v);
      is_accepted = guard.remove_node(v);
    }
    ++count[operation][is_accepted];
    ASSERT_EQ(is_accepted, is_expected) << "operation " << operation << " on\n"
                                        << text(before, v, e, place);
    ASSERT_EQ(guard.number_of_certified_changes(), certified + is_accepted);
    if(!is_accepted) {
      ASSERT_EQ(contents(network), contents_before);
    }
    ASSERT_TRUE(is_embedded(to_curve(network))) << text(before, v, e, place);
    if(network.has_garbage()) guard.collect_garbage();
  }

  static std::string text(const Curve& curve,
                          std::size_t v,
                          std::size_t e,
                          const Lattice_point& place)
  {
    std::ostringstream out;
    for(const auto& p : curve.points) out << "(" << p[0] << " " << p[1] << " " << p[2] << ") ";
    for(const auto& edge : curve.edges) out << edge[0] << "-" << edge[1] << " ";
    out << "node " << v << " edge " << e << " to " << place[0] << " " << place[1] << " "
        << place[2];
    return out.str();
  }

  void expect_both_outcomes(int least) const
  {
    for(const auto& of_operation : count)
      for(int number : of_operation) EXPECT_GT(number, least);
  }

  Random random;
  std::array<std::array<int, 2>, 3> count{};
};

TEST(Isotopy_guard, decides_as_brute_force_on_lattices_of_side_3)
{
  Comparison comparison(1);
  comparison.run(2500, 3, false);
  comparison.expect_both_outcomes(1000);
}

TEST(Isotopy_guard, decides_as_brute_force_on_lattices_of_side_5)
{
  Comparison comparison(2);
  comparison.run(2000, 5, false);
  comparison.expect_both_outcomes(1000);
}

TEST(Isotopy_guard, decides_as_brute_force_in_the_plane)
{
  Comparison comparison(3);
  comparison.run(3000, 4, true);
  comparison.expect_both_outcomes(1000);
}

TEST(Isotopy_guard, moves_triangles_through_a_plane_but_not_through_a_line)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}});
  Guard guard(network);
  EXPECT_FALSE(guard.remove_node(0));
  EXPECT_FALSE(guard.move_node(2, {3, 0, 0}));
  EXPECT_FALSE(guard.move_node(2, {0, 0, 0}));
  EXPECT_TRUE(guard.move_node(2, {1, 2, 5}));
  EXPECT_TRUE(guard.move_node(2, {1, 2, 5}));
}

TEST(Isotopy_guard, refuses_to_fold_edges_onto_each_other)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  Guard guard(network);
  EXPECT_FALSE(guard.move_node(2, {1, 0, 0}));  // onto an edge
  EXPECT_FALSE(guard.move_node(2, {-1, 2, 0})); // over node 3
  EXPECT_FALSE(guard.move_node(2, {0, 0, 0}));  // onto a node
  EXPECT_FALSE(guard.insert_node(0, {3, 0, 0}));
  EXPECT_FALSE(guard.insert_node(0, {2, 0, 0}));
  EXPECT_FALSE(guard.insert_node(0, {1, 2, 0}));
  EXPECT_TRUE(guard.insert_node(0, {1, 0, 0}));
  EXPECT_TRUE(guard.insert_node(1, {3, 1, 0}));
  EXPECT_EQ(guard.number_of_certified_changes(), 2u);
  EXPECT_EQ(guard.number_of_refused_changes(), 6u);
}

// Mirrors a planar polygon's node at the line of its neighbors: the way leads between them.
TEST(Isotopy_guard, accepts_what_two_triangles_tested_in_turn_would_refuse)
{
  Network network = ring({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {-2, 2, 0}});
  Guard guard(network);
  EXPECT_TRUE(guard.move_node(4, {1, 2, 0}));
  EXPECT_TRUE(guard.move_node(4, {0, 1, 0}));
  EXPECT_FALSE(guard.move_node(4, {0, 5, 0}));
}

TEST(Isotopy_guard, keeps_pinned_nodes_ends_and_junctions)
{
  Curve tripod;
  for(std::size_t k = 0; k < 3; ++k)
    add_strand(tripod, 3, false, k == 0 ? brute_force::no_node : 0);
  tripod.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 0, 1}, {0, 0, 2}};
  Network network = to_network(tripod);
  Guard guard(network);
  for(std::size_t v = 0; v < 7; ++v) {
    const std::size_t degree = network.degree(v);
    network.set_pinned(v, degree == 2);
    EXPECT_FALSE(guard.remove_node(v));
    network.set_pinned(v, false);
  }
}

TEST(Isotopy_guard, refuses_positions_that_are_not_finite_or_too_far)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const std::vector<double> before = contents(network);
  Guard guard(network);
  for(double x :
      {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e151}) {
    EXPECT_FALSE(guard.move_node(0, Point(0, x, 0)));
    EXPECT_FALSE(guard.insert_node(0, Point(x, 0, 0)));
    Targets targets = CGAL::Volume_filling_curves::internal::coordinates(network);
    targets(1, 2) = x;
    EXPECT_EQ(guard.move_nodes(targets, 0.125), 0);
  }
  EXPECT_EQ(contents(network), before);
}

TEST(Isotopy_guard, counts_moves_of_all_nodes_by_node)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  Guard guard(network);
  Targets targets = CGAL::Volume_filling_curves::internal::coordinates(network);
  targets.col(2).setConstant(1);
  EXPECT_EQ(guard.move_nodes(targets), 1);
  EXPECT_EQ(guard.number_of_certified_changes(), 4u);
  targets.setZero();
  EXPECT_EQ(guard.move_nodes(targets), 0);
  EXPECT_EQ(guard.number_of_refused_changes(), 4u);
}

TEST(Isotopy_guard, adds_rays_that_meet_nothing)
{
  Random random(4);
  std::array<int, 2> count{};
  for(int k = 0; k < 5000; ++k) {
    const Curve curve = random_curve(3, k % 2 == 0, random);
    Network network = to_network(curve);
    const std::vector<double> before = contents(network);
    Guard guard(network);
    const std::size_t v = below(network.number_of_nodes(), random);
    const Lattice_point tip = random_point(4, k % 2 == 0, random);
    Curve with_ray = to_curve(network);
    with_ray.edges.push_back({v, with_ray.points.size()});
    with_ray.points.push_back(tip);
    const bool is_added = guard.add_ray(v, to_point(tip));
    ++count[is_added];
    ASSERT_EQ(is_added, network.degree(v) == 1 + std::size_t(is_added) && is_embedded(with_ray));
    guard.remove_rays();
    ASSERT_EQ(contents(network), before);
  }
  EXPECT_GT(count[0], 100);
  EXPECT_GT(count[1], 100);
}

TEST(Isotopy_guard, keeps_rays_clear_and_in_range)
{
  Network network({{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {3, 2, 0}}, {{0, 1}, {2, 3}});
  Guard guard(network);
  EXPECT_FALSE(guard.add_ray(1, {1e151, 0, 0}));
  guard.set_clearance(1.1);
  EXPECT_FALSE(guard.add_ray(1, {5, 0, 0}));
  guard.set_clearance(0.9);
  EXPECT_TRUE(guard.add_ray(1, {5, 0, 0}));
  EXPECT_FALSE(guard.move_node(2, {3, -1, 0}));
  EXPECT_EQ(guard.number_of_refused_changes(), 3u);
}

TEST(Isotopy_guard, keeps_ends_that_have_rays)
{
  Network network({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  Guard guard(network);
  ASSERT_TRUE(guard.insert_node(0, {0.5, 0, 0}));
  ASSERT_TRUE(guard.add_ray(1, {5, 0, 0}));
  ASSERT_TRUE(guard.insert_node(2, {3, 0, 0})); // into the ray
  EXPECT_FALSE(guard.remove_node(1));
  EXPECT_TRUE(guard.remove_node(2));
  guard.remove_rays();
  EXPECT_EQ(network.number_of_nodes(), 2u);
  EXPECT_EQ(network.point(1), Network::Point_3(1, 0, 0));
}

TEST(Isotopy_guard, removes_rays_behind_gaps_in_the_numbering)
{
  Network network({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1}, {1, 2}, {2, 3}});
  Guard guard(network);
  ASSERT_TRUE(guard.remove_node(1));
  ASSERT_TRUE(guard.add_ray(3, {9, 0, 0}));
  guard.remove_rays();
  EXPECT_FALSE(network.has_garbage());
  EXPECT_EQ(network.number_of_nodes(), 3u);
}

// A node that goes to and fro for ever leaves no trail behind.
TEST(Isotopy_guard, does_not_slow_down_with_the_number_of_changes)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {-1, 1, 0}});
  Guard guard(network);
  for(int k = 0; k < 100000; ++k) ASSERT_TRUE(guard.move_node(2, {2, 2, 0.1 * (k % 2)}));
}

// A second guard would not know what the first one changes, and would certify what is not there.
TEST(Isotopy_guard, is_the_only_one_of_its_network)
{
  Network network = ring({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  {
    Guard guard(network);
    EXPECT_THROW(Guard second(network), std::logic_error);
    EXPECT_TRUE(guard.move_node(0, {-1, 0, 0}));
    Network copy(network);
    Guard guard_of_copy(copy);
    EXPECT_TRUE(guard_of_copy.move_node(0, {-2, 0, 0}));
  }
  Guard next(network);
  EXPECT_TRUE(next.move_node(0, {-3, 0, 0}));
}

} // namespace test_isotopy_guard
