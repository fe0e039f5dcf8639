// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Polylines that are untangled, simplified, filled with and measured; and origins under all
// strategies.

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <list>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_polylines_in_place {

using namespace CGAL::Volume_filling_curves;
using Network = Curve_network_3<>;
using Point_3 = Network::Point_3;
using Polyline = std::vector<Point_3>;
using Polylines = std::vector<Polyline>;
using Origins = std::vector<Curve_origin>;
using Mesh = CGAL::Surface_mesh<Point_3>;

Polylines polylines_of(const Network& network)
{
  Polylines result;
  curve_network_to_polylines(network, std::back_inserter(result));
  return result;
}

// Adds a tetrahedron around a ball of radius 5, whose center is at x.
void add_tetrahedron(Mesh& mesh, double x)
{
  CGAL::make_tetrahedron(Point_3(x - 9, -9, -9), Point_3(x + 9, 9, -9), Point_3(x + 9, -9, 9),
                         Point_3(x - 9, 9, 9), mesh);
}

// A line that winds three times around an axis.
Polyline coil()
{
  Polyline points;
  for(int i = 0; i <= 60; ++i) {
    const double t = 0.1 * CGAL_PI * i;
    points.emplace_back(std::cos(t), std::sin(t), 0.2 * t);
  }
  return points;
}

// Returns whether the numbers along the input grow, except for at most one restart of a closed
// curve.
void expect_to_run_once(const Origins& origins, bool is_closed)
{
  std::size_t number_of_starts = 0;
  const auto rank = [](const Curve_origin& origin) {
    return static_cast<double>(origin.source) + origin.parameter;
  };
  for(std::size_t i = 0; i + 1 < origins.size(); ++i)
    if(rank(origins[i + 1]) < rank(origins[i])) ++number_of_starts;
  EXPECT_LE(number_of_starts, is_closed ? 1u : 0u);
}

TEST(Polyline, is_untangled_like_the_network)
{
  Network network = make_hard_unknot(100, 2000, 1);
  Polyline polyline = polylines_of(network)[0];
  Polylines several(1, polyline);
  const Untangling_result expected = untangle(network);
  EXPECT_EQ(untangle(polyline).status, expected.status);
  EXPECT_EQ(untangle(several).status, expected.status);
  EXPECT_EQ(polyline, polylines_of(network)[0]);
  EXPECT_EQ(several, polylines_of(network));
}

TEST(Polyline, that_is_said_to_be_closed_stays_without_repetition)
{
  Polyline polyline = polylines_of(make_regular_polygon(40))[0];
  polyline.pop_back();
  simplify_curves(polyline, parameters::closure(Closure::CLOSED));
  EXPECT_EQ(polyline.size(), 3u);
  EXPECT_NE(polyline.front(), polyline.back());
}

TEST(Polyline, keeps_its_ends)
{
  const Polyline start = coil();
  Polyline arc = start;
  untangle(arc);
  EXPECT_EQ(arc.front(), start.front());
  EXPECT_EQ(arc.back(), start.back());
  EXPECT_LT(measure(arc).length, measure(start).length);
}

TEST(Polyline, is_unchanged_if_it_cannot_be_untangled)
{
  const Polyline bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  Polyline polyline = bow_tie;
  EXPECT_THROW(untangle(polyline), std::invalid_argument);
  EXPECT_EQ(polyline, bow_tie);
}

TEST(Polylines, have_items_with_points)
{
  using Item = std::pair<int, Point_3>;
  std::list<std::list<Item>> polylines(2);
  for(const Point_3& p : coil()) {
    polylines.front().emplace_back(1, p);
    polylines.back().emplace_back(2, Point_3(p.x() + 5, p.y(), p.z()));
  }
  std::vector<Origins> origins;
  const std::size_t count =
      simplify_curves(polylines, parameters::point_map(CGAL::Second_of_pair_property_map<Item>())
                                     .max_distance(0.1)
                                     .origins(std::ref(origins)));
  EXPECT_EQ(polylines.front().size() + polylines.back().size() + count, 2 * 61u);
  ASSERT_EQ(origins.size(), 2u);
  EXPECT_EQ(origins[1].size(), polylines.back().size());
  EXPECT_EQ(origins[1].front().source, 61u);
  EXPECT_EQ(polylines.back().back().second, Point_3(6, coil().back().y(), coil().back().z()));
}

// A point map that cannot write.
struct Read_only_map
{
  using key_type = Point_3;
  using value_type = Point_3;
  using reference = const Point_3&;
  using category = boost::read_write_property_map_tag;

  friend const Point_3& get(const Read_only_map&, const Point_3& p) { return p; }
  friend void put(const Read_only_map&, Point_3&, const Point_3&) { throw std::runtime_error(""); }
};

TEST(Polylines, are_unchanged_if_a_point_map_throws)
{
  Polyline polyline = coil();
  const auto np = parameters::point_map(Read_only_map()).max_distance(0.1);
  EXPECT_THROW(simplify_curves(polyline, np), std::runtime_error);
  EXPECT_EQ(polyline, coil());
}

TEST(Polylines, fill_a_domain)
{
  const Ball_domain_3<> ball(Point_3(0, 0, 0), 1);
  Polyline polyline = {{-0.9, 0, 0}, {0.9, 0, 0}};
  Origins origins;
  const auto result = fill(
      polyline, ball, parameters::thickness(0.4).round_bends(false).origins(std::ref(origins)));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_EQ(polyline.front(), Point_3(-0.9, 0, 0));
  EXPECT_EQ(polyline.back(), Point_3(0.9, 0, 0));
  ASSERT_EQ(origins.size(), polyline.size());
  expect_to_run_once(origins, false);
  Polylines none;
  fill(none, ball, parameters::thickness(0.4));
  EXPECT_EQ(none.size(), 1u);
}

TEST(Polyline, may_be_empty)
{
  Polyline none;
  untangle(none);
  EXPECT_TRUE(none.empty());
  simplify_curves(none);
  EXPECT_TRUE(none.empty());
}

TEST(Polyline, is_untangled_in_a_mesh_like_the_network)
{
  Mesh mesh;
  add_tetrahedron(mesh, 0);
  Network network = make_torus_knot(2, 3, 60);
  Polyline polyline = polylines_of(network)[0];
  Origins origins;
  const auto limit = parameters::number_of_iterations(5);
  const Untangling_result expected = untangle(network, mesh, limit);
  EXPECT_EQ(untangle(polyline, mesh, limit.origins(std::ref(origins))).status, expected.status);
  EXPECT_EQ(polyline, polylines_of(network)[0]);
  EXPECT_EQ(origins.size(), polyline.size());
}

TEST(Polylines, are_as_many_as_a_domain_has_parts)
{
  Mesh mesh;
  add_tetrahedron(mesh, 0);
  add_tetrahedron(mesh, 100);
  const auto thick = parameters::thickness(4);
  Polylines curves;
  fill(curves, mesh, thick);
  EXPECT_EQ(curves.size(), 2u);
  Polyline one;
  EXPECT_THROW(fill(one, mesh, thick), std::invalid_argument);
  EXPECT_TRUE(one.empty());
}

TEST(Polylines, are_measured)
{
  const Polylines link = polylines_of(make_torus_knot(2, 2, 60));
  EXPECT_EQ(measure(link).linking_matrix[0][1], 1);
  EXPECT_EQ(measure(link[0]).component_lengths.size(), 1u);
}

TEST(Origins, run_along_the_input_under_every_strategy)
{
  for(const Untangling_strategy strategy :
      {Untangling_strategy::FLOW, Untangling_strategy::SEARCH, Untangling_strategy::AUTO}) {
    Network knot = make_torus_knot(2, 3, 150);
    untangle(knot, parameters::strategy(strategy));
    const Origins origins = curve_origins(knot);
    expect_to_run_once(origins, true);
    for(const std::size_t v : knot.nodes()) {
      if(knot.origin(v) == Network::null_node()) continue;
      EXPECT_EQ(origins[v].source, knot.origin(v));
      EXPECT_EQ(origins[v].parameter, 0);
    }
    Polyline arc = coil();
    Origins of_arc;
    untangle(arc, parameters::strategy(strategy).origins(std::ref(of_arc)));
    ASSERT_EQ(of_arc.size(), arc.size());
    expect_to_run_once(of_arc, false);
    EXPECT_EQ(of_arc.front().source, 0u);
    EXPECT_EQ(of_arc.back().target, 60u);
    EXPECT_EQ(of_arc.back().parameter, 1);
  }
}

} // namespace test_polylines_in_place
