// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// Converged curves are tight: however smooth a curve is on the scale of its thickness, the pull of
// its length must be carried.
namespace test_untangle_tight {

using namespace untangle_test;
using CGAL::Volume_filling_curves::ropelength;
using CGAL::Volume_filling_curves::Untangling_strategy;

constexpr Untangling_strategy strategies[] = {Untangling_strategy::AUTO, Untangling_strategy::FLOW};

// The torus knot T(p, q) as a thin bundle of p strands around a circle of radius 1.
Network ribbon(int p, int q, double gap)
{
  constexpr std::size_t n = 120;
  Polygon polygon;
  for(std::size_t k = 0; k < n; ++k) {
    const double t = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(n);
    const double r = 1 + gap * std::cos(q * t);
    polygon.emplace_back(r * std::cos(p * t), r * std::sin(p * t), gap * std::sin(q * t));
  }
  return internal::closed_network({polygon});
}

TEST(Long_untangle_tight, brings_ribbons_to_the_ropelength_of_their_knot)
{
  for(const Untangling_strategy strategy : strategies)
    for(const double gap : {1e-2, 1e-3, 1e-4}) {
      Network trefoil = ribbon(2, 3, gap);
      const Untangling_result result = untangle(trefoil, parameters::strategy(strategy));
      EXPECT_EQ(result.status, Untangling_status::CONVERGED) << gap;
      EXPECT_LT(ropelength(trefoil), 40) << gap; // the least that is known is 32.7
    }
}

TEST(Untangle_tight, unties_ribbons_that_are_unknots)
{
  for(const Untangling_strategy strategy : strategies) {
    Network unknot = ribbon(3, 1, 1e-3);
    EXPECT_EQ(untangle(unknot, parameters::strategy(strategy)).status,
              Untangling_status::UNKNOTTED);
  }
}

// Its loops have to shrink by 20,000 thicknesses, which takes more iterations than there are.
TEST(Untangle_tight, names_a_thickness_where_the_given_one_is_too_small)
{
  const Network start = ribbon(2, 3, 0.1);
  for(const Untangling_strategy strategy : strategies) {
    Network curve = start;
    const Untangling_result result =
        untangle(curve, parameters::strategy(strategy).thickness(2e-3).number_of_iterations(50));
    EXPECT_EQ(result.status, Untangling_status::STALLED);
    EXPECT_EQ(result.thickness, 2e-3);
    ASSERT_GT(result.fitting_thickness, 4e-3);
    Network again = start;
    EXPECT_EQ(untangle(again, parameters::thickness(result.fitting_thickness)).status,
              Untangling_status::CONVERGED);
    EXPECT_LT(ropelength(again), 40);
  }
}

TEST(Untangle_tight, calls_tight_knots_links_and_straight_arcs_converged)
{
  for(const char* word : {"1 1 1", "1 -2 1 -2", "1 1", "1 -2 1 -2 1 -2"}) {
    Network curve = braid(word, 120);
    const Untangling_result result =
        untangle(curve, parameters::strategy(Untangling_strategy::FLOW));
    EXPECT_EQ(result.status, Untangling_status::CONVERGED) << word;
    EXPECT_EQ(result.fitting_thickness, 0) << word;
  }
  Network arc = path({{0, 0, 0}, {1, 0.3, 0}, {2, -0.2, 0.1}, {3, 0, 0}});
  arc.pin_ends();
  EXPECT_EQ(untangle(arc, parameters::thickness(0.02)).status, Untangling_status::CONVERGED);
  EXPECT_LT(CGAL::Volume_filling_curves::length(arc), 3.01);
}

TEST(Untangle_tight, means_that_little_of_the_pull_is_loose)
{
  Network loose = internal::closed_network({circle(100)}), tight = braid("1 1 1", 60);
  CGAL::Volume_filling_curves::Isotopy_guard_3<> guard(loose);
  CGAL::Volume_filling_curves::Curve_flow_parameters thin;
  thin.thickness = 0.01;
  const CGAL::Volume_filling_curves::Curve_flow_3<> flow(guard, thin);
  EXPECT_NEAR(flow.loose_share(), 1, 0.1);

  const double r = untangle(tight, parameters::strategy(Untangling_strategy::FLOW)).thickness;
  CGAL::Volume_filling_curves::Isotopy_guard_3<> tight_guard(tight);
  thin.thickness = r;
  const CGAL::Volume_filling_curves::Curve_flow_3<> tight_flow(tight_guard, thin);
  EXPECT_LT(tight_flow.loose_share(), 0.02);
}

} // namespace test_untangle_tight
