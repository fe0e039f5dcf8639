// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rollback.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rope.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Rope_contacts.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Ropelength_descent.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The pieces of the descent: how a rope moves, where it touches itself, and how it goes back.
namespace test_rope {

using namespace untangle_test;
using CGAL::Volume_filling_curves::ropelength;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using internal::Rope;
using internal::Rope_contacts;

Rope rope_of(const std::vector<Polygon>& polygons, double radius = 1)
{
  return Rope(internal::closed_network(polygons), radius);
}

double min_bend_radius(const Rope& rope)
{
  double least = 1e300;
  for(std::size_t v = 0; v < rope.size(); ++v)
    least = (std::min)(least, internal::bend_radius(rope.edge(rope.previous[v]), rope.edge(v)));
  return least;
}

TEST(Nearest_points, are_as_near_as_the_segments)
{
  Random random(1);
  for(int k = 0; k < 10000; ++k) {
    const Vector a = random_point(random), c = random_point(random), d = random_point(random);
    Vector b = random_point(random);
    if(k % 2 == 1) b = a + 1e-3 * (b - a);
    const auto [s, t] = internal::nearest_points(a, b, c, d);
    ASSERT_TRUE(s >= 0 && s <= 1 && t >= 0 && t <= 1);
    const double distance = ((a + s * (b - a)) - (c + t * (d - c))).norm();
    EXPECT_NEAR(distance, std::sqrt(internal::squared_segment_distance(a, b, c, d)), 1e-9);
  }
}

// Of those, an end of one is as near to the other as anything.
TEST(Nearest_points, are_as_near_as_parallel_segments)
{
  using internal::squared_distance_to_segment;
  Random random(1);
  for(int k = 0; k < 10000; ++k) {
    const Vector a = random_point(random), b = random_point(random), c = random_point(random);
    const Vector d = c + between(-2, 2, random) * (b - a);
    const auto [s, t] = internal::nearest_points(a, b, c, d);
    ASSERT_TRUE(s >= 0 && s <= 1 && t >= 0 && t <= 1);
    const double distance = ((a + s * (b - a)) - (c + t * (d - c))).norm();
    const double nearest =
        (std::min)({squared_distance_to_segment(a, c, d), squared_distance_to_segment(b, c, d),
                    squared_distance_to_segment(c, a, b), squared_distance_to_segment(d, a, b)});
    EXPECT_NEAR(distance, std::sqrt(nearest), 1e-9);
  }
}

TEST(Rope, is_in_units_of_its_radius)
{
  const Rope rope = rope_of({circle(10, 3), circle(7, 2, Vector(9, 0, 0))}, 2);
  EXPECT_EQ(rope.size(), 17u);
  EXPECT_NEAR(rope.length(), 10 * 3 * std::sin(CGAL_PI / 10) + 7 * 2 * std::sin(CGAL_PI / 7), 1e-9);
  EXPECT_EQ(rope.component.back(), 1u);
  EXPECT_NEAR(rope.coordinates(2)(0, 0), 3, 1e-12);
}

TEST(Rope, shortens_when_it_is_pulled)
{
  Random random(2);
  Rope rope(internal::closed_network({random_polygon(50, random)}), 0.01);
  std::vector<Vector> workspace;
  for(int k = 0; k < 100; ++k) {
    const double before = rope.length();
    internal::pull(rope, 0.25, workspace);
    EXPECT_LT(rope.length(), before);
  }
}

// Where nothing holds it a rope shrinks to the tightest ring that it can be, from either side.
TEST(Rope, becomes_a_ring_if_it_is_free)
{
  for(const double radius : {0.7, 3.}) {
    Rope rope(internal::closed_network({circle(20, radius)}), 1);
    std::vector<Vector> workspace;
    for(int k = 0; k < 2000; ++k) {
      internal::pull(rope, 0.25, workspace);
      internal::straighten(rope);
    }
    EXPECT_NEAR(rope.length(), internal::min_length_of_ring, 0.1) << radius;
  }
}

TEST(Rope, evens_its_edges_out)
{
  Polygon uneven;
  for(int k = 0; k < 40; ++k) {
    const double angle = 2 * CGAL_PI * (k + (k % 2 == 0 ? 0 : 0.5)) / 40;
    uneven.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  Rope rope = rope_of({uneven});
  std::vector<Vector> workspace;
  for(int k = 0; k < 50; ++k) internal::pull(rope, 0, workspace);
  for(std::size_t v = 0; v < rope.size(); ++v)
    EXPECT_NEAR(rope.edge(v).norm(), rope.mean_edge(), 1e-3 * rope.mean_edge());
}

// A square, and a circle that is wide enough.
TEST(Rope, unbends_where_it_kinks)
{
  Polygon square;
  for(const double angle : {0., 0.5, 1., 1.5})
    for(int k = 0; k < 40; ++k) {
      const double c = std::cos(angle * CGAL_PI), s = std::sin(angle * CGAL_PI), y = 0.25 * k - 5;
      square.emplace_back(5 * c - s * y, 5 * s + c * y, 0);
    }
  Rope kinked = rope_of({square}), loose = rope_of({circle(20, 1.1)});
  const std::vector<Vector> before = loose.x;
  ASSERT_LT(min_bend_radius(kinked), 0.2);
  std::vector<Vector> workspace;
  for(int k = 0; k < 1000; ++k) {
    internal::pull(kinked, 0, workspace);
    internal::straighten(kinked);
  }
  internal::straighten(loose);
  EXPECT_NEAR(min_bend_radius(kinked), 1, 1e-3);
  EXPECT_EQ(loose.x, before);
}

// Two linked rings that are too close; and a single one, of which no point is pushed.
TEST(Rope_contacts, push_strands_a_diameter_apart)
{
  Polygon first = circle(60, 2), second;
  for(const Vector& p : first) second.emplace_back(p.x() + 1, 0, p.y());
  Rope rope = rope_of({first, second});
  Rope_contacts contacts;
  const auto distance = [&] {
    double least = 1e300;
    for(std::size_t v = 0; v < 60; ++v)
      for(std::size_t w = 60; w < 120; ++w)
        least =
            (std::min)(least, internal::squared_segment_distance(rope.x[v], rope.x[rope.next[v]],
                                                                 rope.x[w], rope.x[rope.next[w]]));
    return std::sqrt(least);
  };
  ASSERT_NEAR(distance(), 1, 1e-2);
  for(int k = 0; k < 100; ++k) {
    contacts.find(rope);
    contacts.push_apart(rope);
  }
  EXPECT_GT(distance(), 2 - 1e-3);
  EXPECT_LT(distance(), 2 + 0.1);
}

TEST(Rope_contacts, leave_bends_to_the_curvature)
{
  Rope rope = rope_of({circle(100, 1.001)});
  const std::vector<Vector> before = rope.x;
  Rope_contacts contacts;
  contacts.find(rope);
  contacts.push_apart(rope);
  for(std::size_t v = 0; v < rope.size(); ++v) EXPECT_LT((rope.x[v] - before[v]).norm(), 1e-2);
}

// Motions that make it worse, between halvings, are all taken back.
TEST(Rollback, leads_to_the_start_if_nothing_was_better)
{
  Network curve = braid("1 1 1", 60);
  const auto start = contents(curve);
  const Vector_field before = internal::coordinates(curve);
  Guard guard(curve);
  Random random(4);
  internal::Rollback<Guard, CGAL::Sequential_tag> rollback(guard);
  for(int k = 0; k < 3; ++k) {
    for(int i = 0; i < 3; ++i)
      EXPECT_GT(rollback.move(internal::coordinates(curve) +
                              0.003 * random_field(curve.number_of_nodes(), random)),
                0);
    rollback.note();
    EXPECT_TRUE(rollback.halve_edges());
  }
  EXPECT_EQ(curve.number_of_nodes(), 8 * 60u);
  EXPECT_TRUE(rollback.return_to_min_ropelength());
  EXPECT_EQ(internal::coordinates(curve), before);
  EXPECT_EQ(contents(curve), start);
}

TEST(Rollback, leads_to_the_least_ropelength)
{
  Network curve = internal::closed_network({circle(20)});
  Guard guard(curve);
  Vector_field flat = internal::coordinates(curve);
  flat.col(0) *= 0.8;
  ASSERT_EQ(guard.move_nodes(flat), 1);
  internal::Rollback<Guard, CGAL::Sequential_tag> rollback(guard);
  Vector_field rounder = flat, flatter = flat;
  rounder.col(0) *= 1.1;
  flatter.col(0) *= 0.9;
  for(const Vector_field& next : {rounder, flatter}) {
    EXPECT_EQ(rollback.move(next), 1);
    rollback.note();
  }
  EXPECT_TRUE(rollback.return_to_min_ropelength());
  EXPECT_EQ(internal::coordinates(curve), rounder);
}

// A side of this triangle has no double between its ends.
TEST(Rollback, does_not_mistake_a_refused_halving_for_a_motion)
{
  const double next = std::nextafter(1., 2.);
  Network curve = internal::closed_network({{{1, 1, 1}, {next, 1, 1}, {1, next, 1}}});
  const auto start = contents(curve);
  Guard guard(curve);
  internal::Rollback<Guard, CGAL::Sequential_tag> rollback(guard);
  EXPECT_FALSE(rollback.halve_edges());
  EXPECT_TRUE(rollback.return_to_min_ropelength());
  EXPECT_EQ(contents(curve), start);
}

// A radius far from the curve's: there is nothing to be won, and nothing is lost.
TEST(Ropelength_descent, keeps_a_curve_that_does_not_fit)
{
  Network circle_of_three = internal::closed_network({circle(3)});
  for(const double radius : {1e-3, 1., 1e3}) {
    Network curve = circle_of_three;
    const double before = ropelength(curve);
    Guard guard(curve);
    std::size_t motions = 0;
    internal::Ropelength_descent<Guard, CGAL::Sequential_tag> descend(guard, radius);
    descend([&] { return ++motions < 20; });
    EXPECT_LE(ropelength(curve), before) << radius;
  }
}

} // namespace test_rope
