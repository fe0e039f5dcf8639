// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/refusal_of.h"
#include "support/untangle_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Tiny and degenerate curves, curves that are none, pins, and polylines.
namespace test_untangle_small {

using namespace untangle_test;
using CGAL::Volume_filling_curves::make_hard_unknot;
using Point = Network::Point_3;

std::string error_of(Network curve)
{
  return refusal_of([&] { untangle(curve); });
}

TEST(Untangle, of_nothing_does_nothing)
{
  Network nothing;
  const Untangling_result result = untangle(nothing, parameters::keep_length(true));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_TRUE(result.proofs.empty());
  EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
}

TEST(Long_untangle, takes_polygons_of_a_few_edges)
{
  for(bool stop_at_proof : {true, false})
    for(std::size_t n : {3u, 4u, 5u, 6u})
      for(double size : {1e-100, 1., 1e100}) {
        Network polygon = internal::closed_network({circle(n, size)});
        const Untangling_result result =
            untangle(polygon, parameters::stop_at_proof(stop_at_proof));
        EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
        expect_valid(polygon, n);
      }
}

TEST(Untangle, takes_open_segments)
{
  for(bool is_pinned : {false, true}) {
    Network segment = path({{0, 0, 0}, {1, 2, 3}});
    if(is_pinned) segment.pin_ends();
    const Untangling_result result = untangle(segment);
    EXPECT_EQ(result.status, Untangling_status::CONVERGED);
    EXPECT_EQ(result.proofs, std::vector<Unknot_proof>{Unknot_proof::NONE});
    EXPECT_LE(internal::total_length(segment), (1 + 1e-12) * std::sqrt(14.));
    EXPECT_EQ(internal::total_length(segment) > 0.999 * std::sqrt(14.), is_pinned);
  }
}

TEST(Untangle, takes_nearly_degenerate_curves)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Polygon> polygons = {
      {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-300, 0}},
      {{0, 0, 0}, {1, 0, 0}, {1, tiny, 0}, {0, 1e-16, 0}},
      {{0, 0, 0}, {1, 0, 0}, {1, 1e-13, 0}, {0.5, 1e-13, 1e-13}, {0, 1e-13, 0}, {0, 0, 1e-14}},
      {{0, 0, 0}, {1e9, 0, 0}, {1e9, 1e-9, 1e-9}},
      {{1e15, 0, 0}, {1e15 + 1, 0, 0}, {1e15, 1, 0}, {1e15, 1, 1}, {1e15 + 1, 1, 3}, {1e15, 0, 4}}};
  for(const Polygon& polygon : polygons)
    for(bool stop_at_proof : {true, false}) {
      Network curve = internal::closed_network({polygon});
      const double size = internal::total_length(curve);
      untangle(
          curve,
          parameters::stop_at_proof(stop_at_proof).number_of_iterations(30).thickness(0.02 * size));
      EXPECT_NO_THROW(internal::check_embedded(curve));
    }
}

TEST(Untangle, refuses_curves_that_meet_themselves_and_names_the_nodes)
{
  const Network crossing =
      path({{-1, 0, 0}, {1, 0, 0}, {2, 5, 0}, {0, 5, 0}, {0, 1, 0}, {0, -1, 0}});
  EXPECT_EQ(error_of(crossing), "the edge of nodes 0 and 1 meets the edge of nodes 4 and 5");
  EXPECT_EQ(error_of(path({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}})),
            "the nodes 1 and 2 of an edge coincide");
  EXPECT_EQ(error_of(path({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}})),
            "the edge of nodes 0 and 1 meets the edge of nodes 1 and 2");
  EXPECT_EQ(error_of(internal::closed_network({circle(8), circle(8)})).find("the edge of nodes"),
            0u);
}

TEST(Untangle, leaves_pinned_nodes_where_they_are)
{
  Network curve = make_hard_unknot(80, 2000, 9);
  for(std::size_t v : {0u, 17u, 18u, 60u}) curve.set_pinned(v);
  const Network start = curve;
  untangle(curve);
  expect_valid(curve, 80);
  std::size_t number_of_pins = 0;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.is_pinned(v)) {
      ++number_of_pins;
      EXPECT_EQ(curve.point(v), start.point(curve.origin(v)));
    }
  EXPECT_EQ(number_of_pins, 4u);
}

TEST(Untangle, leaves_a_curve_alone_that_is_pinned_altogether)
{
  Network curve = braid("1 1 1", 60);
  for(std::size_t v = 0; v < 60; ++v) curve.set_pinned(v);
  EXPECT_EQ(untangle(curve, parameters::thickness(2.)).status, Untangling_status::CONVERGED);
  EXPECT_EQ(internal::coordinates(curve), internal::coordinates(braid("1 1 1", 60)));
}

TEST(Untangle_polylines, moves_closed_ones_and_holds_the_ends_of_others)
{
  std::vector<std::vector<Point>> polylines(2);
  for(int k = 0; k <= 40; ++k) {
    const double t = 2 * CGAL_PI * (k % 40) / 40;
    polylines[0].emplace_back(std::cos(t), 0.5 * std::sin(2 * t), 0.3 * std::sin(3 * t));
    polylines[1].emplace_back(0.05 * k, 2 + 0.2 * std::sin(0.7 * k), 0);
  }
  const Point first = polylines[1].front(), last = polylines[1].back();
  const Untangling_result result = untangle(polylines);
  EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
  EXPECT_EQ(result.proofs.size(), 2u);
  ASSERT_EQ(polylines.size(), 2u);
  EXPECT_EQ(polylines[0].front(), polylines[0].back());
  EXPECT_EQ(polylines[1].front(), first);
  EXPECT_EQ(polylines[1].back(), last);
}

TEST(Untangle_polylines, does_what_the_network_does)
{
  const Network knot = braid("1 1 1", 60);
  std::vector<std::vector<Point>> polylines(1);
  for(std::size_t k = 0; k <= 60; ++k) polylines[0].push_back(knot.point(k % 60));
  const Untangling_result result = untangle(polylines, parameters::number_of_iterations(20));
  Network curve = knot;
  EXPECT_EQ(untangle(curve, parameters::number_of_iterations(20)).status, result.status);
  ASSERT_EQ(polylines[0].size(), curve.number_of_nodes() + 1);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    EXPECT_EQ(polylines[0][v], curve.point(v));
}

TEST(Untangle_polylines, refuses_what_is_no_embedded_curve)
{
  std::vector<std::vector<Point>> crossing = {{{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 1, 0}}};
  const auto copy = crossing;
  EXPECT_THROW(untangle(crossing), std::invalid_argument);
  EXPECT_EQ(crossing, copy);
  std::vector<std::vector<Point>> nothing;
  EXPECT_NO_THROW(untangle(nothing));
}

} // namespace test_untangle_small
