// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/knots/Unknot_proofs.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

// Proofs that a curve is unknotted and a link trivial, and cases that are no proof.
namespace test_unknot_proofs {

using namespace flow_test;
using CGAL::Volume_filling_curves::Link_status;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::parse_braid_word;
using CGAL::Volume_filling_curves::Unknot_proof;
using Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>;

Network one(const Polygon& polygon)
{
  return internal::closed_network({polygon});
}

// A trefoil that runs nearly twice along a circle: its total curvature tends to 4 pi.
Network flat_trefoil(std::size_t n, double height)
{
  Polygon polygon;
  for(std::size_t k = 0; k < n; ++k) {
    const double t = 2 * CGAL_PI * static_cast<double>(k) / static_cast<double>(n);
    const double radius = 1 + height * std::cos(3 * t);
    polygon.push_back(
        {radius * std::cos(2 * t), radius * std::sin(2 * t), height * std::sin(3 * t)});
  }
  return one(polygon);
}

Network braid(const std::string& word, std::size_t number_of_strands = 1)
{
  return make_closed_braid(parse_braid_word(word), 150, 0, number_of_strands);
}

Link_status triviality(const Network& curve, Unknot_proof proof = Unknot_proof::TOTAL_CURVATURE)
{
  const std::vector<Unknot_proof> proofs(curve.number_of_components(), proof);
  return internal::Link_triviality<Network>(curve)(proofs);
}

TEST(Total_curvature, of_polygons)
{
  for(std::size_t n : {3u, 4u, 100u, 100000u})
    EXPECT_NEAR(internal::total_curvature(one(circle(n)), 0), 2 * CGAL_PI, 1e-9);
  // a closed polygon that turns by a right angle at each corner but for two
  const Polygon bent = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}};
  EXPECT_NEAR(internal::total_curvature(one(bent), 0), 3 * CGAL_PI, 1e-12);
}

TEST(Total_curvature, of_each_component_of_its_own)
{
  const Network two = internal::closed_network({circle(30), circle(9, 3)});
  for(std::size_t c : {0u, 1u}) EXPECT_NEAR(internal::total_curvature(two, c), 2 * CGAL_PI, 1e-12);
}

TEST(Unknot_proof, is_never_given_of_a_trefoil)
{
  for(double height : {0.3, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8})
    for(std::size_t n : {13u, 50u, 1000u, 20000u}) {
      const Network trefoil = flat_trefoil(n, height);
      EXPECT_EQ(internal::unknot_proof(trefoil, 0), Unknot_proof::NONE) << n << ' ' << height;
      EXPECT_NEAR(internal::total_curvature(trefoil, 0), 4 * CGAL_PI, 20 * height + 1e-7);
    }
  const auto invariants = knot_test::invariants_of(knot_test::loops_of(flat_trefoil(50, 0.01)));
  EXPECT_EQ(invariants.determinant, 3u);
}

TEST(Unknot_proof, is_never_given_of_knots_however_small_or_large)
{
  for(const char* word : {"1 1 1", "-1 -1 -1", "1 -2 1 -2", "1 1 1 1 1", "1 2 1 2 1 2 1 2"})
    for(double size : {1e-300, 1e-160, 1e-100, 1., 1e102, 1e149})
      EXPECT_EQ(internal::unknot_proof(transformed(braid(word), size), 0), Unknot_proof::NONE);
}

TEST(Unknot_proof, is_given_of_at_most_five_edges)
{
  Random random(1);
  for(std::size_t n : {3u, 4u, 5u, 6u}) {
    const Polygon polygon = random_polygon(n, random);
    EXPECT_EQ(internal::unknot_proof(one(polygon), 0) == Unknot_proof::EDGES, n < 6);
  }
}

TEST(Unknot_proof, is_given_of_gentle_curves)
{
  EXPECT_EQ(internal::unknot_proof(one(circle(6)), 0), Unknot_proof::TOTAL_CURVATURE);
  EXPECT_EQ(internal::unknot_proof(one(circle(10000)), 0), Unknot_proof::TOTAL_CURVATURE);
}

TEST(Unknot_proof, is_not_given_of_open_curves)
{
  EXPECT_EQ(internal::unknot_proof(path({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}}), 0), Unknot_proof::NONE);
}

using Points = internal::Separating_plane<Traits>::Points;

bool are_separated(const Points& p, const Points& q)
{
  const Traits traits;
  internal::Separating_plane<Traits> find(traits);
  EXPECT_EQ(find(p, q), find(q, p));
  return find(p, q);
}

TEST(Separating_plane, is_found_between_disjoint_hulls)
{
  const Points triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(are_separated(triangle, {{0, 0, 1e-9}, {1, 0, 1}, {0, 1, 1}}));
  EXPECT_TRUE(are_separated(triangle, {{0.75, 0.75, 0}, {3, 3, -1}, {3, 3, 1}}));
  EXPECT_TRUE(are_separated(triangle, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}));
}

TEST(Separating_plane, is_not_found_between_hulls_that_touch)
{
  const Points triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(are_separated(triangle, {{0.25, 0.25, 0}, {1, 0, 1}, {0, 1, 1}})); // a point
  EXPECT_FALSE(are_separated(triangle, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}));     // a corner
  EXPECT_FALSE(are_separated(triangle, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));       // an edge
  EXPECT_FALSE(are_separated(triangle, {{0.5, 0.5, -1}, {0.5, 0.5, 1}, {1, 1, 0}}));
  EXPECT_FALSE(are_separated(triangle, triangle));
}

TEST(Separating_plane, is_not_found_between_hulls_that_intersect)
{
  Random random(2);
  for(int k = 0; k < 200; ++k) {
    Points p, q;
    for(const Vector& v : random_polygon(8, random)) p.emplace_back(v.x(), v.y(), v.z());
    for(const Vector& v : random_polygon(8, random)) q.emplace_back(v.x(), v.y(), v.z());
    p.emplace_back(0.1, 0.1, 0.1); // a common point, the middle of two of q
    q.emplace_back(0.5, -0.3, 0.25);
    q.emplace_back(-0.3, 0.5, -0.05);
    EXPECT_FALSE(are_separated(p, q));
  }
}

TEST(Link_triviality, of_what_is_no_link)
{
  EXPECT_EQ(triviality(Network()), Link_status::NOT_A_LINK);
  EXPECT_EQ(triviality(one(circle(9))), Link_status::NOT_A_LINK);
  EXPECT_EQ(triviality(path({{0, 0, 0}, {1, 0, 0}})), Link_status::NOT_A_LINK);
  Random random(3);
  EXPECT_EQ(triviality(junctions_and_ends(9, random)), Link_status::NOT_A_LINK);
}

TEST(Link_triviality, of_links_with_linking_numbers)
{
  EXPECT_EQ(triviality(braid("1 1")), Link_status::LINKED);
  EXPECT_EQ(triviality(braid("-1 -1 2 2")), Link_status::LINKED);
  EXPECT_EQ(triviality(braid("1 1"), Unknot_proof::NONE), Link_status::LINKED);
}

TEST(Link_triviality, of_links_without_linking_numbers_is_undecided)
{
  EXPECT_EQ(triviality(braid("1 -2 1 -2 -2")), Link_status::UNDECIDED);   // Whitehead's
  EXPECT_EQ(triviality(braid("1 -2 1 -2 1 -2")), Link_status::UNDECIDED); // Borromean rings
}

TEST(Link_triviality, of_separated_unknots)
{
  const Network two = internal::closed_network({circle(9), circle(12, 1, {0, 0, 0.1})});
  EXPECT_EQ(triviality(two), Link_status::TRIVIAL);
  EXPECT_EQ(triviality(two, Unknot_proof::NONE), Link_status::UNDECIDED);
  const Network three =
      internal::closed_network({circle(9), circle(12, 1, {0, 0, 0.1}), circle(5, 1, {3, 0, 0})});
  EXPECT_EQ(triviality(three), Link_status::TRIVIAL);
}

// A triangle is taken away although it stands inside the hull of others, if nothing passes through.
TEST(Link_triviality, takes_triangles_away)
{
  const Polygon ring = circle(24, 5), triangle = circle(3, 1);
  EXPECT_EQ(triviality(internal::closed_network({ring, triangle})), Link_status::TRIVIAL);
  EXPECT_EQ(triviality(internal::closed_network({ring, circle(4, 1)})), Link_status::UNDECIDED);
  EXPECT_EQ(triviality(internal::closed_network({ring, triangle, circle(3, 1, {0, 2.5, 0})})),
            Link_status::TRIVIAL);
  Polygon hook = circle(24, 5); // reaches through the triangle and back
  hook[0] = {0, 0.1, 2};
  hook.insert(hook.begin() + 1, {{0, 0.1, -2}, {0.01, -0.1, -2}, {0.02, -0.1, 2}});
  EXPECT_EQ(triviality(internal::closed_network({hook, triangle})), Link_status::UNDECIDED);
}

// Boxes tell most of them apart, and searches for planes are limited: nested circles have none.
TEST(Link_triviality, of_thousands_of_unknots)
{
  std::vector<Polygon> polygons;
  for(int k = 0; k < 2000; ++k) polygons.push_back(circle(8, 1, {5. * (k % 50), 5. * (k / 50), 0}));
  EXPECT_EQ(triviality(internal::closed_network(polygons)), Link_status::TRIVIAL);
  for(int k = 0; k < 2000; ++k) polygons.push_back(circle(8, 2, {5. * (k % 50), 5. * (k / 50), 0}));
  EXPECT_EQ(triviality(internal::closed_network(polygons)), Link_status::UNDECIDED);
}

TEST(Link_triviality, is_decided_exactly_where_a_node_touches_the_disk)
{
  const Polygon triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto with_node_at = [&](double z) {
    return internal::closed_network(
        {triangle, {{1, 1, z}, {9, 9, 5}, {9, 9, -5}, {-9, -9, -5}, {-9, -9, 5}}});
  };
  EXPECT_EQ(triviality(with_node_at(0)), Link_status::UNDECIDED);
  EXPECT_EQ(triviality(with_node_at(std::numeric_limits<double>::min())), Link_status::TRIVIAL);
}

} // namespace test_unknot_proofs
