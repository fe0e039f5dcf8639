// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_brute_force.h"

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace test_exact_predicates {

using Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>;
using Predicates = CGAL::Volume_filling_curves::internal::Exact_predicates<Traits>;
using Point = Traits::Point_3;
using Integer = std::int64_t;
using Rational = CGAL::Exact_rational;
template <typename NT>
using Vec = brute_force::Vec<NT>;

const Predicates predicates{Traits()};

Point to_point(const Vec<Integer>& v)
{
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Vec<Rational> to_rational(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

// Counts the positive and negative answers of each predicate.
struct Tally
{
  std::array<int, 2> meets{}, corner{}, line{}, segments{}, on{}, between{};
};

// compares all predicates on five points, given as CGAL points and as exact vectors
template <typename NT>
void compare(const std::array<Point, 5>& x,
             const std::array<Vec<NT>, 5>& y,
             const NT& far,
             Tally& tally)
{
  using namespace brute_force;
  const auto check = [&](bool actual, bool expected, std::array<int, 2>& count, const char* what) {
    ++count[expected];
    ASSERT_EQ(actual, expected) << what << ": " << x[0] << ", " << x[1] << ", " << x[2] << ", "
                                << x[3] << ", " << x[4];
  };
  check(predicates.does_segment_meet_triangle(x[0], x[1], x[2], x[3], x[4]),
        do_hulls_meet<NT>({y[0], y[1]}, {y[2], y[3], y[4]}), tally.meets, "triangle");
  check(predicates.do_segments_intersect(x[0], x[1], x[2], x[3]),
        do_hulls_meet<NT>({y[0], y[1]}, {y[2], y[3]}), tally.segments, "segments");
  check(predicates.is_on_segment(x[0], x[1], x[2]), do_hulls_meet<NT>({y[0]}, {y[1], y[2]}),
        tally.on, "on segment");
  if(y[0] != y[1])
    check(predicates.does_segment_meet_triangle_beyond_corner(x[0], x[1], x[2], x[3]),
          do_meet_beyond_corner(y[0], y[1], y[2], y[3]), tally.corner, "beyond corner");
  if(y[2] != y[3])
    check(predicates.does_segment_meet_line_outside(x[0], x[1], x[2], x[3]),
          does_meet_line_outside(y[0], y[1], y[2], y[3], far), tally.line, "line outside");
  const bool is_collinear = is_zero(cross(y[1] - y[0], y[2] - y[0]));
  ASSERT_EQ(predicates.are_collinear(x[0], x[1], x[2]), is_collinear);
  ASSERT_EQ(predicates.are_coplanar(x[0], x[1], x[2], x[3]),
            det(y[1] - y[0], y[2] - y[0], y[3] - y[0]) == 0);
  ASSERT_EQ(predicates.are_equal(x[0], x[1]), y[0] == y[1]);
  if(is_collinear)
    check(predicates.is_strictly_between(x[0], x[1], x[2]), dot(y[0] - y[1], y[2] - y[1]) < 0,
          tally.between, "between");
}

Vec<Integer> lattice_point(int index, int side)
{
  return {index / side / side, index / side % side, index % side};
}

TEST(Exact_predicates, agree_on_all_corners_of_a_cube)
{
  Tally tally;
  for(int code = 0; code < 8 * 8 * 8 * 8 * 8; ++code) {
    std::array<Vec<Integer>, 5> y;
    std::array<Point, 5> x;
    for(std::size_t k = 0, rest = static_cast<std::size_t>(code); k < 5; ++k, rest /= 8) {
      y[k] = lattice_point(static_cast<int>(rest % 8), 2);
      x[k] = to_point(y[k]);
    }
    compare<Integer>(x, y, 1000, tally);
    if(HasFatalFailure()) return;
  }
}

// In the plane every answer is a degenerate one. All five-tuples of a 3 x 3 grid.
TEST(Exact_predicates, agree_on_all_points_of_planar_grids)
{
  Tally tally;
  for(int plane = 0; plane < 4; ++plane)
    for(int code = 0; code < 9 * 9 * 9 * 9 * 9; ++code) {
      std::array<Vec<Integer>, 5> y;
      std::array<Point, 5> x;
      for(std::size_t k = 0, rest = static_cast<std::size_t>(code); k < 5; ++k, rest /= 9) {
        const Integer u = static_cast<Integer>(rest % 3), v = static_cast<Integer>(rest / 3 % 3);
        const Vec<Integer> planes[] = {{u, v, 1}, {u, 1, v}, {1, u, v}, {u, v, 3 - u - 2 * v}};
        y[k] = planes[plane];
        x[k] = to_point(y[k]);
      }
      compare<Integer>(x, y, 1000, tally);
      if(HasFatalFailure()) return;
    }
  EXPECT_GT(tally.corner[0], 10000);
  EXPECT_GT(tally.corner[1], 10000);
}

TEST(Exact_predicates, agree_on_random_lattice_points)
{
  Tally tally;
  std::mt19937 random(1);
  for(int side : {3, 4, 6})
    for(int repeat = 0; repeat < 50000; ++repeat) {
      std::array<Vec<Integer>, 5> y;
      std::array<Point, 5> x;
      for(std::size_t k = 0; k < 5; ++k) {
        y[k] = lattice_point(static_cast<int>(random() % static_cast<unsigned>(side * side * side)),
                             side);
        x[k] = to_point(y[k]);
      }
      compare<Integer>(x, y, 100000, tally);
      if(HasFatalFailure()) return;
    }
  for(const auto& count :
      {tally.meets, tally.corner, tally.line, tally.segments, tally.on, tally.between})
    EXPECT_GT((std::min)(count[0], count[1]), 300);
}

double nudged(double x, int ulps)
{
  for(; ulps > 0; --ulps) x = std::nextafter(x, std::numeric_limits<double>::infinity());
  for(; ulps < 0; ++ulps) x = std::nextafter(x, -std::numeric_limits<double>::infinity());
  return x;
}

// Lattice points scaled and turned by doubles, then moved by at most one unit in the last place.
TEST(Exact_predicates, agree_on_nearly_degenerate_points)
{
  Tally tally;
  std::mt19937 random(2);
  const Rational far = Rational(std::ldexp(1, 500));
  for(double scale : {1., 0.1, 1e-160, 1e140})
    for(int repeat = 0; repeat < 600; ++repeat) {
      std::array<Point, 5> x;
      std::array<Vec<Rational>, 5> y;
      const auto ulps = [&] { return static_cast<int>(random() % 3) - 1; };
      for(std::size_t k = 0; k < 5; ++k) {
        const Vec<Integer> v = lattice_point(static_cast<int>(random() % 27), 3);
        const double a = scale * static_cast<double>(1 + v[0]),
                     b = scale * static_cast<double>(1 + v[1]);
        x[k] = {nudged(a + b / 3, ulps()), nudged(a - b / 3, ulps()),
                nudged(a * 0.7 + b * 0.3, ulps())};
        y[k] = to_rational(x[k]);
      }
      compare<Rational>(x, y, far, tally);
      if(HasFatalFailure()) return;
    }
  EXPECT_GT(tally.meets[0], 200);
  EXPECT_GT(tally.meets[1], 40);
}

// A point in the open segment, nudged: on the line only if that is exact.
TEST(Exact_predicates, decide_collinearity_exactly)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int number_of_collinear = 0;
  for(int repeat = 0; repeat < 20000; ++repeat) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    const Point a(x, y, z), c(3 * x, 3 * y, 3 * z), b(2 * x, 2 * y, 2 * z);
    const auto ra = to_rational(a), rb = to_rational(b), rc = to_rational(c);
    using namespace brute_force;
    const bool expected = is_zero(cross(rb - ra, rc - ra));
    number_of_collinear += expected;
    ASSERT_EQ(predicates.are_collinear(a, b, c), expected);
    ASSERT_EQ(predicates.is_on_segment(b, a, c), expected);
    ASSERT_TRUE(predicates.is_on_segment(a, a, c));
    ASSERT_TRUE(predicates.is_on_segment(c, a, c));
  }
  EXPECT_GT(number_of_collinear, 100);
  EXPECT_LT(number_of_collinear, 19000);
}

} // namespace test_exact_predicates
