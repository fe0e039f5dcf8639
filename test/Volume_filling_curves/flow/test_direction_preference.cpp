// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace test_direction_preference {

using namespace flow_test;
using internal::Direction_preference;

Direction_preference preference(const Vector& direction, double weight)
{
  Direction_preference result;
  result.directions = Vector_field(1, 3);
  internal::set_row(result.directions, 0, direction);
  result.weight = weight;
  return result;
}

// w L sin^2(phi)
double energy(const Direction_preference& preference, const Vector& edge)
{
  return preference.weight * edge.cross(internal::row(preference.directions, 0)).squaredNorm() /
         edge.norm();
}

Vector axis(int k)
{
  return {k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.};
}

TEST(Direction_preference, pulls_as_finite_differences_of_the_energy_say)
{
  constexpr double step = 1e-5;
  Random random(1);
  for(int trial = 0; trial < 100; ++trial) {
    const Vector edge = random_point(random);
    const auto p = preference(random_point(random).normalized(), between(0, 3, random));
    const Vector pull = p.pull(0, edge.normalized());
    for(int k = 0; k < 3; ++k) {
      const double difference = energy(p, edge + step * axis(k)) - energy(p, edge - step * axis(k));
      EXPECT_NEAR(pull[k], difference / (2 * step), 1e-5 * (1 + 1 / edge.norm()));
    }
  }
}

TEST(Direction_preference, is_nowhere_more_curved_than_its_stiffness)
{
  constexpr double step = 1e-4;
  Random random(2);
  double max_share = 0;
  for(int trial = 0; trial < 1000; ++trial) {
    const Vector edge = random_point(random).normalized(), way = random_point(random).normalized();
    const auto p = preference(random_point(random).normalized(), 1);
    const double curvature =
        (energy(p, edge + step * way) + energy(p, edge - step * way) - 2 * energy(p, edge)) /
        (step * step);
    EXPECT_LT(curvature, p.stiffness(0, edge) + 1e-5);
    max_share = std::max(max_share, curvature / p.stiffness(0, edge));
  }
  EXPECT_GT(max_share, 0.9) << "it is no more than needed";
}

TEST(Direction_preference, asks_for_nothing_without_a_direction_or_along_it)
{
  const Vector edge(1, 2, 3);
  EXPECT_EQ(preference(Vector(), 2).pull(0, edge.normalized()), Vector());
  EXPECT_EQ(preference(Vector(), 2).stiffness(0, edge), 0);
  EXPECT_LT(preference(edge.normalized(), 2).pull(0, edge.normalized()).norm(), 1e-15);
}

TEST(Direction_preference, has_no_negative_weight)
{
  Network knot = CGAL::Volume_filling_curves::make_torus_knot(2, 3, 30);
  CGAL::Volume_filling_curves::Isotopy_guard_3<> guard(knot);
  CGAL::Volume_filling_curves::Curve_flow_3<> flow(guard);
  const auto field = [](const Network::Point_3&) { return axis(0); };
  for(const double bad : {-5., std::numeric_limits<double>::infinity()})
    EXPECT_THROW(flow.set_direction_field(field, bad), std::invalid_argument) << bad;
}

} // namespace test_direction_preference
