// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/shared_curves.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

// The ropelength descent of tight curves from untangle().
namespace test_ropelength_descent {

using namespace untangle_test;
using CGAL::Volume_filling_curves::Default_curve_flow_visitor;
using CGAL::Volume_filling_curves::Isotopy_certificate;
using CGAL::Volume_filling_curves::ropelength;
using CGAL::Volume_filling_curves::Untangling_strategy;
using CGAL::Volume_filling_curves::verify_certificate;

const auto lowering = parameters::lower_ropelength(true);

struct Known_knot
{
  Network curve;
  double ideal; // the least ropelength that is known (Ashton, Cantarella, Piatek, Rawdon 2011)
};

std::vector<Known_knot> known_knots()
{
  return {{tangled(braid("1 1 1", 60), 2, 300), 32.74},
          {braid("1 -2 1 -2", 80), 42.09},
          {braid("1 1", 60), 8 * CGAL_PI}};
}

// Counts the motions of the descent, does something after each, and stops after the last one.
struct Descent_visitor : Default_curve_flow_visitor
{
  std::function<void()> on_motion = [] {};
  std::size_t max_motions = 1000;
  std::size_t number_of_steps = 0; // of the flow, after which the descent begins
  std::size_t number_of_motions = 0;

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    if(flow.statistics().iterations <= number_of_steps) return;
    ++number_of_motions;
    on_motion();
  }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return number_of_motions < max_motions;
  }
};

TEST(Ropelength_descent, comes_within_one_percent_of_the_least_known)
{
  constexpr double excess = 1.01, excess_of_flow = 1.08;
  for(const Known_knot& knot : known_knots()) {
    Network by_flow = knot.curve, lowered = knot.curve;
    EXPECT_FALSE(untangle(by_flow).is_ropelength_lowered);
    const Untangling_result result = untangle(lowered, lowering);
    EXPECT_EQ(result.status, Untangling_status::CONVERGED);
    EXPECT_TRUE(result.is_ropelength_lowered);
    EXPECT_GT(ropelength(by_flow), excess_of_flow * knot.ideal);
    EXPECT_LT(ropelength(lowered), excess * knot.ideal);
    EXPECT_GT(ropelength(lowered), knot.ideal);
    expect_valid(lowered, knot.curve.number_of_nodes());
  }
}

// The closures of these braids are symmetric, and stationary at 72, 48.3 and 64.
TEST(Ropelength_descent, does_not_get_stuck_on_symmetric_curves)
{
  const std::vector<std::pair<std::string, double>> ideals = {
      {"1 -2 1 -2 1 -2", 58.01}, {"1 1 1 1 1", 47.20}, {"1 1 1 1 1 1 1", 61.41}};
  for(const auto& [word, ideal] : ideals) {
    Network curve = braid(word, 120);
    EXPECT_TRUE(untangle(curve, lowering).is_ropelength_lowered);
    EXPECT_LT(ropelength(curve), 1.01 * ideal) << word;
  }
}

// Edges as long as these let the flow rattle.
TEST(Ropelength_descent, follows_a_flow_that_has_stalled)
{
  Network curve = braid("1 1 1", 60);
  const Untangling_result result = untangle(curve, lowering.spacing(0.5));
  EXPECT_EQ(result.status, Untangling_status::STALLED);
  EXPECT_TRUE(result.is_ropelength_lowered);
  EXPECT_LT(ropelength(curve), 1.01 * 32.74);
}

TEST(Ropelength_descent, keeps_strands_one_thickness_apart)
{
  for(const double thickness : {0., 0.1}) {
    Network curve = braid("1 -2 1 -2", 80);
    const Untangling_result result = untangle(curve, lowering.thickness(thickness));
    ASSERT_TRUE(result.is_ropelength_lowered);
    const double diameter = 2 * CGAL::Volume_filling_curves::polygonal_thickness(curve);
    EXPECT_NEAR(diameter / result.thickness, 1, 0.01);
  }
}

TEST(Ropelength_descent, is_certified)
{
  for(const Known_knot& knot : known_knots()) {
    Network end = knot.curve, without = knot.curve;
    Isotopy_certificate certificate;
    untangle(end, lowering.certificate(std::ref(certificate)));
    EXPECT_TRUE(verify_certificate(certificate, knot.curve, end).is_valid);
    untangle(without, lowering);
    EXPECT_EQ(contents(end), contents(without));
    EXPECT_EQ(invariants_of(end), invariants_of(knot.curve));
  }
}

// At each moment the curve is no worse than that of the flow, and certified.
TEST(Ropelength_descent, never_ends_worse_than_it_began)
{
  const Network start = braid("1 1 1", 60);
  Network by_flow = start;
  const std::size_t steps = untangle(by_flow).statistics.iterations;
  Descent_visitor whole;
  whole.number_of_steps = steps;
  Network end = start;
  untangle(end, lowering.visitor(std::ref(whole)));
  ASSERT_GT(whole.number_of_motions, 10u);
  double last = ropelength(by_flow);
  for(std::size_t motions = 1; motions < whole.number_of_motions; ++motions) {
    Descent_visitor visitor;
    visitor.number_of_steps = steps;
    visitor.max_motions = motions;
    Network curve = start;
    Isotopy_certificate certificate;
    const Untangling_result result =
        untangle(curve, lowering.visitor(std::ref(visitor)).certificate(std::ref(certificate)));
    EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
    EXPECT_FALSE(result.is_ropelength_lowered);
    EXPECT_LE(ropelength(curve), last);
    EXPECT_TRUE(verify_certificate(certificate, start, curve).is_valid) << motions;
    last = ropelength(curve);
  }
}

TEST(Ropelength_descent, keeps_the_limit_of_iterations)
{
  const Network start = braid("1 1 1", 60);
  Network by_flow = start;
  const std::size_t steps = untangle(by_flow).statistics.iterations;
  for(const std::size_t motions : {0u, 1u, 5u}) {
    Network curve = start;
    const Untangling_result result =
        untangle(curve, lowering.number_of_iterations(steps + motions));
    EXPECT_EQ(result.statistics.iterations, steps + motions);
    EXPECT_EQ(result.status, motions > 0 ? Untangling_status::LIMIT : Untangling_status::CONVERGED);
    EXPECT_FALSE(result.is_ropelength_lowered);
    EXPECT_LE(ropelength(curve), ropelength(by_flow));
  }
}

TEST(Ropelength_descent, keeps_the_limit_of_time)
{
  constexpr double limit = 1, pause = 0.3; // seconds
  const Network start = braid("1 1 1", 60);
  Network by_flow = start, curve = start;
  Descent_visitor visitor;
  visitor.number_of_steps = untangle(by_flow).statistics.iterations;
  visitor.on_motion = [&] { std::this_thread::sleep_for(std::chrono::duration<double>(pause)); };
  const Untangling_result result =
      untangle(curve, lowering.time_limit(limit).visitor(std::ref(visitor)));
  EXPECT_EQ(result.status, Untangling_status::LIMIT);
  EXPECT_FALSE(result.is_ropelength_lowered);
  EXPECT_LE(visitor.number_of_motions, 4u);
}

TEST(Ropelength_descent, gives_the_same_bits_again_and_at_other_scales)
{
  for(const Known_knot& knot : known_knots()) {
    Network curve = knot.curve;
    const Untangling_result result = untangle(curve, lowering);
    for(const int exponent : {-50, 0, 1}) {
      const double scale = std::ldexp(1., exponent);
      Network scaled = transformed(knot.curve, scale);
      EXPECT_EQ(untangle(scaled, lowering).statistics.iterations, result.statistics.iterations);
      EXPECT_EQ(internal::coordinates(scaled), scale * internal::coordinates(curve));
    }
  }
}

// The result is another one, since coordinates are rounded in other places; but as good.
TEST(Ropelength_descent, does_not_depend_on_the_place)
{
  const Network knot = braid("1 -2 1 -2", 80);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Network moved = transformed(knot, 1, turn, Vector(30, -20, 10));
  EXPECT_TRUE(untangle(moved, lowering).is_ropelength_lowered);
  EXPECT_LT(ropelength(moved), 1.01 * 42.09);
}

TEST(Ropelength_descent, takes_edges_of_all_lengths)
{
  for(const double spacing : {0.05, 0.1, 0.3}) {
    Network curve = braid("1 1 1", 60);
    EXPECT_TRUE(untangle(curve, lowering.spacing(spacing)).is_ropelength_lowered) << spacing;
    EXPECT_LT(ropelength(curve), 1.02 * 32.74) << spacing;
  }
}

// Pins, ends and walls are none of its business.
TEST(Ropelength_descent, leaves_curves_alone_that_are_held)
{
  Network pinned = braid("1 1 1", 60);
  pinned.set_pinned(0);
  Random random(3);
  std::vector<Vector> bends;
  for(int k = 0; k < 20; ++k) bends.push_back(random_point(random));
  Network open = path(bends);
  open.pin_ends();
  for(const Network& start : {pinned, open}) {
    Network with = start, without = start;
    EXPECT_FALSE(untangle(with, lowering.number_of_iterations(300)).is_ropelength_lowered);
    untangle(without, parameters::number_of_iterations(300));
    EXPECT_EQ(contents(with), contents(without));
  }
}

TEST(Ropelength_descent, leaves_curves_in_a_domain_alone)
{
  using Point_3 = Network::Point_3;
  const CGAL::Volume_filling_curves::Box_domain_3 box(Point_3(-9, -9, -9), Point_3(9, 9, 9));
  Network with = braid("1 1 1", 60), without = with;
  const Untangling_result result = untangle(with, box, lowering);
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_FALSE(result.is_ropelength_lowered);
  untangle(without, box);
  EXPECT_EQ(contents(with), contents(without));
}

TEST(Ropelength_descent, leaves_unknots_and_nothing_to_the_flow)
{
  const Network ring = internal::closed_network({circle(50)});
  const Network rings = internal::closed_network({circle(50), circle(50, 1, {9, 0, 0})});
  for(const Network& start : {Network(), ring, rings}) {
    Network with = start, without = start;
    const auto shared = parameters::stop_at_proof(false).strategy(Untangling_strategy::FLOW);
    const Untangling_result result = untangle(with, shared.lower_ropelength(true));
    EXPECT_FALSE(result.is_ropelength_lowered);
    EXPECT_EQ(result.statistics.iterations, untangle(without, shared).statistics.iterations);
    EXPECT_EQ(contents(with), contents(without));
  }
}

// The third component is a ring that hangs loose.
TEST(Ropelength_descent, tightens_links_beside_what_is_not_linked)
{
  for(const double away : {10., 1000.}) {
    Polygons polygons = {circle(40), circle(30, 1, {away, 0, 0})};
    Polygon other;
    for(const Vector& p : circle(40)) other.push_back({1 + p.x(), p.z(), p.y()});
    polygons.push_back(other);
    Network link = internal::closed_network(polygons);
    const Untangling_result result = untangle(link, lowering);
    EXPECT_EQ(result.status, Untangling_status::CONVERGED);
    EXPECT_TRUE(result.is_ropelength_lowered);
    EXPECT_LT(ropelength(link), 1.03 * (8 * CGAL_PI + 2 * CGAL_PI)) << away;
  }
}

class Ropelength_of_shared_curves : public shared_curves::Shared_data_test
{};

TEST_F(Ropelength_of_shared_curves, comes_within_one_percent_of_the_least_known)
{
  const std::vector<std::pair<std::string, double>> ideals = {
      {"rrS_3.1", 32.74}, {"rrS_4.1", 42.09}, {"rrS_8.19", 60.99}, {"rrS_2.2.1", 8 * CGAL_PI}};
  for(const auto& [name, ideal] : ideals) {
    Network curve;
    const auto file = shared_curves::folder() / "real" / "curves" / (name + ".obj");
    ASSERT_TRUE(CGAL::IO::read_curve_network(file.string(), curve));
    EXPECT_TRUE(untangle(curve, lowering).is_ropelength_lowered);
    EXPECT_LT(ropelength(curve), 1.01 * ideal) << name;
  }
}

} // namespace test_ropelength_descent
