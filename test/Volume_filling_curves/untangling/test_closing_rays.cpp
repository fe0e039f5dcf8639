// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"
#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Closing_rays.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Closing rays lead from pinned ends far away, meet nothing, turn only where that is certified, and
// vanish without a trace.
namespace test_closing_rays {

using namespace flow_test;
using CGAL::Volume_filling_curves::Curve_flow_parameters;
using CGAL::Volume_filling_curves::Isotopy_guard_3;
using CGAL::Volume_filling_curves::without_closing_rays;
using guard_test::contents;
using Guard = Isotopy_guard_3<>;
using Closing_rays = internal::Closing_rays<Guard>;

constexpr double thickness = 0.2;

void grow(Closing_rays& rays)
{
  Curve_flow_parameters parameters;
  parameters.thickness = thickness;
  rays.grow<CGAL::Sequential_tag>(parameters);
}

Network pinned(Network curve)
{
  curve.pin_ends();
  return curve;
}

// A flat spiral; the inner end looks at the windings around it.
std::vector<Vector> spiral(std::size_t n, double height = 0)
{
  std::vector<Vector> points;
  for(std::size_t k = 0; k < n; ++k) {
    const double t = 0.3 * static_cast<double>(k);
    points.push_back({0.3 + (1 + t) * std::cos(t), (1 + t) * std::sin(t), height});
  }
  return points;
}

std::vector<std::size_t> tips_of(const Network& curve)
{
  std::vector<std::size_t> tips;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) == 1) tips.push_back(v);
  return tips;
}

TEST(Closing_rays, come_and_go)
{
  Random random(1);
  for(Network curve : {pinned(path(spiral(40))), pinned(path({{0, 0, 0}, {1, 0, 0}})),
                       pinned(junctions_and_ends(12, random))}) {
    const auto before = contents(curve);
    const std::size_t n = curve.number_of_nodes(), number_of_ends = tips_of(curve).size();
    {
      Guard guard(curve);
      Closing_rays rays(guard);
      EXPECT_TRUE(rays.are_needed());
      EXPECT_EQ(contents(curve), before);
      grow(rays);
      EXPECT_GT(curve.number_of_nodes(), n + 20 * number_of_ends);
      EXPECT_EQ(tips_of(curve).size(), number_of_ends);
      EXPECT_FALSE(curve.has_garbage());
      EXPECT_NO_THROW(internal::check_embedded(curve));
      EXPECT_EQ(contents(without_closing_rays(curve)), before);
      EXPECT_TRUE(rays.hold());
      EXPECT_TRUE(rays.can_turn_outwards());
      EXPECT_NEAR(internal::total_length(curve),
                  internal::total_length(without_closing_rays(curve)) + rays.length(),
                  1e-9 * rays.length());
    }
    EXPECT_EQ(contents(curve), before);
  }
}

TEST(Closing_rays, are_pinned_straight_and_even)
{
  Network curve = pinned(path(spiral(40)));
  const std::size_t n = curve.number_of_nodes();
  Guard guard(curve);
  Closing_rays rays(guard);
  grow(rays);
  const double spacing = Curve_flow_parameters().spacing * thickness;
  std::size_t number_of_edges = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    const std::size_t v = curve.source(e), w = curve.target(e);
    if(curve.origin(v) != curve.null_node() && curve.origin(w) != curve.null_node()) continue;
    ++number_of_edges;
    EXPECT_TRUE(curve.is_pinned(v) && curve.is_pinned(w));
    const double length = internal::edge_vector(curve, e).norm();
    EXPECT_GE(length, 0.7 * spacing);
    EXPECT_LE(length, 1.5 * spacing);
  }
  EXPECT_EQ(number_of_edges, curve.number_of_nodes() - n);
}

TEST(Closing_rays, lead_away_from_the_mean_beyond_a_sphere)
{
  Network curve = pinned(path({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, -1, 0}, {4, 0, 0}}));
  const Vector mean(2, 0, 0);
  Guard guard(curve);
  Closing_rays rays(guard);
  grow(rays);
  for(const std::size_t tip : tips_of(curve)) {
    const Vector p = internal::to_vector(curve.point(tip));
    EXPECT_GT((p - mean).norm(), 2 * 1.25 + 5 * thickness);
    EXPECT_NEAR(p.y(), 0, 1e-12);
    EXPECT_EQ(p.z(), 0);
  }
}

TEST(Closing_rays, avoid_the_curve_and_each_other)
{
  // the inner ends of flat spirals, one above the other, and two arcs on one ray
  std::vector<Vector> points = spiral(60), more = spiral(60, 0.25);
  const std::size_t n = points.size();
  points.insert(points.end(), more.begin(), more.end());
  for(const double x : {1., 2., 3., 4.}) points.push_back({0.01 * x, 0.02 * x, 5 + x});
  Edges edges = {{2 * n, 2 * n + 1}, {2 * n + 2, 2 * n + 3}};
  for(std::size_t v = 1; v < 2 * n; ++v)
    if(v != n) edges.push_back({v - 1, v});
  Network curve = pinned(network_of(points, edges));
  Guard guard(curve);
  Closing_rays rays(guard);
  grow(rays);
  EXPECT_EQ(tips_of(curve).size(), 8u);
  EXPECT_NO_THROW(internal::check_embedded(curve));
}

bool need_rays(Network& curve)
{
  Guard guard(curve);
  return Closing_rays(guard).are_needed();
}

TEST(Closing_rays, are_for_components_with_pinned_ends_only)
{
  Network free = path({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
          closed = internal::closed_network({circle(9)});
  EXPECT_FALSE(need_rays(free));
  EXPECT_FALSE(need_rays(closed));
  free.set_pinned(0);
  EXPECT_FALSE(need_rays(free));
  closed.set_pinned(0);
  EXPECT_FALSE(need_rays(closed));
  free.set_pinned(2);
  EXPECT_TRUE(need_rays(free));
}

TEST(Closing_rays, do_nothing_for_parameters_that_a_flow_refuses)
{
  Network curve = pinned(path({{0, 0, 0}, {1, 0, 0}}));
  for(const double bad : {-1., 0., std::nan(""), HUGE_VAL}) {
    Guard guard(curve);
    Closing_rays rays(guard);
    Curve_flow_parameters parameters;
    parameters.spacing = bad;
    rays.grow<CGAL::Sequential_tag>(parameters);
    EXPECT_EQ(curve.number_of_nodes(), 2u);
  }
}

TEST(Closing_rays, notice_a_curve_that_leaves_the_sphere)
{
  Network curve = pinned(path({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}}));
  Guard guard(curve);
  Closing_rays rays(guard);
  grow(rays);
  std::size_t middle = 0;
  while(curve.is_pinned(middle)) ++middle;
  ASSERT_TRUE(guard.move_node(middle, {1, 1.5, 0}));
  EXPECT_TRUE(rays.hold());
  ASSERT_TRUE(guard.move_node(middle, {1, 9, 0}));
  EXPECT_FALSE(rays.hold());
}

// A hook that once went around a ray cannot be undone by turning the ray.
TEST(Closing_rays, turn_only_as_far_as_nothing_is_in_the_way)
{
  std::vector<Vector> points = {{0, 0, 0}, {10, 0.1, 0}, {10, 10, 0}, {-10, 10, 0.1}, {-10, -1, 0}};
  points.insert(points.end(), {{-3, -1, 1}, {-3, 1, 1}, {-3, 1, -1}, {-3, -1, -1}, {0, -20, 0}});
  Network curve = pinned(path(points));
  Guard guard(curve);
  Closing_rays rays(guard);
  grow(rays);
  EXPECT_TRUE(rays.can_turn_outwards());
  const auto before = contents(without_closing_rays(curve));
  for(int k = 0; k < 100; ++k) rays.turn_outwards(0.1 * thickness);
  EXPECT_EQ(contents(without_closing_rays(curve)), before);
  EXPECT_NO_THROW(internal::check_embedded(curve));
  // the curve moves so that the ray should point the other way
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    if(curve.origin(v) != 2 && curve.origin(v) != 3) continue;
    EXPECT_TRUE(guard.move_node(v, {curve.point(v).x() - 60, 10, 0}));
  }
}

} // namespace test_closing_rays
