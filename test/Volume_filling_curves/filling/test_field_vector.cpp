// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Results of direction and thickness fields, of any type.

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

namespace test_field_vector {

namespace VFC = CGAL::Volume_filling_curves;
using Traits = VFC::Curve_flow_traits_3<>;
using Point = Traits::Point_3;
using Vector = CGAL::Kernel_traits<Point>::Kernel::Vector_3;
using Exact_vector = CGAL::Exact_predicates_exact_constructions_kernel::Vector_3;
using Array = std::array<double, 3>;

struct Own_vector
{
  float a;
  float x() const { return a; }
  float y() const { return 2; }
  float z() const { return 3; }
};

struct Convertible
{
  operator Array() const { return {1, 2, 3}; }
};

TEST(Field_vector, is_made_from_all_vectors)
{
  VFC::Filling_parameters<> parameters;
  const Point p(1, 2, 3);
  const Array expected = {1, 2, 3};
  const auto expect_vector = [&] { EXPECT_EQ(Array(parameters.direction_field(p)), expected); };
  parameters.direction_field = [](const Point&) { return Array{1, 2, 3}; };
  expect_vector();
  parameters.direction_field = [](const Point& q) { return q - CGAL::ORIGIN; };
  expect_vector();
  parameters.direction_field = [](const Point& q) { return q; };
  expect_vector();
  parameters.direction_field = [](const Point&) { return Exact_vector(1, 2, 3); };
  expect_vector();
  parameters.direction_field = [](const Point&) { return Eigen::Vector3d(1, 2, 3); };
  expect_vector();
  parameters.direction_field = [](const Point&) { return Own_vector{1}; };
  expect_vector();
  parameters.direction_field = [](const Point&) { return Convertible(); };
  expect_vector();
}

TEST(Field_vector, of_no_function_is_no_field)
{
  VFC::Filling_parameters<> parameters;
  EXPECT_FALSE(parameters.direction_field);
  parameters.direction_field = std::function<Vector(const Point&)>();
  EXPECT_FALSE(parameters.direction_field);
  parameters.direction_field = std::function<Array(const Point&)>();
  EXPECT_FALSE(parameters.direction_field);
}

// The nodes of the fingers that grow with these parameters.
template <typename NamedParameters>
std::vector<Point> grow(double size, const NamedParameters& np)
{
  using Domain = VFC::Box_domain_3<>;
  const Domain domain(Point(0, 0, 0), Point(size, size, size));
  const double middle = size / 2, a = size / 8;
  VFC::Curve_network_3<> curves(
      {{middle, middle, middle}, {middle + a, middle, middle}, {middle, middle + a, middle}},
      {{0, 1}, {1, 2}, {2, 0}});
  VFC::Isotopy_guard_3<Traits, Domain> guard(curves, domain);
  VFC::grow_fingers(guard, np);
  std::vector<Point> points;
  for(const std::size_t v : curves.nodes()) points.push_back(curves.point(v));
  return points;
}

using VFC::parameters::thickness;

TEST(Field_vector, makes_no_difference_to_what_follows)
{
  const auto array = [](const Point&) { return Array{0, 0, 1}; };
  const auto vector = [](const Point&) { return Vector(0, 0, 1); };
  const auto r = [](const Point&) { return 0.125; };
  const auto r_in_float = [](const Point&) { return 0.125f; };
  const auto r_in_long_double = [](const Point&) { return 0.125l; };
  const auto expected = grow(1, thickness(r).direction_field(array));
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(grow(1, thickness(r_in_float).direction_field(vector)), expected);
  EXPECT_EQ(grow(1, thickness(r_in_long_double).direction_field(vector)), expected);
  const VFC::Curve_network_3<> edge(std::vector<Point>{{0, 0, 0}, {1, 0, 1}});
  EXPECT_EQ(VFC::alignment(edge, vector), VFC::alignment(edge, array));
}

TEST(Thickness_field, may_have_whole_numbers)
{
  const auto one = [](const Point&) { return 1; };
  const auto expected = grow(8, thickness([](const Point&) { return 1.; }));
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(grow(8, thickness(one)), expected);
  EXPECT_FALSE(grow(8, thickness(1)).empty());
  EXPECT_FALSE(grow(8, thickness(1.f)).empty());
}

} // namespace test_field_vector
