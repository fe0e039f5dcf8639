// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Networks that are constructed from polylines and matrices, and what ranges they give out.

#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace test_polylines_to_network {

namespace vfc = CGAL::Volume_filling_curves;
namespace parameters = vfc::parameters;
using vfc::Closure;
using vfc::Junctions;
using Kernel = CGAL::Epick;
using Network = vfc::Curve_network_3<>;
using Point_3 = Kernel::Point_3;
using Polyline = std::vector<Point_3>;
using Nodes = std::vector<std::size_t>;

const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1);

Nodes origins_of(const Network& network)
{
  Nodes origins;
  for(const std::size_t v : network.nodes()) origins.push_back(network.origin(v));
  return origins;
}

template <typename... Arguments>
std::string error_of(const Arguments&... arguments)
{
  return refusal_of([&] { const Network network(arguments...); });
}

TEST(Polylines, are_closed_if_they_repeat_the_first_point)
{
  const Network closed(Polyline{a, b, c, a}), open(Polyline{a, b, c});
  EXPECT_TRUE(closed.is_closed(0));
  EXPECT_EQ(closed.number_of_nodes(), 3u);
  EXPECT_EQ(closed.number_of_edges(), 3u);
  EXPECT_FALSE(open.is_closed(0));
  EXPECT_EQ(open.number_of_edges(), 2u);
}

TEST(Polylines, are_closed_if_they_are_said_to_be)
{
  const auto closed = parameters::closure(Closure::CLOSED),
             open = parameters::closure(Closure::OPEN);
  EXPECT_TRUE(Network(Polyline{a, b, c}, closed).is_closed(0));
  EXPECT_EQ(Network(Polyline{a, b, c, a}, closed).number_of_nodes(), 3u);
  EXPECT_EQ(Network(Polyline{a, b, c, a}, open).number_of_nodes(), 4u);
}

TEST(Polylines, are_components_in_their_order)
{
  const std::list<std::array<Point_3, 2>> lines = {{{a, b}}, {{c, d}}};
  const Network network(lines);
  EXPECT_EQ(network.number_of_components(), 2u);
  EXPECT_EQ(origins_of(network), (Nodes{0, 1, 2, 3}));
  EXPECT_EQ(network.point(2), c);
}

TEST(Polylines, are_joined_at_their_ends_on_request)
{
  const std::vector<Polyline> star = {{a, b}, {c, a}, {a, d}};
  const Network network(star, parameters::junctions(Junctions::ALLOWED));
  EXPECT_EQ(network.number_of_nodes(), 4u);
  EXPECT_TRUE(network.has_junction());
  EXPECT_EQ(Network(star).number_of_components(), 3u);
}

TEST(Polylines, are_read_through_a_point_map)
{
  using Item = std::pair<int, Point_3>;
  const std::vector<Item> items = {{7, a}, {8, b}, {9, c}};
  const Network network(items, parameters::point_map(CGAL::Second_of_pair_property_map<Item>()));
  EXPECT_EQ(network.point(1), b);
}

TEST(Polylines, lose_points_that_repeat_the_one_before)
{
  const Network open(Polyline{a, a, b, b, b, c, c});
  EXPECT_EQ(origins_of(open), (Nodes{0, 2, 5}));
  const Network closed(Polyline{a, b, b, c, a, a, a});
  EXPECT_TRUE(closed.is_closed(0));
  EXPECT_EQ(origins_of(closed), (Nodes{0, 1, 3}));
  EXPECT_EQ(Network(std::vector<Polyline>{{a, a, b}, {c, a, a}},
                    parameters::junctions(Junctions::ALLOWED))
                .number_of_components(),
            1u);
}

TEST(Polylines, are_refused_if_they_are_no_curves)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(std::vector<Polyline>{{a, b}, {c}}),
            "polyline 1 has fewer than two distinct points");
  EXPECT_EQ(error_of(std::vector<Polyline>{{}}), "polyline 0 has fewer than two distinct points");
  EXPECT_EQ(Network(Polyline{}).number_of_nodes(), 0u);
  EXPECT_EQ(error_of(Polyline{a, a}),
            "polyline 0 is closed and has fewer than three distinct points");
  EXPECT_EQ(error_of(Polyline{a, b, a}),
            "polyline 0 is closed and has fewer than three distinct points");
  EXPECT_EQ(error_of(Polyline{a, Point_3(0, nan, 0)}), "point 1 of polyline 0 is not finite");
  EXPECT_EQ(error_of(Polyline{a, Point_3(0, 0, -1e151)}),
            "point 1 of polyline 0 has a coordinate beyond 1e150");
  EXPECT_EQ(
      error_of(std::vector<Polyline>{{a, b}, {b, a}}, parameters::junctions(Junctions::ALLOWED)),
      "edge (1, 0) occurs twice");
}

TEST(Matrices, are_points_and_edges)
{
  Eigen::MatrixXd points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  Eigen::MatrixXi edges(3, 2);
  edges << 0, 1, 1, 2, 2, 3;
  const Network network(points, edges);
  EXPECT_EQ(network.number_of_nodes(), 4u);
  EXPECT_EQ(network.point(3), d);
  edges(2, 1) = -1;
  EXPECT_NE(error_of(points, edges).find("has no such node"), std::string::npos);
  edges(2, 1) = 3;
  points(2, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(points, edges), "point 2 is not finite");
  points(2, 2) = 1e151;
  EXPECT_EQ(error_of(points, edges), "point 2 has a coordinate beyond 1e150");
}

TEST(Ranges, give_out_all_elements)
{
  const Network network(std::vector<Polyline>{{a, b, c, a}, {d, Point_3(0, 0, 2)}});
  EXPECT_EQ(Nodes(network.nodes().begin(), network.nodes().end()), (Nodes{0, 1, 2, 3, 4}));
  EXPECT_EQ(Nodes(network.edges().begin(), network.edges().end()), (Nodes{0, 1, 2, 3}));
  EXPECT_EQ(Nodes(network.components().begin(), network.components().end()), (Nodes{0, 1}));
  EXPECT_EQ(Nodes(network.nodes(1).begin(), network.nodes(1).end()), (Nodes{3, 4}));
  EXPECT_EQ(Polyline(network.points().begin(), network.points().end()),
            (Polyline{a, b, c, d, Point_3(0, 0, 2)}));
  EXPECT_EQ(network.bbox(), CGAL::Bbox_3(0, 0, 0, 1, 1, 2));
  EXPECT_EQ(Network().nodes().begin(), Network().nodes().end());
}

// A kernel with exact predicates is a model of the traits' concept.
TEST(Traits, can_be_a_kernel)
{
  const vfc::Curve_network_3<Kernel> filtered(Polyline{a, b, c});
  EXPECT_EQ(filtered.point(1), b);
  const vfc::Curve_network_3<CGAL::Epeck> exact(Polyline{a, b, c});
  EXPECT_EQ(exact.point(1), CGAL::Epeck::Point_3(1, 0, 0));
  EXPECT_TRUE(vfc::internal::can_certify<CGAL::Simple_cartesian<CGAL::Exact_rational>>());
  EXPECT_FALSE(vfc::internal::can_certify<CGAL::Simple_cartesian<double>>());
}

} // namespace test_polylines_to_network
