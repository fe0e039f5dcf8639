// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Distances of segments against exact arithmetic, and what the guard keeps against a recount of all
// pairs of edges: with a clearance it accepts exactly what it certifies and what the rule allows.
namespace test_clearance_rule {

using namespace guard_test;
using namespace CGAL::Volume_filling_curves::internal;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Point = Network::Point_3;
using Rational = CGAL::Exact_rational;
using brute_force::cross;
using brute_force::dot;
using Exact_vector = brute_force::Vec<Rational>;

Rational exact_squared_distance(const Exact_vector& p, const Exact_vector& a, const Exact_vector& b)
{
  const Exact_vector u = b - a, w = p - a;
  const Rational uu = dot(u, u), uw = dot(u, w);
  if(uw <= 0) return dot(w, w);
  if(uw >= uu) return dot(p - b, p - b);
  return dot(w, w) - uw * uw / uu;
}

Rational exact_squared_distance(const Exact_vector& a,
                                const Exact_vector& b,
                                const Exact_vector& c,
                                const Exact_vector& d)
{
  Rational least = (std::min)({exact_squared_distance(a, c, d), exact_squared_distance(b, c, d),
                               exact_squared_distance(c, a, b), exact_squared_distance(d, a, b)});
  const Exact_vector u = b - a, v = d - c, w = c - a, n = cross(u, v);
  const Rational nn = dot(n, n);
  if(nn == 0) return least;
  const Rational s = dot(cross(w, v), n), t = dot(cross(w, u), n);
  if(s < 0 || s > nn || t < 0 || t > nn) return least;
  return (std::min)(least, Rational(dot(w, n) * dot(w, n) / nn));
}

TEST(Segment_distance, agrees_with_exact_arithmetic)
{
  Random random(1);
  std::uniform_real_distribution<double> offset(-1, 1);
  for(double noise : {0., 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.})
    for(int repeat = 0; repeat < 2000; ++repeat) {
      std::array<Vector, 4> x;
      std::array<Exact_vector, 4> y;
      for(std::size_t k = 0; k < 4; ++k) {
        const Lattice_point p = random_point(4, repeat % 2 == 0, random);
        for(std::size_t i = 0; i < 3; ++i)
          y[k][i] = x[k][static_cast<int>(i)] =
              static_cast<double>(p[i]) / 3 + noise * offset(random);
      }
      const double exact =
          std::sqrt(CGAL::to_double(exact_squared_distance(y[0], y[1], y[2], y[3])));
      const double actual = std::sqrt(squared_segment_distance(x[0], x[1], x[2], x[3]));
      ASSERT_NEAR(actual, exact, 1e-7) << "noise " << noise << ", number " << repeat;
    }
}

using Edge_list = std::vector<std::size_t>;

bool has_node(const Network& network, std::size_t e, std::size_t v)
{
  return network.source(e) == v || network.target(e) == v;
}

double squared_distance(const Network& network, std::size_t e, std::size_t f)
{
  return squared_segment_distance(
      to_vector(network.point(network.source(e))), to_vector(network.point(network.target(e))),
      to_vector(network.point(network.source(f))), to_vector(network.point(network.target(f))));
}

// the distance of the points at distance 1 from v on two of its edges
double opening(const Network& network, std::size_t v, std::size_t e, std::size_t f)
{
  const auto direction = [&](std::size_t edge) {
    const std::size_t w = network.source(edge) == v ? network.target(edge) : network.source(edge);
    return Vector((to_vector(network.point(w)) - to_vector(network.point(v))).normalized());
  };
  return (direction(e) - direction(f)).norm();
}

// returns whether each two edges after a change are as far apart as the rule requires, where
// former[e] are the edges that edge e was before
bool is_clear(const Network& before,
              const Network& after,
              const std::vector<Edge_list>& former,
              double clearance)
{
  for(const std::size_t e : after.edges())
    for(const std::size_t f : after.edges()) {
      if(f >= e) break;
      std::size_t v = Network::null_node();
      for(std::size_t w : {after.source(e), after.target(e)})
        if(has_node(after, f, w)) v = w;
      const bool is_corner = v != Network::null_node();
      double least = is_corner ? 2 : std::numeric_limits<double>::infinity();
      for(std::size_t i : former[e])
        for(std::size_t j : former[f]) {
          if(!is_corner)
            least = (std::min)(least, squared_distance(before, i, j));
          else if(i != j && has_node(before, i, v) && has_node(before, j, v))
            least = (std::min)(least, opening(before, v, i, j));
        }
      if(is_corner) {
        const double now = opening(after, v, e, f);
        if(now < 0.35 && now < least / 2) return false;
      } else {
        const double now = squared_distance(after, e, f);
        if(now < clearance * clearance && now < least / 4) return false;
      }
    }
  return true;
}

Network random_network(Random& random)
{
  const Curve graph = random_graph(random);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> points;
  for(std::size_t v = 0; v < graph.points.size(); ++v) {
    const double x = coordinate(random), y = coordinate(random);
    points.emplace_back(x, y, coordinate(random));
  }
  return {points, graph.edges};
}

Point near(const Point& p, double size, Random& random)
{
  std::uniform_real_distribution<double> offset(-size, size);
  const double x = p.x() + offset(random), y = p.y() + offset(random);
  return {x, y, p.z() + offset(random)};
}

// A random change; `former` has the former indices of the edges.
bool change(Guard& guard, unsigned seed, std::vector<Edge_list>& former)
{
  const Network& network = guard.curve();
  Random random(seed);
  former.clear();
  for(std::size_t e = 0; e < network.number_of_edges(); ++e) former.push_back({e});
  const std::size_t v = below(network.number_of_nodes(), random);
  const std::size_t e = below(network.number_of_edges(), random);
  const double size = std::ldexp(1, -static_cast<int>(below(6, random)));
  switch(below(4, random)) {
  case 0:
    former.push_back({e});
    return guard.insert_node(e, near(network.point(network.source(e)), size, random));
  case 1:
    if(network.degree(v) == 2)
      for(std::size_t k : {0u, 1u})
        former[network.incident_edge(v, k)] = {network.incident_edge(v, 0),
                                               network.incident_edge(v, 1)};
    return guard.remove_node(v);
  case 2:
    return guard.move_node(v, near(network.point(v), size, random));
  default:
    Targets targets = coordinates(network);
    for(Eigen::Index w = 0; w < targets.rows(); ++w)
      set_row(targets, w,
              to_vector(near(network.point(static_cast<std::size_t>(w)), size / 4, random)));
    return guard.move_nodes(targets) == 1;
  }
}

TEST(Clearance_rule, is_kept_and_refuses_nothing_else)
{
  Random random(2);
  int number_of_unclear = 0, number_of_clear = 0;
  for(unsigned repeat = 0; repeat < 20000; ++repeat) {
    const Network before = random_network(random);
    Network free = before, guarded = before;
    Guard free_guard(free), clear_guard(guarded);
    const double clearance = 0.2 * static_cast<double>(1 + repeat % 3);
    clear_guard.set_clearance(clearance);
    std::vector<Edge_list> former;
    if(!change(free_guard, repeat, former)) continue;
    const bool is_expected = is_clear(before, free, former, clearance);
    ++(is_expected ? number_of_clear : number_of_unclear);
    ASSERT_EQ(change(clear_guard, repeat, former), is_expected) << repeat;
    ASSERT_EQ(contents(guarded), contents(is_expected ? free : before)) << repeat;
  }
  EXPECT_GT(number_of_clear, 2000);
  EXPECT_GT(number_of_unclear, 2000);
}

TEST(Clearance_rule, takes_a_fraction_that_keeps_it)
{
  Network network({{0, 0, 0}, {10, 0, 0}, {0, 5, 8}, {10, 5, 8}}, {{0, 1}, {2, 3}});
  Guard guard(network);
  guard.set_clearance(2);
  Targets targets = coordinates(network);
  targets.row(0) << 0, 5, 7;
  targets.row(1) << 10, 5, 7;
  EXPECT_EQ(guard.move_nodes(targets, 0.5), 0.5);
  EXPECT_EQ(guard.number_of_refused_changes(), 4u);
  EXPECT_EQ(guard.number_of_certified_changes(), 4u);
}

} // namespace test_clearance_rule
