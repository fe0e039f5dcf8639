// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Fillings between ports enter through straight necks, which are free, and fill as others do.

#include "support/fill_test_support.h"
#include "support/polygon_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_fill_ports {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Ball = VFC::Ball_domain_3<Kernel>;
using Box = VFC::Box_domain_3<Kernel>;
using Port = VFC::Port<Point>;
using Neck = VFC::Port_neck<Point>;
using VFC::internal::to_vector;
using VFC::internal::Vector;

Vector direction(const Neck& neck)
{
  return {neck.direction[0], neck.direction[1], neck.direction[2]};
}

// The nodes from an end of a component on that lie on the line of a neck, within its length.
void expect_straight(const Curve& curve, std::size_t end, int step, const Neck& neck)
{
  EXPECT_EQ(curve.point(end), neck.end);
  EXPECT_TRUE(neck.is_free);
  EXPECT_NEAR(direction(neck).norm(), 1, 1e-12);
  const Vector wall = to_vector(neck.wall);
  double reached = 0;
  for(auto v = static_cast<long>(end); curve.is_pinned(static_cast<std::size_t>(v)); v += step) {
    const Vector x = to_vector(curve.point(static_cast<std::size_t>(v))) - wall;
    const double along = x.dot(direction(neck));
    EXPECT_LT((x - along * direction(neck)).norm(), 1e-9);
    EXPECT_GT(along, reached);
    reached = along;
  }
  EXPECT_NEAR(reached, neck.length, 1e-9) << "the neck is as long as is said";
}

template <typename Domain>
std::vector<Neck> expect_filled(const Domain& domain,
                                double thickness,
                                const std::vector<Port>& ports)
{
  Curve curve;
  const auto result = VFC::fill(curve, domain, preview(thickness).ports(ports));
  EXPECT_EQ(result.status, VFC::Filling_status::CONVERGED);
  EXPECT_EQ(result.necks.size(), ports.size());
  EXPECT_EQ(curve.number_of_components(), ports.size() / 2);
  expect_inside(curve, domain);
  EXPECT_GT(coverage(curve, domain, thickness).fraction_within_r, 0.7);
  for(std::size_t c = 0; 2 * c + 1 < result.necks.size(); ++c) {
    expect_straight(curve, curve.first_node(c), 1, result.necks[2 * c]);
    expect_straight(curve, curve.first_node(c + 1) - 1, -1, result.necks[2 * c + 1]);
  }
  return result.necks;
}

// A guard that keeps a distance from the boundary cannot divide long edges near it.
TEST(Fill_ports, starts_with_edges_of_two_thicknesses_at_most)
{
  const Box bar(Point(0, 0, 0), Point(4, 1, 1));
  Curve curve;
  const auto result =
      VFC::fill(curve, bar,
                preview(0.1)
                    .ports(std::vector<Port>{{Point(0, 0.5, 0.5)}, {Point(4, 0.5, 0.5)}})
                    .number_of_iterations(0));
  ASSERT_EQ(result.start.size(), 1u);
  const std::vector<Point>& arc = result.start.front();
  for(std::size_t k = 1; k < arc.size(); ++k)
    EXPECT_LT(CGAL::squared_distance(arc[k - 1], arc[k]), 0.2001 * 0.2001) << k;
}

TEST(Fill_ports, enters_a_ball_along_its_radii)
{
  const auto necks =
      expect_filled(Ball(Point(0, 0, 0), 1), 0.2, {{Point(-0.6, 0.8, 0)}, {Point(0, 0, 1.01)}});
  EXPECT_LT((direction(necks[0]) - Vector(0.6, -0.8, 0)).norm(), 1e-4);
  EXPECT_LT((direction(necks[1]) - Vector(0, 0, -1)).norm(), 1e-4);
  for(const Neck& neck : necks) EXPECT_DOUBLE_EQ(neck.length, 0.2);
}

TEST(Fill_ports, enters_a_box_in_a_direction_that_is_given)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const auto necks =
      expect_filled(box, 0.15, {{Point(0, 0.5, 0.3), {3, 0, 3}}, {Point(0, 0.5, 0.8)}});
  EXPECT_LT((direction(necks[0]) - Vector(std::sqrt(0.5), 0, std::sqrt(0.5))).norm(), 1e-12);
  EXPECT_LT((direction(necks[1]) - Vector(1, 0, 0)).norm(), 1e-4);
}

TEST(Fill_ports, four_ports_make_two_arcs_that_share_the_volume)
{
  Curve curve;
  const Ball ball(Point(0, 0, 0), 1);
  const std::vector<Port> ports = {
      {Point(-1, 0, 0)}, {Point(1, 0, 0)}, {Point(0, -1, 0)}, {Point(0, 1, 0)}};
  expect_filled(ball, 0.2, ports);
  VFC::fill(curve, ball, preview(0.2).ports(ports));
  const std::vector<double> lengths = VFC::component_lengths(curve);
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_GT(std::min(lengths[0], lengths[1]), 0.5 * std::max(lengths[0], lengths[1]));
}

TEST(Fill_ports, arcs_divide_the_volume_in_the_proportion_of_their_shares)
{
  const std::vector<double> shares = {3, 2, 1};
  Curve curve;
  VFC::fill(curve, Box(Point(0, 0, 0), Point(2, 1, 1)),
            preview(0.1).volume_shares(shares).ports(std::vector<Port>{{Point(0, 0.2, 0.2)},
                                                                       {Point(2, 0.2, 0.2)},
                                                                       {Point(0, 0.8, 0.8)},
                                                                       {Point(2, 0.8, 0.8)},
                                                                       {Point(0, 0.2, 0.8)},
                                                                       {Point(2, 0.2, 0.8)}}));
  const std::vector<double> lengths = VFC::component_lengths(curve);
  ASSERT_EQ(lengths.size(), 3u);
  const double all = lengths[0] + lengths[1] + lengths[2];
  for(std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(lengths[c] / all, shares[c] / 6, 0.1) << c;
}

TEST(Fill_ports, refuses_shares_that_do_not_match_the_arcs)
{
  const auto message = [](const std::vector<double>& shares, VFC::Filling_start start) {
    Curve curve;
    const std::vector<Port> ports = {
        {Point(-1, 0, 0)}, {Point(1, 0, 0)}, {Point(0, -1, 0)}, {Point(0, 1, 0)}};
    try {
      VFC::fill(curve, Ball(Point(0, 0, 0), 1),
                preview(0.3).volume_shares(shares).ports(ports).start(start));
    } catch(const std::invalid_argument& error) {
      EXPECT_EQ(curve.number_of_nodes(), 0u) << "the input changes";
      return std::string(error.what());
    }
    return std::string();
  };
  constexpr VFC::Filling_start tree = VFC::Filling_start::TREE;
  EXPECT_EQ(message({1}, tree),
            "volume_shares: the number of shares is 1, but that of components is 2");
  EXPECT_EQ(message({1, 0}, tree),
            "volume_shares is 0, but the share of component 1 must be positive and finite");
  EXPECT_NE(message({1, std::numeric_limits<double>::infinity()}, tree), "");
  EXPECT_NE(message({1, 2}, VFC::Filling_start::CIRCLE), "");
  EXPECT_EQ(message({1, 2}, tree), "");
}

// A single edge joins the necks at the start.
TEST(Fill_ports, keeps_necks_side_by_side)
{
  expect_filled(Box(Point(0, 0, 0), Point(2, 1, 1)), 0.12,
                {{Point(0, 0.5, 0.5)}, {Point(0, 0.55, 0.5)}});
}

TEST(Fill_ports, refuses_shares_of_nothing)
{
  Curve curve;
  const Ball ball(Point(0, 0, 0), 1);
  EXPECT_EQ(refusal_of([&] {
              VFC::fill(curve, ball, preview(0.3).volume_shares(std::vector<double>{1}));
            }).substr(0, 50),
            "volume_shares: there are neither curves nor ports,");
}

TEST(Fill_ports, shortens_necks_where_the_domain_is_narrow)
{
  const Box plate(Point(0, 0, 0), Point(2, 2, 0.2));
  Curve curve;
  const std::vector<Port> ports = {{Point(0.5, 0.5, 0)}, {Point(1.5, 1.5, 0.2)}};
  const auto result = VFC::fill(curve, plate, preview(0.2).ports(ports).number_of_iterations(5));
  ASSERT_EQ(result.necks.size(), 2u);
  EXPECT_NEAR(result.necks[0].length, 0.1, 0.01);
  EXPECT_NEAR(std::abs(result.necks[1].direction[2]), 1, 1e-6);
}

TEST(Fill_ports, stays_in_the_plane)
{
  const VFC::Polygon_domain_3<Traits> plate(polygons::plate());
  Curve curve;
  const std::vector<Port> ports = {{Point(-1.5, 0, 0)}, {Point(0.2, 1, 0)}};
  const auto result = VFC::fill(curve, plate, preview(0.08).ports(ports));
  EXPECT_EQ(result.status, VFC::Filling_status::CONVERGED);
  for(const Point& p : curve.points()) EXPECT_EQ(p.z(), 0);
  ASSERT_EQ(result.necks.size(), 2u);
  expect_straight(curve, 0, 1, result.necks[0]);
  expect_straight(curve, curve.number_of_nodes() - 1, -1, result.necks[1]);
  EXPECT_LT((direction(result.necks[1]) - Vector(0, -1, 0)).norm(), 1e-4);
}

TEST(Fill_ports, scales_with_the_domain)
{
  const double factor = std::ldexp(1, 60);
  const auto fill = [](double scale, Curve& curve) {
    const std::vector<Port> ports = {{Point(0, 0.5 * scale, 0.3 * scale)},
                                     {Point(scale, 0.5 * scale, 0.3 * scale)}};
    return VFC::fill(curve, Box(Point(0, 0, 0), Point(scale, scale, scale)),
                     preview(0.25 * scale).ports(ports).number_of_iterations(3));
  };
  Curve small, large;
  const auto result = fill(1, small), scaled = fill(factor, large);
  ASSERT_EQ(small.number_of_nodes(), large.number_of_nodes());
  for(const std::size_t v : small.nodes())
    EXPECT_EQ(factor * to_vector(small.point(v)), to_vector(large.point(v)));
  EXPECT_EQ(factor * result.necks[0].length, scaled.necks[0].length);
  EXPECT_EQ(factor * to_vector(result.necks[1].wall), to_vector(scaled.necks[1].wall));
}

TEST(Fill_ports, refuses_ports_that_make_no_sense)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Port good{Point(0, 0.5, 0.5)};
  const auto message = [&](const std::vector<Port>& ports) {
    Curve curve;
    try {
      VFC::fill(curve, box, preview(0.1).ports(ports));
    } catch(const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const double nan = std::nan("");
  EXPECT_NE(message({good}).find("every arc needs two"), std::string::npos);
  EXPECT_NE(message({good, {Point(0.5, 0.5, 0.5)}}).find("port 2 is not at the boundary"),
            std::string::npos);
  EXPECT_NE(message({{Point(-0.3, 0.5, 0.5)}, good}).find("port 1 is not at the boundary"),
            std::string::npos);
  EXPECT_NE(message({good, {Point(0.5, 0, 0.5), {0, -1, 0}}}).find("port 2"), std::string::npos);
  EXPECT_NE(message({good, {Point(0.5, 0, 0.5), {0, nan, 0}}}).find("not finite"),
            std::string::npos);
  EXPECT_EQ(message({good, good}), "ports 1 and 2: their necks meet");
  Curve curve = polyline({Point(0.3, 0.3, 0.3), Point(0.6, 0.6, 0.6)});
  EXPECT_THROW(VFC::fill(curve, box, preview(0.1).ports(std::vector<Port>{good, good})),
               std::invalid_argument);
}

TEST(Fill_ports, refuses_an_arc_between_different_parts)
{
  const VFC::Polygon_domain_3<Traits> plates(
      std::vector<polygons::Polygon>{polygons::polygon(polygons::rectangle(0, 0, 1, 1)),
                                     polygons::polygon(polygons::rectangle(2, 0, 1, 1))});
  Curve curve;
  EXPECT_EQ(
      refusal_of([&] {
        VFC::fill(curve, plates, preview(0.1).ports(std::vector<Port>{{{0, .5, 0}}, {{3, .5, 0}}}));
      }),
      "ports 1 and 2: they lie in different parts of the inside");
}

TEST(Fill_ports, search_for_a_way_within_the_time_limit)
{
  const Ball ball({0, 0, 0}, 1);
  Curve curve;
  const auto result =
      VFC::fill(curve, ball,
                preview(0.2).ports(std::vector<Port>{{{1, 0, 0}}, {{-1, 0, 0}}}).time_limit(1e-9));
  EXPECT_EQ(result.status, VFC::Filling_status::LIMIT);
  EXPECT_EQ(curve.number_of_nodes(), 0u);
}

} // namespace test_fill_ports
