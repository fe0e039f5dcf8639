// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_brute_force.h"

#include <CGAL/Volume_filling_curves/internal/replay/rational_geometry.h>
#include <CGAL/Volume_filling_curves/internal/replay/separating_directions.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace test_replay_geometry {

using namespace CGAL::Volume_filling_curves::internal::replay;
using CGAL::Volume_filling_curves::internal::Position;
using Integer = std::int64_t;
using Lattice_point = brute_force::Vec<Integer>;
using Random = std::mt19937;
using brute_force::operator-;

Position random_point(Random& random, unsigned side, bool is_planar)
{
  const auto coordinate = [&] { return static_cast<double>(random() % side); };
  const double x = coordinate(), y = coordinate();
  return {x, y, is_planar ? 0 : coordinate()};
}

Lattice_point lattice_point(const Position& p)
{
  return {static_cast<Integer>(p[0]), static_cast<Integer>(p[1]), static_cast<Integer>(p[2])};
}

// Near a lattice point: such points are nearly collinear and coplanar again and again.
Position near(const Position& p, Random& random)
{
  Position q = p;
  for(double& x : q) {
    const int exponent = -static_cast<int>(random() % 60);
    if(random() % 2 == 0) x += std::ldexp(random() % 2 == 0 ? 1. : -1., exponent);
  }
  return q;
}

using Points = std::array<Position, 5>;

template <typename Test>
void for_random_points(int number, unsigned side, const Test& test)
{
  Random random(side);
  for(int k = 0; k < number; ++k) {
    Points p;
    for(Position& q : p) q = random_point(random, side, k % 2 == 0);
    test(p);
  }
}

template <typename Test>
void for_points_near_lattices(int number, const Test& test)
{
  Random random(1);
  for(int k = 0; k < number; ++k) {
    Points p;
    for(Position& q : p) q = near(random_point(random, 3, k % 4 == 0), random);
    const double size = std::ldexp(1., static_cast<int>(random() % 201) - 100);
    for(Position& q : p)
      for(double& x : q) x *= size;
    test(p);
  }
}

TEST(Rational_geometry, segments_meet_triangles_as_in_brute_force)
{
  std::array<int, 2> count{};
  for_random_points(20000, 3, [&](const Points& p) {
    const bool do_meet = brute_force::do_hulls_meet<Integer>(
        {lattice_point(p[0]), lattice_point(p[1])},
        {lattice_point(p[2]), lattice_point(p[3]), lattice_point(p[4])});
    EXPECT_EQ(do_meet_exactly(p[0], p[1], {p[2], p[3], p[4]}), do_meet);
    ++count[do_meet];
  });
  EXPECT_GT(count[0], 1000);
  EXPECT_GT(count[1], 1000);
}

bool lies_between(const Position& a, const Position& q, const Position& r)
{
  return brute_force::do_hulls_meet<Integer>({lattice_point(a)},
                                             {lattice_point(q), lattice_point(r)});
}

TEST(Rational_geometry, cones_are_as_in_brute_force)
{
  std::array<int, 2> count{};
  for_random_points(20000, 3, [&](const Points& p) {
    if(lies_between(p[0], p[2], p[3]) || p[1] == p[0]) return;
    const Lattice_point apex = lattice_point(p[0]);
    const bool is_inside = brute_force::is_in_cone<Integer>(
        lattice_point(p[1]) - apex, lattice_point(p[2]) - apex, lattice_point(p[3]) - apex);
    EXPECT_EQ(is_in_cone_exactly(p[0], p[1], p[2], p[3]), is_inside);
    ++count[is_inside];
  });
  EXPECT_GT(count[0], 1000);
  EXPECT_GT(count[1], 1000);
}

TEST(Rational_geometry, points_are_on_segments_as_in_brute_force)
{
  for_random_points(20000, 4, [&](const Points& p) {
    EXPECT_EQ(is_on_segment_exactly(p[0], p[1], p[2]), lies_between(p[0], p[1], p[2]));
  });
}

TEST(Rational_geometry, segments_pass_between_points_as_in_brute_force)
{
  std::array<int, 2> count{};
  for_random_points(20000, 4, [&](const Points& p) {
    if(p[2] == p[3]) return;
    const bool is_outside = brute_force::does_meet_line_outside<Integer>(
        lattice_point(p[0]), lattice_point(p[1]), lattice_point(p[2]), lattice_point(p[3]), 1000);
    EXPECT_EQ(passes_between_exactly(p[0], p[1], p[2], p[3]), !is_outside);
    ++count[is_outside];
  });
  EXPECT_GT(count[0], 1000);
  EXPECT_GT(count[1], 1000);
}

TEST(Separating_directions, are_never_wrong)
{
  std::array<int, 4> sure{};
  const auto test = [&](const Points& p) {
    const std::array<Position, 3> triangle = {p[2], p[3], p[4]};
    if(are_surely_apart({p[0], p[1]}, triangle)) {
      EXPECT_FALSE(do_meet_exactly(p[0], p[1], triangle));
      ++sure[0];
    }
    if(is_surely_outside_cone(p[0], p[1], p[2], p[3])) {
      EXPECT_FALSE(is_in_cone_exactly(p[0], p[1], p[2], p[3]));
      ++sure[1];
    }
    if(surely_projects_between(p[0], p[1], p[2], p[3])) {
      EXPECT_TRUE(passes_between_exactly(p[0], p[1], p[2], p[3]));
      ++sure[2];
    }
    if(are_surely_not_collinear(p[0], p[1], p[2])) {
      EXPECT_FALSE(are_collinear_exactly(p[0], p[1], p[2]));
      ++sure[3];
    }
  };
  for_random_points(10000, 3, test);
  for_points_near_lattices(20000, test);
  for(const int number : sure) EXPECT_GT(number, 1000);
}

// Otherwise a replay would be slow.
TEST(Separating_directions, are_mostly_found)
{
  Random random(2);
  std::uniform_real_distribution<double> real(-1, 1);
  std::array<int, 2> apart{}, outside{};
  for(int k = 0; k < 5000; ++k) {
    Points p;
    for(Position& q : p) q = {real(random), real(random), k % 2 == 0 ? 0 : real(random)};
    if(!do_meet_exactly(p[0], p[1], {p[2], p[3], p[4]}))
      ++apart[are_surely_apart({p[0], p[1]}, {p[2], p[3], p[4]})];
    if(!is_in_cone_exactly(p[0], p[1], p[2], p[3]))
      ++outside[is_surely_outside_cone(p[0], p[1], p[2], p[3])];
  }
  EXPECT_LT(apart[0], apart[1] / 100);
  EXPECT_LT(outside[0], outside[1] / 100);
}

TEST(Separating_directions, prove_nothing_where_numbers_overflow_or_underflow)
{
  const auto scaled_test = [](double size) {
    const std::array<Position, 3> triangle = {
        {{size, -size, -size}, {size, size, 0}, {size, 0, size}}};
    const std::array<Position, 2> through = {{{0, 0, 0}, {3 * size, 0, 0}}};
    EXPECT_FALSE(are_surely_apart(through, triangle));
    EXPECT_TRUE(do_meet_exactly(through[0], through[1], triangle));
    EXPECT_FALSE(do_meet_exactly({0, 0, 0}, {size / 2, 0, 0}, triangle));
  };
  for(const double size : {5e-324, 1e-320, 1e-200, 1e-150, 1e150, 1e200, 1e307}) scaled_test(size);
}

TEST(Extent, meets_what_it_touches)
{
  Extent a, b, c;
  a.add({0, 0, 0});
  a.add({1, 1, 1});
  b.add({1, 1, 1});
  c.add({1.5, 0, 0});
  EXPECT_TRUE(a.meets(b));
  EXPECT_TRUE(b.meets(a));
  EXPECT_FALSE(a.meets(c));
  EXPECT_FALSE(c.meets(a));
}

} // namespace test_replay_geometry
