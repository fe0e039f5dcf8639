// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Remeshing and rescaling: even edges, and the same knot.
namespace test_remeshing {

using namespace flow_test;
using Guard = CGAL::Volume_filling_curves::Isotopy_guard_3<>;
using Flow = CGAL::Volume_filling_curves::Curve_flow_3<>;
using Remesher = internal::Remesher<Guard>;
using CGAL::Volume_filling_curves::Curve_flow_parameters;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::make_torus_knot;

std::pair<double, double> extreme_lengths(const Network& curve)
{
  std::pair<double, double> lengths(1e300, 0);
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const double length = (internal::to_vector(curve.point(curve.source(e))) -
                           internal::to_vector(curve.point(curve.target(e))))
                              .norm();
    lengths = {(std::min)(lengths.first, length), (std::max)(lengths.second, length)};
  }
  return lengths;
}

// collapses and splits until nothing changes any more, at most 20 times
std::size_t remesh(Network& curve, double spacing)
{
  Guard guard(curve);
  std::size_t number_of_refusals = 0;
  for(int k = 0; k < 20; ++k) {
    Remesher remesher(guard, std::vector<double>(curve.number_of_nodes(), spacing));
    remesher.collapse_short_edges();
    remesher.split_long_edges();
    number_of_refusals = remesher.number_of_refusals();
    if(!curve.has_garbage()) break;
    guard.collect_garbage();
  }
  return number_of_refusals;
}

TEST(Remesher, brings_edges_between_the_spacing_and_twice_the_spacing)
{
  for(std::size_t n : {8u, 100u, 3000u})
    for(double spacing : {0.02, 0.1, 0.3}) {
      Network ring = internal::closed_network({circle(n)});
      EXPECT_EQ(remesh(ring, spacing), 0u);
      const auto [least, most] = extreme_lengths(ring);
      EXPECT_GE(least, spacing) << n;
      EXPECT_LE(most, 2 * spacing) << n;
    }
}

TEST(Remesher, leaves_even_curves_alone)
{
  Network ring = internal::closed_network({circle(40)});
  const Network copy = ring;
  EXPECT_EQ(remesh(ring, 0.1), 0u);
  EXPECT_EQ(internal::coordinates(ring), internal::coordinates(copy));
}

TEST(Remesher, keeps_a_triangle_however_small)
{
  Network triangle = internal::closed_network({circle(12, 1e-3)});
  EXPECT_GT(remesh(triangle, 1), 0u); // three edges stay
  EXPECT_EQ(triangle.number_of_nodes(), 3u);
}

TEST(Remesher, leaves_pins_ends_and_junctions_where_they_are)
{
  Random random(1);
  for(double spacing : {0.003, 3.}) {
    Network curve = junctions_and_ends(12, random);
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(curve.origin(v) % 5 == 2) curve.set_pinned(v);
    const Network start = curve;
    remesh(curve, spacing);
    for(std::size_t v = 0; v < start.number_of_nodes(); ++v) {
      if(!start.is_pinned(v) && start.degree(v) == 2) continue;
      std::size_t w = 0;
      while(w < curve.number_of_nodes() && curve.origin(w) != start.origin(v)) ++w;
      ASSERT_LT(w, curve.number_of_nodes());
      EXPECT_EQ(curve.point(w), start.point(v));
      EXPECT_EQ(curve.degree(w), start.degree(v));
      EXPECT_EQ(curve.is_pinned(w), start.is_pinned(v));
    }
  }
}

std::size_t nodes_without_folds(const std::vector<Polygon>& loops, double min_radius)
{
  Network curve = internal::closed_network(loops);
  Guard guard(curve);
  const std::vector<double> min_radii(curve.number_of_nodes(), min_radius);
  Remesher(guard, min_radii).remove_folds(min_radii);
  guard.collect_garbage();
  EXPECT_NO_THROW(internal::check_embedded(curve));
  return curve.number_of_nodes();
}

TEST(Remesher, removes_folds_unless_a_strand_is_in_between)
{
  const Polygon folded = {{0, 0, 0}, {4, 0, 0}, {1, 0.1, 0}, {1, 9, 0}, {0, 9, 0}};
  EXPECT_EQ(nodes_without_folds({folded}, 1), folded.size() - 1);
  EXPECT_EQ(nodes_without_folds({folded}, 0), folded.size());
  const Polygon ring = {{2, 0.03, -1}, {2, 0.03, 1}, {2, -9, 0}};
  EXPECT_EQ(nodes_without_folds({folded, ring}, 1), folded.size() + ring.size());
}

TEST(Remesher, keeps_knots)
{
  for(double spacing : {0.05, 0.3, 1., 5.}) {
    Network knot = make_torus_knot(3, 4, 150);
    const auto expected = knot_test::invariants_of(knot_test::loops_of(knot));
    remesh(knot, spacing);
    EXPECT_NO_THROW(internal::check_embedded(knot));
    EXPECT_EQ(knot_test::invariants_of(knot_test::loops_of(knot)), expected);
  }
}

TEST(Curve_flow_3, starts_with_even_edges)
{
  Curve_flow_parameters parameters;
  parameters.thickness = 0.2;
  for(std::size_t n : {8u, 5000u}) {
    Network ring = internal::closed_network({circle(n)});
    Guard guard(ring);
    const Flow flow(guard, parameters);
    const auto [least, most] = extreme_lengths(ring);
    EXPECT_GE(least, 0.04) << n;
    EXPECT_LE(most, 0.08) << n;
  }
}

TEST(Curve_flow_3, refuses_a_thickness_that_is_not_positive_everywhere)
{
  Network ring = internal::closed_network({circle(20)});
  Guard guard(ring);
  Flow flow(guard);
  for(const double bad : {0., -0.1, std::nan(""), HUGE_VAL})
    EXPECT_THROW(
        flow.set_parameters(Curve_flow_parameters(),
                            [&](const Network::Point_3& p) { return p.x() > 0 ? 0.1 : bad; }),
        std::invalid_argument);
}

TEST(Curve_flow_3, keeps_its_parameters_if_others_are_refused)
{
  Network ring = internal::closed_network({circle(20)});
  Guard guard(ring);
  Flow flow(guard);
  Curve_flow_parameters bad;
  bad.number_of_directions = 0;
  EXPECT_THROW(flow.set_parameters(bad), std::invalid_argument);
  EXPECT_EQ(flow.parameters().number_of_directions, Curve_flow_parameters().number_of_directions);
  EXPECT_TRUE(flow.step());
}

TEST(Curve_flow_3, keeps_edges_even)
{
  Network ring = make_hard_unknot(200, 2000, 5);
  Guard guard(ring);
  Flow flow(guard);
  std::size_t number_of_uneven = 0, number_of_edges = 0;
  const double spacing = 0.2 * flow.thickness();
  for(int k = 0; k < 60; ++k) {
    flow.step();
    number_of_edges += ring.number_of_edges();
    for(std::size_t e = 0; e < ring.number_of_edges(); ++e) {
      const double length = (internal::to_vector(ring.point(ring.source(e))) -
                             internal::to_vector(ring.point(ring.target(e))))
                                .norm();
      number_of_uneven += length < 0.5 * spacing || length > 3 * spacing;
    }
  }
  EXPECT_LT(number_of_uneven, number_of_edges / 100);
}

// Earlier changes through the guard do not count.
TEST(Curve_flow_3, counts_changes_from_where_it_began)
{
  Network ring = internal::closed_network({circle(40)});
  Guard guard(ring);
  EXPECT_TRUE(guard.move_node(0, {1.1, 0, 0}));
  EXPECT_FALSE(guard.move_node(0, {-1, 0, 0}));
  Flow flow(guard);
  EXPECT_EQ(flow.statistics().certified_changes, guard.number_of_certified_changes() - 1);
  EXPECT_EQ(flow.statistics().refused_changes, guard.number_of_refused_changes() - 1);
  flow.step();
  EXPECT_EQ(flow.statistics().certified_changes, guard.number_of_certified_changes() - 1);
}

TEST(Curve_flow_3, takes_note_of_what_the_guard_changed)
{
  Network ring = internal::closed_network({circle(40)});
  Guard guard(ring);
  Flow flow(guard);
  const double length = flow.length();
  ASSERT_TRUE(guard.insert_node(0, {1.2, 0.1, 0}));
  guard.collect_garbage();
  flow.update();
  EXPECT_GT(flow.length(), length);
  EXPECT_EQ(static_cast<std::size_t>(flow.gradient().rows()), ring.number_of_nodes());
  EXPECT_TRUE(flow.step());
}

TEST(Rescaling, reaches_a_length)
{
  for(double wanted : {1e-3, 0.3, 6., 1e30}) {
    Network knot = make_torus_knot(2, 3, 80);
    const double start = internal::total_length(knot);
    Guard guard(knot);
    const double factor = internal::rescale_to_length(guard, wanted);
    EXPECT_NEAR(internal::total_length(knot), wanted, 1e-11 * wanted);
    EXPECT_NEAR(factor, wanted / start, 1e-9 * factor);
  }
}

TEST(Rescaling, stays_where_the_curve_is)
{
  const Vector away(100, -300, 200);
  Network knot = transformed(make_torus_knot(2, 3, 80), 1, Eigen::Matrix3d::Identity(), away);
  const Vector center = internal::centroid(internal::coordinates(knot));
  Guard guard(knot);
  internal::rescale_to_length(guard, 20 * internal::total_length(knot));
  const Vector after = internal::centroid(internal::coordinates(knot));
  EXPECT_LT((after - center).norm(), 1e-11);
}

// A guard that refuses the first motion.
struct Reluctant_guard
{
  const Network& curve() const { return guard.curve(); }
  double clearance() const { return guard.clearance(); }
  void set_clearance(double distance) { guard.set_clearance(distance); }

  double move_nodes(const internal::Vector_field& targets)
  {
    return std::exchange(has_refused, true) ? guard.move_nodes(targets) : 0;
  }

  Guard guard;
  bool has_refused = false;
};

TEST(Rescaling, goes_on_with_shorter_steps_when_one_is_refused)
{
  Network knot = make_torus_knot(2, 3, 80);
  const double wanted = 6 * internal::total_length(knot);
  Reluctant_guard guard{Guard(knot)};
  internal::rescale_to_length(guard, wanted);
  EXPECT_NEAR(internal::total_length(knot), wanted, 1e-11 * wanted);
}

TEST(Rescaling, ends_where_rounding_is_coarse)
{
  const Network start = make_torus_knot(2, 3, 80);
  for(double shift : {1e6, 1e12}) {
    const Vector away(shift, 0.3 * shift, -0.1 * shift);
    Network knot = transformed(start, 1, Eigen::Matrix3d::Identity(), away);
    Guard guard(knot);
    internal::rescale_to_length(guard, 1.5 * internal::total_length(start));
    EXPECT_NEAR(internal::total_length(knot) / internal::total_length(start), 1.5, 1e-15 * shift);
  }
}

TEST(Remeshing, refuses_spacings_that_would_exhaust_memory)
{
  Network ring = internal::closed_network({circle(40)});
  Guard guard(ring);
  Curve_flow_parameters parameters;
  parameters.spacing = 1e-9;
  EXPECT_THROW(Flow(guard, parameters), std::invalid_argument);
  Flow flow(guard);
  EXPECT_THROW(flow.set_spacing(1e-9), std::invalid_argument);
  EXPECT_THROW(flow.set_parameters(parameters), std::invalid_argument);
  const auto mostly_tiny = [](const auto& p) { return p.x() > 0 ? 1e-9 : 0.1; };
  EXPECT_THROW(flow.set_parameters(Curve_flow_parameters(), mostly_tiny), std::invalid_argument);
  EXPECT_EQ(flow.parameters().spacing, 0.2);
  EXPECT_TRUE(flow.step());
}

// A spacing of -1 was never reached.
TEST(Remeshing, refuses_spacings_that_are_not_positive_or_too_large)
{
  Network knot = make_torus_knot(2, 3, 30);
  Guard guard(knot);
  Flow flow(guard);
  const double spacing = flow.parameters().spacing;
  for(const double bad : {-1., 0., 1.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(flow.set_spacing(bad), std::invalid_argument) << bad;
  EXPECT_EQ(flow.parameters().spacing, spacing);
}

} // namespace test_remeshing
