// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

// Is the guard needed, and does it hold? Changes that would spoil a knot are refused; carried out
// behind its back they are noticed by the invariants that thousands of certified changes keep.
namespace test_sabotage {

using namespace guard_test;
namespace internal = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::parse_braid_word;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Point = Network::Point_3;
using knot_test::Invariants;
using knot_test::invariants_of;
using knot_test::loops_of;

// The trefoil of six edges.
const Curve trefoil = {{{6, 5, 3}, {-4, -5, 6}, {-6, 5, -3}, {2, -1, 6}, {3, -1, 3}, {-6, 3, 5}},
                       {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}};

Curve braid(const std::string& word, std::size_t number_of_nodes, double scale)
{
  const auto polygons = internal::braid_closure(parse_braid_word(word), number_of_nodes);
  return to_curve(internal::closed_network(polygons), scale);
}

// returns whether the network would be embedded, but another knot or link, with node v at `target`
bool is_spoilt(const Network& network, std::size_t v, const Lattice_point& target)
{
  Curve curve = to_curve(network);
  curve.points[v] = target;
  return is_embedded(curve) &&
         !(invariants_of(loops_of(to_network(curve))) == invariants_of(loops_of(network)));
}

// Every move that would change a knot is refused: all moves of all nodes on a lattice.
void expect_spoiling_moves_to_be_refused(const Curve& curve, Integer reach, Integer step, int least)
{
  int number_of_spoilt = 0;
  for(std::size_t v = 0; v < curve.points.size(); ++v)
    for(Integer x = -reach; x <= reach; x += step)
      for(Integer y = -reach; y <= reach; y += step)
        for(Integer z = -reach; z <= reach; z += step) {
          Network network = to_network(curve);
          const Lattice_point target = {x, y, z};
          if(!is_spoilt(network, v, target)) continue;
          ++number_of_spoilt;
          ASSERT_FALSE(Guard(network).move_node(v, to_point(target))) << "node " << v;
          ASSERT_EQ(contents(network), contents(to_network(curve)));
        }
  EXPECT_GT(number_of_spoilt, least);
}

TEST(Sabotage, a_move_that_unties_a_trefoil_is_refused)
{
  ASSERT_EQ(invariants_of(loops_of(to_network(trefoil))).determinant, 3u);
  expect_spoiling_moves_to_be_refused(trefoil, 8, 2, 1000);
}

TEST(Sabotage, a_move_that_unlinks_a_link_is_refused)
{
  const Curve hopf = {
      {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, {0, 0, -3}, {0, 0, 3}, {8, 0, 0}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 4}}};
  ASSERT_EQ(std::abs(invariants_of(loops_of(to_network(hopf))).linking_numbers[0][1]), 1);
  expect_spoiling_moves_to_be_refused(hopf, 9, 3, 500);
}

TEST(Sabotage, a_collapse_of_a_pierced_triangle_is_refused)
{
  Network network = to_network(trefoil);
  Guard guard(network);
  for(std::size_t v = 0; v < network.number_of_nodes(); ++v) EXPECT_FALSE(guard.remove_node(v));
  EXPECT_EQ(contents(network), contents(to_network(trefoil)));
}

// The exact midpoint of an edge is no double; the rounded one lies beyond a strand.
TEST(Sabotage, a_rounded_midpoint_beyond_a_strand_is_refused)
{
  const double ulp = std::numeric_limits<double>::epsilon();
  const Point a(1, 1, 0), c(1 + ulp, 3, 0), above(1 + ulp, 2, 0), below(1, 2, 0);
  for(double x : {1., 1 + ulp}) { // a strand on either side of the edge, half a unit away
    const Network before({a, c, {x, 2, -1}, {x, 2, 1}}, {{0, 1}, {2, 3}});
    for(const Point& middle : {above, below}) {
      Network network = before;
      Guard guard(network);
      EXPECT_EQ(guard.insert_node(0, middle), middle.x() != x);
      EXPECT_EQ(contents(network) == contents(before), middle.x() == x);
    }
  }
  Network beyond({a, {1 + 8 * ulp, 3, 0}, {1 + 5 * ulp, 2, -1}, {1 + 5 * ulp, 2, 1}},
                 {{0, 1}, {2, 3}});
  Guard guard(beyond);
  EXPECT_FALSE(guard.insert_node(0, {1 + 6 * ulp, 2, 0}));
  EXPECT_FALSE(guard.insert_node(0, {1 + 5 * ulp, 2, 0}));
  EXPECT_TRUE(guard.insert_node(0, {1 + 3 * ulp, 2, 0}));
}

template <typename T, typename = void>
struct Has_mutable_point : std::false_type
{};

template <typename T>
struct Has_mutable_point<T, std::void_t<decltype(std::declval<T&>().point(0) = Point())>>
    : std::true_type
{};

TEST(Sabotage, networks_have_no_door_but_the_guard)
{
  using Size = std::size_t;
  static_assert(!Has_mutable_point<Network>::value);
  static_assert(std::is_same_v<decltype(std::declval<Network&>().point(0)), const Point&>);
  static_assert(std::is_same_v<decltype(std::declval<Network&>().source(0)), Size>);
  static_assert(std::is_same_v<decltype(std::declval<Network&>().target(0)), Size>);
  static_assert(std::is_same_v<decltype(std::declval<Network&>().neighbor(0, 0)), Size>);
  static_assert(std::is_same_v<decltype(std::declval<Network&>().incident_edge(0, 0)), Size>);
  static_assert(
      std::is_same_v<decltype(std::declval<Network&>().traits()), const Network::Traits&>);
  static_assert(std::is_same_v<decltype(std::declval<Guard&>().curve()), const Network&>);
  static_assert(!std::is_copy_constructible_v<Guard> && !std::is_copy_assignable_v<Guard>);
}

// Certified changes without aim: displacements of all sizes, inserts, removals, moves of all nodes.
struct Random_walk
{
  Random_walk(const Curve& start, double unit, bool is_on_lattice, unsigned seed)
      : network(to_network(start)),
        guard(network),
        m_unit(unit),
        m_is_on_lattice(is_on_lattice),
        random(seed)
  {}

  void run(int number_of_changes)
  {
    for(int k = 0; k < number_of_changes; ++k) {
      const std::size_t n = network.number_of_nodes();
      const std::size_t e = below(network.number_of_edges(), random), v = below(n, random);
      const std::size_t dice = below(100, random);
      if(dice < 3)
        move_all();
      else if(dice < 30)
        guard.remove_node(v);
      else if(dice < 45 && n < 60)
        guard.insert_node(e, near(network.point(network.source(e))));
      else
        guard.move_node(v, near(network.point(v)));
      if(network.has_garbage()) guard.collect_garbage();
    }
  }

  Point near(const Point& p) { return {near(p.x()), near(p.y()), near(p.z())}; }

  double near(double x)
  {
    const double size =
        m_unit * std::ldexp(4, -static_cast<int>(below(m_is_on_lattice ? 3 : 12, random)));
    const double y = x + size * std::uniform_real_distribution<double>(-1, 1)(random);
    const double limit = 30 * m_unit;
    return (std::max)(-limit, (std::min)(limit, m_is_on_lattice ? std::round(y) : y));
  }

  void move_all()
  {
    Targets targets(static_cast<Eigen::Index>(network.number_of_nodes()), 3);
    for(Eigen::Index v = 0; v < targets.rows(); ++v) {
      const Point& p = network.point(static_cast<std::size_t>(v));
      const Point q = below(4, random) == 0 ? near(p) : p;
      targets.row(v) << q.x(), q.y(), q.z();
    }
    guard.move_nodes(targets, m_is_on_lattice ? 1 : 0.125);
  }

  Network network;
  Guard guard;
  double m_unit;
  bool m_is_on_lattice;
  Random random;
};

class Knot_types : public testing::TestWithParam<const char*>
{};

TEST_P(Knot_types, are_kept_by_certified_changes)
{
  for(bool is_on_lattice : {true, false}) {
    const Curve start = braid(GetParam(), 90, 10);
    const Invariants expected = invariants_of(loops_of(to_network(start)));
    Random_walk walk(start, 5, is_on_lattice, 7);
    for(int k = 0; k < 10; ++k) {
      walk.run(3000);
      ASSERT_EQ(invariants_of(loops_of(walk.network)), expected);
    }
    EXPECT_GT(walk.guard.number_of_certified_changes(), 10000u);
    EXPECT_GT(walk.guard.number_of_refused_changes(), 5000u);
  }
}

// Trefoils of both hands, the figure eight, 5_2, Hopf's and Whitehead's link, Borromean rings.
INSTANTIATE_TEST_SUITE_P(
    Sabotage,
    Knot_types,
    testing::Values(
        "1 1 1", "-1 -1 -1", "1 -2 1 -2", "1 1 1 2 -1 2", "1 1", "1 -2 1 -2 -2", "1 -2 1 -2 1 -2"));

TEST(Sabotage, hands_are_told_apart)
{
  const Invariants left = invariants_of(loops_of(to_network(braid("-1 -1 -1", 90, 10))));
  const Invariants right = invariants_of(loops_of(to_network(braid("1 1 1", 90, 10))));
  EXPECT_EQ(left.determinant, 3u);
  EXPECT_EQ(left.signature, -right.signature);
  EXPECT_NE(left.signature, 0);
}

} // namespace test_sabotage
