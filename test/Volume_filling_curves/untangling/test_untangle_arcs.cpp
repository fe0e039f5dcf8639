// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/shared_curves.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Closing_rays.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Arcs keep their ends, and the knot between them wherever the ends are.
namespace test_untangle_arcs {

using namespace untangle_test;
using CGAL::Volume_filling_curves::Curve_flow_3;
using CGAL::Volume_filling_curves::Untangling_strategy;

// Strands that run far outside close the arc the same way before and after.
Network closed_by_fixed_strands(const Network& arc)
{
  Polygon polygon;
  for(std::size_t v = 0; v < arc.number_of_nodes(); ++v)
    polygon.push_back(internal::to_vector(arc.point(v)));
  polygon.push_back({-100, 0, 0});
  polygon.push_back({0, 100, 0});
  polygon.push_back({100, 0, 0});
  return internal::closed_network({polygon});
}

TEST(Untangle_arcs, keeps_pinned_ends_and_the_knot_between_them)
{
  const Network trefoil = braid("1 1 1", 60);
  Polygon points = {{20, 0, 8}};
  for(std::size_t v = 0; v < 60; ++v) points.push_back(internal::to_vector(trefoil.point(v)));
  points.push_back({-20, 0.1, 9});
  Network arc = path(points);
  arc.pin_ends();
  ASSERT_NO_THROW(internal::check_embedded(arc));
  const auto expected = invariants_of(closed_by_fixed_strands(arc));
  ASSERT_EQ(expected.determinant, 3u);
  const Untangling_result result = untangle(arc);
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_EQ(result.proofs, std::vector<Unknot_proof>{Unknot_proof::NONE});
  EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
  EXPECT_EQ(internal::to_vector(arc.point(0)), points.front());
  EXPECT_EQ(internal::to_vector(arc.point(arc.number_of_nodes() - 1)), points.back());
  EXPECT_EQ(invariants_of(closed_by_fixed_strands(arc)), expected);
}

TEST(Untangle_arcs, straightens_an_arc_without_a_knot)
{
  std::vector<Vector> points;
  for(int k = 0; k <= 100; ++k)
    points.push_back({0.02 * k, 0.3 * std::sin(0.5 * k), 0.3 * std::cos(0.7 * k)});
  Network arc = path(points);
  arc.pin_ends();
  EXPECT_EQ(untangle(arc).status, Untangling_status::CONVERGED);
  EXPECT_NEAR(internal::total_length(arc), (points.back() - points.front()).norm(), 1e-2);
}

Network arc_of(const Network& closed, std::size_t first, std::size_t number_of_nodes)
{
  std::vector<Vector> points;
  for(std::size_t k = 0; k < number_of_nodes; ++k) {
    const std::size_t v = (first + k) % closed.number_of_nodes();
    points.push_back(internal::to_vector(closed.point(v)));
  }
  Network arc = path(points);
  arc.pin_ends();
  return arc;
}

// the invariants of the closure by rays away from the mean
knot_test::Invariants invariants_of_arc(const Network& arc)
{
  knot_test::Loop loop;
  for(std::size_t v = 0; v < arc.number_of_nodes(); ++v) {
    const auto& p = arc.point(v);
    loop.push_back({p.x(), p.y(), p.z()});
  }
  return knot_test::invariants_of({shared_curves::closed_far_away(loop)});
}

// Ends in the middle of a tangle: without rays the knots slip off them.
TEST(Untangle_arcs, keeps_the_knot_of_a_tangle_cut_open)
{
  int number_of_knots = 0, number_of_losses_without_rays = 0;
  for(const unsigned seed : {3u, 4u, 6u, 9u, 11u}) {
    const Network closed = tangled(braid(seed % 2 == 1 ? "1 1 1" : "1 -2 1 -2", 62), seed, 300);
    Network arc = arc_of(closed, 17 * seed, closed.number_of_nodes() - 8);
    Network other = arc;
    const auto expected = invariants_of_arc(arc);
    number_of_knots += expected.determinant > 1;
    const Vector front = internal::to_vector(arc.point(0));
    const Vector back = internal::to_vector(arc.point(arc.number_of_nodes() - 1));
    const std::size_t n = arc.number_of_nodes();
    EXPECT_EQ(untangle(arc).status, Untangling_status::CONVERGED) << seed;
    EXPECT_EQ(invariants_of_arc(arc), expected) << seed;
    EXPECT_EQ(internal::to_vector(arc.point(0)), front);
    EXPECT_EQ(internal::to_vector(arc.point(arc.number_of_nodes() - 1)), back);
    EXPECT_EQ(arc.origin(0), 0u);
    EXPECT_EQ(arc.origin(arc.number_of_nodes() - 1), n - 1);
    expect_valid(arc, n);
    CGAL::Volume_filling_curves::Isotopy_guard_3 guard(other);
    Curve_flow_3 flow(guard);
    for(int k = 0; k < 500 && flow.gradient_norm() > 7e-3; ++k) flow.step();
    number_of_losses_without_rays += !(invariants_of_arc(other) == expected);
  }
  EXPECT_EQ(number_of_knots, 5);
  EXPECT_GE(number_of_losses_without_rays, 2);
}

// Whether `untangle()` ends with a closure that has the type of the arc's, if it says so.
void expect_honest_limit(const Network& arc, std::size_t limit)
{
  Network moved = arc;
  const Untangling_result result =
      untangle(moved, parameters::number_of_iterations(limit).strategy(Untangling_strategy::FLOW));
  const bool is_same = invariants_of_arc(moved) == invariants_of_arc(arc);
  EXPECT_TRUE(is_same || !result.is_closure_kept) << limit;
}

// After few iterations strands may be where the closing lines were not.
TEST(Untangle_arcs, tells_at_a_limit_whether_the_closure_is_kept)
{
  const Network closed = tangled(braid("1 1 1", 62), 3, 300);
  const Network arc = arc_of(closed, 51, closed.number_of_nodes() - 8);
  for(const std::size_t limit : {1u, 5u, 20u, 80u}) expect_honest_limit(arc, limit);
  Network tight = arc;
  EXPECT_TRUE(untangle(tight).is_closure_kept);
}

TEST(Shared_data, an_arc_whose_closure_changes_is_told)
{
  const std::string file = std::string(VFC_SHARED_DATA) + "/attack/pinned_arc.obj";
  if(!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  Network arc;
  ASSERT_TRUE(CGAL::IO::read_curve_network(file, arc));
  arc.pin_ends();
  expect_honest_limit(arc, 100);
  Network moved = arc;
  EXPECT_FALSE(
      untangle(moved, parameters::number_of_iterations(100).strategy(Untangling_strategy::FLOW))
          .is_closure_kept);
}

// A ring stays on an arc; whether it is on the arc is the linking number with the closed arc.
TEST(Untangle_arcs, keeps_a_ring_on_an_arc)
{
  Polygon ring;
  for(int k = 0; k < 30; ++k) ring.push_back({0.9, std::cos(0.2 * k), std::sin(0.2 * k)});
  const std::vector<Vector> arc = {{-1, 0, 0}, {0, 0.01, 0}, {1, 0, 0}};
  std::vector<Vector> points = arc;
  points.insert(points.end(), ring.begin(), ring.end());
  Edges edges = {{0, 1}, {1, 2}};
  for(std::size_t k = 0; k < ring.size(); ++k) edges.push_back({3 + k, 3 + (k + 1) % ring.size()});
  Network curves = network_of(points, edges);
  curves.pin_ends();
  untangle(curves, parameters::number_of_iterations(300).thickness(0.1));
  knot_test::Loop closed_arc, moved_ring;
  for(std::size_t v = 0; v < curves.number_of_nodes(); ++v) {
    const auto& p = curves.point(v);
    (curves.component(v) == 0 ? closed_arc : moved_ring).push_back({p.x(), p.y(), p.z()});
  }
  closed_arc.insert(closed_arc.end(), {{100, 0.1, 0.2}, {0, 100, 0.3}, {-100, 0.3, 0.1}});
  const auto diagram = knot_test::diagram_of({closed_arc, moved_ring});
  EXPECT_EQ(std::abs(knot_test::linking_numbers(diagram)[0][1]), 1);
}

struct Stop_soon : CGAL::Volume_filling_curves::Default_curve_flow_visitor
{
  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    const Network& curve = flow.curve();
    const Network arc = CGAL::Volume_filling_curves::without_closing_rays(curve);
    EXPECT_LT(arc.number_of_nodes(), curve.number_of_nodes());
    EXPECT_EQ(arc.origin(0), 0u);
    if(flow.statistics().iterations == 3) throw 17;
  }
};

TEST(Untangle_arcs, leaves_no_rays_behind_when_a_visitor_throws)
{
  Network arc = arc_of(tangled(braid("1 1 1", 60), 1), 5, 100);
  const std::size_t n = arc.number_of_nodes();
  Stop_soon visitor;
  EXPECT_THROW(untangle(arc, parameters::visitor(std::ref(visitor))), int);
  expect_valid(arc, n);
  EXPECT_EQ(arc.origin(0), 0u);
  EXPECT_EQ(arc.origin(arc.number_of_nodes() - 1), n - 1);
}

TEST(Untangle_arcs, refuses_bad_parameters_as_for_closed_curves)
{
  Network arc = arc_of(braid("1 1 1", 60), 0, 40);
  const auto before = contents(arc);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(untangle(arc, parameters::thickness(nan)), std::invalid_argument);
  EXPECT_THROW(untangle(arc, parameters::spacing(0.)), std::invalid_argument);
  EXPECT_THROW(untangle(arc, parameters::number_of_directions(0)), std::invalid_argument);
  EXPECT_EQ(contents(arc), before);
}

// The certificate leaves out the closing rays: it proves the motion of the arc alone.
TEST(Untangle_arcs, can_be_verified_by_others)
{
  Network arc = arc_of(tangled(braid("1 1 1", 60), 3), 5, 100);
  const Network start = arc;
  CGAL::Volume_filling_curves::Isotopy_certificate certificate;
  untangle(arc, parameters::certificate(std::ref(certificate)).number_of_iterations(30));
  const auto verdict = CGAL::Volume_filling_curves::verify_certificate(certificate, start, arc);
  EXPECT_TRUE(verdict.is_valid) << verdict.message;
}

TEST(Untangle_arcs, scales_with_powers_of_two_to_the_bit)
{
  Network arc = arc_of(tangled(braid("1 1 1", 60), 2), 5, 100), scaled = transformed(arc, 1024);
  untangle(arc, parameters::number_of_iterations(50));
  untangle(scaled, parameters::number_of_iterations(50));
  EXPECT_EQ(contents(transformed(arc, 1024)), contents(transformed(scaled, 1)));
}

} // namespace test_untangle_arcs
