// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

// Moving all nodes: compared with brute force on lattices, and with a test of all pairs of edges
// and between numbers of threads on long curves.
namespace test_certified_motion {

using namespace guard_test;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using CGAL::Sequential_tag;
using CGAL::Volume_filling_curves::internal::Broad_phase;
using CGAL::Volume_filling_curves::internal::Vector_field;

// Takes all pairs for candidates.
struct All_pairs
{
  std::size_t number_of_edges;

  template <typename ConcurrencyTag, typename Margin>
  All_pairs(
      ConcurrencyTag, const Network& curve, const Vector_field&, const Vector_field&, const Margin&)
      : number_of_edges(curve.number_of_edges())
  {}

  template <typename ConcurrencyTag, typename Predicate>
  std::vector<Broad_phase::Edge_pair> pairs(const Predicate& is_wanted) const
  {
    std::vector<Broad_phase::Edge_pair> all;
    for(std::uint32_t e = 0; e < number_of_edges; ++e)
      for(std::uint32_t f = 0; f < e; ++f)
        if(is_wanted(e, f)) all.push_back({e, f});
    return all;
  }
};

constexpr Integer scale = 64; // makes an eighth of a quarter of the way an integer

// returns how the guard must get to the part 1 / `divisor` of the way, as "rounds, reversed", or {}
std::pair<int, bool> way_to(const Curve& start,
                            const std::vector<Lattice_point>& way,
                            Integer divisor)
{
  for(Integer rounds : {1, 2, 4, 8})
    for(bool is_reversed : {false, true}) {
      Curve curve = start;
      bool is_safe = true;
      for(Integer k = 1; k <= rounds && is_safe; ++k) {
        std::vector<Lattice_point> targets;
        for(std::size_t v = 0; v < way.size(); ++v)
          targets.push_back(start.points[v] + (k * scale / (rounds * divisor)) * way[v]);
        is_safe = may_move_all(curve, targets, is_reversed);
        curve.points = targets;
      }
      if(is_safe) return {static_cast<int>(rounds), is_reversed};
    }
  return {0, false};
}

// Some nodes move on the lattice, by as little as a step or to anywhere.
std::vector<Lattice_point> random_way(const Curve& curve, bool is_planar, Random& random)
{
  const std::size_t kind = below(4, random);
  const Lattice_point common =
      random_point(3, is_planar, random) - Lattice_point{1, 1, is_planar ? 0 : 1};
  std::vector<Lattice_point> way;
  for(const Lattice_point& p : curve.points) {
    const Lattice_point step =
        random_point(3, is_planar, random) - Lattice_point{1, 1, is_planar ? 0 : 1};
    if(kind == 0)
      way.push_back(Integer(3) * common);
    else if(kind == 1)
      way.push_back(random_point(4, is_planar, random) - p);
    else if(below(kind, random) == 0)
      way.push_back(step);
    else
      way.push_back({0, 0, 0});
  }
  return way;
}

template <typename ConcurrencyTag = Sequential_tag>
std::pair<double, std::vector<double>> moved(Network network,
                                             const Targets& targets,
                                             double min_fraction)
{
  Guard guard(network);
  const double fraction = guard.move_nodes<ConcurrencyTag>(targets, min_fraction);
  return {fraction, contents(network)};
}

// returns the part of the motion that is certified if all pairs are tested, as the guard searches
// it
double fraction_by_all_pairs(const Network& network, const Targets& targets, double min_fraction)
{
  using namespace CGAL::Volume_filling_curves::internal;
  using Unbounded = Guard::Boundary;
  const Unbounded walls;
  using Limits = Motion_limits<Network, Unbounded, All_pairs>;
  const Limits limits(Sequential_tag(), network, targets, Clearance_rule(), walls);
  const Certified_motion<Limits, Sequential_tag> motion(limits);
  for(double fraction = 1; fraction >= min_fraction; fraction /= 2)
    if(!motion.certify(fraction).positions.empty()) return fraction;
  return 0;
}

// Counts the ways in which motions were certified.
std::map<std::pair<int, bool>, int> compare_with_brute_force(int number_of_motions,
                                                             bool is_planar,
                                                             unsigned seed)
{
  Random random(seed);
  std::map<std::pair<int, bool>, int> count;
  for(int k = 0; k < number_of_motions && !testing::Test::HasFatalFailure(); ++k) {
    const Network network = to_network(random_curve(4, is_planar, random));
    const Curve unscaled = to_curve(network), start = to_curve(network, scale);
    const std::vector<Lattice_point> way = random_way(unscaled, is_planar, random);
    Targets targets(static_cast<Eigen::Index>(way.size()), 3);
    for(std::size_t v = 0; v < way.size(); ++v)
      for(std::size_t i = 0; i < 3; ++i)
        targets(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(i)) =
            static_cast<double>(unscaled.points[v][i] + way[v][i]);
    const Integer min_divisor = k % 2 == 0 ? 1 : 4;
    Integer divisor = 1;
    std::pair<int, bool> expected = way_to(start, way, divisor);
    while(expected.first == 0 && divisor < min_divisor) expected = way_to(start, way, divisor *= 2);
    ++count[expected];
    const double min_fraction = 1 / static_cast<double>(min_divisor);
    const double fraction = expected.first > 0 ? 1 / static_cast<double>(divisor) : 0;
    EXPECT_EQ(fraction_by_all_pairs(network, targets, min_fraction), fraction);
    Network after = network;
    Guard guard(after);
    EXPECT_EQ(guard.move_nodes(targets, min_fraction), fraction);
    for(std::size_t v = 0; v < way.size(); ++v)
      EXPECT_EQ(to_curve(after, scale).points[v],
                start.points[v] + static_cast<Integer>(scale * fraction) * way[v]);
    EXPECT_TRUE(is_embedded(to_curve(after, scale)));
    if(testing::Test::HasFailure()) break;
  }
  return count;
}

TEST(Certified_motion, decides_as_brute_force_in_space)
{
  const auto count = compare_with_brute_force(2000, false, 1);
  EXPECT_GT(count.at({0, false}), 200);
  EXPECT_GT(count.at({1, false}), 500);
  EXPECT_GT(count.at({1, true}), 50);
  EXPECT_GT(count.at({2, false}) + count.at({4, false}), 50);
}

TEST(Certified_motion, decides_as_brute_force_in_the_plane)
{
  const auto count = compare_with_brute_force(2000, true, 2);
  EXPECT_GT(count.at({0, false}), 200);
  EXPECT_GT(count.at({1, false}), 500);
  EXPECT_GT(count.at({1, true}), 50);
}

// A tangle of n nodes: strands of a long curve wound around a torus, shaken.
Network torus_curve(std::size_t n)
{
  constexpr double turn = 6.283185307179586;
  std::vector<Network::Point_3> points;
  for(std::size_t v = 0; v < n; ++v) {
    const double t = turn * static_cast<double>(v) / static_cast<double>(n);
    const double r = 2 + std::cos(11 * t);
    points.emplace_back(r * std::cos(7 * t), r * std::sin(7 * t), std::sin(11 * t));
  }
  return Network(points, CGAL::Volume_filling_curves::parameters::closure(
                             CGAL::Volume_filling_curves::Closure::CLOSED));
}

Targets shaken(const Network& network, double amplitude, bool is_common, Random& random)
{
  Targets targets = CGAL::Volume_filling_curves::internal::coordinates(network);
  std::uniform_real_distribution<double> offset(-amplitude, amplitude);
  const Eigen::RowVector3d common(offset(random), offset(random), offset(random));
  for(Eigen::Index v = 0; v < targets.rows(); ++v)
    targets.row(v) +=
        is_common ? common : Eigen::RowVector3d(offset(random), offset(random), offset(random));
  return targets;
}

// The candidates are the pairs of edges whose swept boxes come close, whichever end moves first.
TEST(Certified_motion, searches_all_that_an_edge_can_sweep)
{
  using namespace CGAL::Volume_filling_curves::internal;
  Random random(5);
  const auto no_filter = [](std::size_t, std::size_t) { return true; };
  for(double margin : {0., 0.125})
    for(int repeat = 0; repeat < 50; ++repeat) {
      const Network network = torus_curve(100);
      const Vector_field before = coordinates(network), after = shaken(network, 0.5, false, random);
      std::vector<Box> boxes;
      for(std::size_t e = 0; e < network.number_of_edges(); ++e) {
        Box box;
        for(std::size_t v : {network.source(e), network.target(e)})
          box.extend(row(before, v)).extend(row(after, v));
        boxes.push_back(inflated(box, margin / 2));
      }
      std::vector<Broad_phase::Edge_pair> expected;
      for(std::uint32_t e = 0; e < boxes.size(); ++e)
        for(std::uint32_t f = 0; f < e; ++f)
          if(boxes[e].intersects(boxes[f])) expected.push_back({e, f});
      auto actual = Broad_phase(Sequential_tag(), network, before, after, margin)
                        .pairs<Sequential_tag>(no_filter);
      std::sort(actual.begin(), actual.end());
      ASSERT_EQ(actual, expected);
    }
}

TEST(Certified_motion, is_the_same_for_all_pairs_and_tags)
{
  Random random(4);
  std::map<double, int> count;
  for(std::size_t n : {200u, 300u, 1500u})
    for(int repeat = 0; repeat < 12; ++repeat) {
      const Network network = torus_curve(n);
      const Targets targets = shaken(network, 0.02 * (1 << (repeat % 6)), repeat % 3 == 0, random);
      const auto expected = moved(network, targets, 1. / 32);
      ++count[expected.first];
      if(n <= 500) {
        ASSERT_EQ(fraction_by_all_pairs(network, targets, 1. / 32), expected.first);
      }
#ifdef CGAL_LINKED_WITH_TBB
      ASSERT_EQ(moved<CGAL::Parallel_tag>(network, targets, 1. / 32), expected);
#endif
    }
  EXPECT_GT(count.size(), 2u);
}

} // namespace test_certified_motion
