// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_traits.h"
#include "support/guard_test_support.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Kernels of all sorts, and a traits class that offers nothing but what the concept asks for, must
// decide alike.
namespace test_traits {

using namespace guard_test;
using archetypes::Archetype;
using CGAL::Volume_filling_curves::Curve_flow_traits_3;
using CGAL::Volume_filling_curves::Curve_network_3;
using CGAL::Volume_filling_curves::Isotopy_guard_3;
using Rational = CGAL::Exact_rational;

// A log: the answers of all operations, and the resulting curve.
struct Record
{
  std::vector<double> answers, contents;

  bool operator==(const Record& other) const
  {
    return answers == other.answers && contents == other.contents;
  }
};

template <typename Network>
Targets random_targets(const Network& network, double unit, Random& random)
{
  Targets targets = CGAL::Volume_filling_curves::internal::coordinates(network);
  for(Eigen::Index k = 0; k < targets.size(); ++k)
    if(below(4, random) == 0) targets(k) += unit * (static_cast<double>(below(3, random)) - 1);
  return targets;
}

// Certified operations at random on a random curve, with coordinates that are multiples of `unit`.
template <typename Traits>
Record scenario(unsigned seed, double unit, const Traits& traits)
{
  Random random(seed);
  const Curve curve = random_curve(4, seed % 3 == 0, random);
  const auto place = [&](const Lattice_point& p) {
    return traits.construct_point_3_object()(unit * static_cast<double>(p[0]),
                                             unit * static_cast<double>(p[1]),
                                             unit * static_cast<double>(p[2]));
  };
  std::vector<typename Traits::Point_3> points;
  for(const Lattice_point& p : curve.points) points.push_back(place(p));
  Curve_network_3<Traits> network(points, curve.edges, traits);
  network.pin_ends();
  Isotopy_guard_3<Traits> guard(network);
  if(seed % 5 == 0) guard.set_clearance(0.3 * unit);
  Record record;
  for(int k = 0; k < 20; ++k) {
    const auto target = place(random_point(4, seed % 3 == 0, random));
    switch(below(4, random)) {
    case 0:
      record.answers.push_back(guard.move_node(below(network.number_of_nodes(), random), target));
      break;
    case 1:
      record.answers.push_back(guard.insert_node(below(network.number_of_edges(), random), target));
      break;
    case 2:
      record.answers.push_back(guard.remove_node(below(network.number_of_nodes(), random)));
      break;
    default:
      record.answers.push_back(guard.move_nodes(random_targets(network, unit, random), 0.25));
    }
    guard.collect_garbage();
  }
  record.contents = contents(network);
  return record;
}

TEST(Traits, decide_alike)
{
  int number_of_accepted = 0, number_of_refused = 0;
  for(double unit : {1., 0.1, 1e-9 / 3}) // but for 1 the multiples of the unit are not exact
    for(unsigned seed = 0; seed < 25; ++seed) {
      const Record record = scenario(seed, unit, Curve_flow_traits_3<>());
      for(double answer : record.answers) ++(answer > 0 ? number_of_accepted : number_of_refused);
      using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
      using Rational_kernel = CGAL::Simple_cartesian<Rational>;
      ASSERT_TRUE(scenario(seed, unit, Curve_flow_traits_3<Exact_kernel>()) == record) << seed;
      ASSERT_TRUE(scenario(seed, unit, Curve_flow_traits_3<Rational_kernel>()) == record) << seed;
      ASSERT_TRUE(scenario(seed, unit, Archetype(0)) == record) << seed;
    }
  EXPECT_GT((std::min)(number_of_accepted, number_of_refused), 300);
}

// Positions that no double holds are rounded before they are certified, not after.
TEST(Traits, round_positions_to_double)
{
  using Traits = Curve_flow_traits_3<CGAL::Simple_cartesian<Rational>>;
  using Point = Traits::Point_3;
  const Rational third = Rational(1) / 3;
  Curve_network_3<Traits> network(
      {{0, 0, 0}, {1, 0, 0}, {third, third, 0}, {third, -third, -1}, {third, -third, 1}},
      {{0, 1}, {1, 2}, {3, 4}});
  EXPECT_EQ(network.point(2), Point(1. / 3, 1. / 3, 0.));
  Isotopy_guard_3<Traits> guard(network);
  // the strand 3, 4 stands at 1 / 3 rounded, and so would the node
  EXPECT_FALSE(guard.move_node(2, Point(third, -third, 0)));
  EXPECT_FALSE(guard.insert_node(0, Point(third, -third, 0)));
  EXPECT_TRUE(guard.insert_node(0, Point(third / 2, -third / 2, 0)));
  EXPECT_EQ(network.point(5), Point(1. / 6, -1. / 6, 0.));
  EXPECT_TRUE(guard.move_node(2, Point(2 * third, 2 * third, third)));
  EXPECT_EQ(network.point(2), Point(2. / 3, 2. / 3, 1. / 3));
}

} // namespace test_traits
