// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_brute_force.h"

#include <CGAL/Volume_filling_curves/internal/domain/Vertical_ray.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Filtered_triangle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// Everything that decides a sign, at coordinates whose products over- or underflow, against
// integers: scaling the axes by powers of two changes no answer. A million cases per scale.
namespace test_long_border_of_double {

namespace internal = CGAL::Volume_filling_curves::internal;
using internal::Vector;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<Kernel>;
using Triangle = internal::Filtered_triangle<Traits>;
using Point = Kernel::Point_3;
using Integer = std::int64_t;
using Lattice_point = brute_force::Vec<Integer>;
using Exponents = std::array<int, 3>; // of the axes
using Random = std::mt19937;
using brute_force::operator-;

const Traits traits;
constexpr int cases_per_scale = 1000000;

// The limits of the filters (1e-97 and 1e102), of accepted coordinates (1e-150 and 1e150), and
// beyond, where differences overflow and coordinates are denormal.
const std::vector<Exponents> scales = {
    {0, 0, 0},          {-324, -324, -324},    {-340, -340, -340},
    {-498, -498, -498}, {-1060, -1060, -1060}, {324, 324, 324},
    {339, 339, 339},    {341, 341, 341},       {498, 498, 498},
    {1019, 1019, 1019}, {345, 345, 330},       {300, 498, -498},
    {-498, 0, 498},     {-400, -400, 1000}};

// A small lattice, where degenerate positions are frequent, or a larger one, where they are near.
Lattice_point random_point(Random& random)
{
  const Integer reach = random() % 2 == 0 ? 2 : 15;
  Lattice_point p;
  for(Integer& x : p)
    x = static_cast<Integer>(random() % static_cast<unsigned>(2 * reach + 1)) - reach;
  return p;
}

Vector scaled(const Lattice_point& p, const Exponents& exponents)
{
  const auto coordinate = [&](std::size_t i) {
    return std::ldexp(static_cast<double>(p[i]), exponents[i]);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

Point to_point(const Vector& p)
{
  return {p.x(), p.y(), p.z()};
}

template <typename Test>
void test_at_all_scales(int cases, const Test& test)
{
  Random random(1);
  for(const Exponents& exponents : scales) {
    SCOPED_TRACE("scales 2^" + std::to_string(exponents[0]) + ", 2^" +
                 std::to_string(exponents[1]) + ", 2^" + std::to_string(exponents[2]));
    for(int k = 0; k < cases; ++k) {
      std::array<Lattice_point, 6> p;
      for(Lattice_point& x : p) x = random_point(random);
      std::array<Vector, 6> x;
      for(std::size_t i = 0; i < 6; ++i) x[i] = scaled(p[i], exponents);
      test(p, x);
      if(::testing::Test::HasFailure()) return;
    }
  }
}

TEST(Long_border_of_double, segments_meet_triangles_as_on_the_lattice)
{
  test_at_all_scales(cases_per_scale, [](const auto& p, const auto& x) {
    const Triangle triangle(x[0], x[1], x[2], traits);
    const bool meets = brute_force::do_hulls_meet<Integer>({p[3], p[4]}, {p[0], p[1], p[2]});
    ASSERT_EQ(triangle.meets(x[3], x[4]), meets);
    ASSERT_FALSE(meets && triangle.is_far_from_plane(x[3], x[4], 0));
    const int side = triangle.side(x[3]);
    if(side != 0) {
      ASSERT_EQ(side, brute_force::sign_of(
                          brute_force::det<Integer>(p[1] - p[0], p[2] - p[0], p[3] - p[0])));
    }
  });
}

TEST(Long_border_of_double, segments_from_a_corner_as_on_the_lattice)
{
  test_at_all_scales(cases_per_scale, [](const auto& p, const auto& x) {
    const Triangle triangle(x[0], x[1], x[2], traits);
    if(p[3] != p[0]) {
      ASSERT_EQ(triangle.meets_beyond_a(x[3]),
                brute_force::do_meet_beyond_corner<Integer>(p[0], p[3], p[1], p[2]));
    }
    if(p[3] != p[2]) {
      ASSERT_EQ(triangle.meets_beyond_c(x[3]),
                brute_force::do_meet_beyond_corner<Integer>(p[2], p[3], p[0], p[1]));
    }
    ASSERT_EQ(triangle.is_flat(),
              brute_force::is_zero(brute_force::cross(p[1] - p[0], p[2] - p[0])));
  });
}

TEST(Long_border_of_double, triangles_meet_as_on_the_lattice)
{
  test_at_all_scales(cases_per_scale / 10, [](const auto& p, const auto& x) {
    const bool meet = internal::Triangle_intersection<Traits>().do_intersect(
        {to_point(x[0]), to_point(x[1]), to_point(x[2])},
        {to_point(x[3]), to_point(x[4]), to_point(x[5])});
    ASSERT_EQ(meet, brute_force::do_hulls_meet<Integer>({p[0], p[1], p[2]}, {p[3], p[4], p[5]}));
  });
}

// whether p is strictly inside of a tetrahedron with corners c
bool is_inside(const Lattice_point& p, const std::array<Lattice_point, 4>& c)
{
  int sum = 0;
  for(std::size_t i = 0; i < 4; ++i) {
    std::array<Lattice_point, 4> other = c;
    other[i] = p;
    sum += brute_force::sign_of(
        brute_force::det<Integer>(other[1] - other[0], other[2] - other[0], other[3] - other[0]));
  }
  return sum == 4 || sum == -4;
}

TEST(Long_border_of_double, rays_leave_tetrahedra_as_on_the_lattice)
{
  test_at_all_scales(cases_per_scale, [](const auto& p, const auto& x) {
    if(brute_force::det<Integer>(p[1] - p[0], p[2] - p[0], p[3] - p[0]) == 0) return;
    internal::Vertical_ray<Kernel> ray(to_point(x[4]));
    for(std::size_t i = 0; i < 4; ++i)
      ray.add({to_point(x[(i + 1) % 4]), to_point(x[(i + 2) % 4]), to_point(x[(i + 3) % 4])});
    ASSERT_EQ(ray.starts_inside(), is_inside(p[4], {p[0], p[1], p[2], p[3]}));
  });
}

} // namespace test_long_border_of_double
