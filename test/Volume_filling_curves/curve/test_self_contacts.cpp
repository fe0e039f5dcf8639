// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/brute_force_curve.h"
#include "support/curve_defects_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_self_contacts {

using namespace curve_defects_test;

TEST(Contacts, are_described)
{
  const auto kind = Kind::SELF_CONTACT;
  // crossing
  expect_only(check_obj("v -1 0 0\nv 1 0 0\nv 0 -1 0\nv 0 1 0\nl 1 2\nl 3 4"), kind, 1,
              {1, 2, 3, 4});
  // a node on an edge, in the middle of a line
  const auto touch = check_obj("v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nl 1 2\nl 3 4");
  expect_only(touch, kind, 4, {4, 1, 2});
  EXPECT_EQ(touch[0].component, 2u);
  // coincident nodes that are no neighbors, reported once for four pairs of edges
  expect_only(check_obj("v -1 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 0 -1 0\n"
                        "l 1 2 3\nl 4 5 6"),
              kind, 2, {2, 5});
  // overlap
  expect_only(check_obj("v 0 0 0\nv 2 2 2\nv 1 1 1\nv 3 3 3\nl 1 2\nl 3 4"), kind, 1, {1, 2, 3, 4});
  // overlap of neighbors
  expect_only(check_obj("v 0 0 0\nv 2 2 2\nv 1 1 1\nl 1 2 3"), kind, 1, {1, 2, 3});
  // apart, but only just
  EXPECT_TRUE(check_obj("v -1 0 0\nv 1 0 0\nv 0 -1 5e-324\nv 0 1 5e-324\nl 1 2\nl 3 4").empty());
}

TEST(Contacts, are_listed_up_to_a_thousand_with_their_total)
{
  std::string text;
  for(int i = 0; i < 50; ++i) {
    const std::string s = std::to_string(i);
    text += "v " + s + " 0 0\nv " + s + " 50 0\nv 0 " + s + " 0\nv 50 " + s + " 0\n";
    text += "l -4 -3\nl -2 -1\n";
  }
  const auto defects = check_obj(text);
  ASSERT_EQ(defects.size(), 1001u);
  EXPECT_EQ(defects.back().message, "2500 pairs of edges meet in total, the first 1000 are listed");
}

// Curves on a small lattice are full of coincidences.
brute_force::Curve random_lattice_curve(std::mt19937& random)
{
  brute_force::Curve curve;
  const std::size_t n = 3 + random() % 6;
  const std::size_t size = 2 + random() % 3;
  const auto coordinate = [&]() { return static_cast<brute_force::Integer>(random() % size); };
  while(curve.points.size() < n) {
    const auto x = coordinate(), y = coordinate(), z = coordinate();
    const brute_force::Lattice_point p = {x, y, z};
    if(curve.points.empty() || (p != curve.points.back() && p != curve.points.front()))
      curve.points.push_back(p);
  }
  const bool is_closed = random() % 2 == 0;
  for(std::size_t v = 0; v + (is_closed ? 0 : 1) < n; ++v) curve.edges.push_back({v, (v + 1) % n});
  return curve;
}

TEST(Contacts, are_those_of_brute_force)
{
  std::mt19937 random(1);
  int number_of_embedded = 0;
  for(int repetition = 0; repetition < 3000; ++repetition) {
    const brute_force::Curve curve = random_lattice_curve(random);
    std::vector<Network::Point_3> points;
    for(const auto& p : curve.points) points.emplace_back(double(p[0]), double(p[1]), double(p[2]));
    std::vector<std::array<std::size_t, 2>> expected;
    for(std::size_t e = 0; e < curve.edges.size(); ++e)
      for(std::size_t f = e + 1; f < curve.edges.size(); ++f)
        if(!brute_force::is_pair_embedded(curve, e, f)) expected.push_back({e, f});
    internal::Self_contacts<Curve_flow_traits_3<>> contacts(points, curve.edges);
    contacts.find(1000);
    EXPECT_EQ(contacts.kept(), expected);
    EXPECT_EQ(contacts.count(), expected.size());
    EXPECT_EQ(is_embedded(Network(points, curve.edges)), expected.empty());
    number_of_embedded += expected.empty();
  }
  EXPECT_GT(number_of_embedded, 300);
  EXPECT_LT(number_of_embedded, 2700);
}

TEST(Contacts, are_edges_without_length_too)
{
  const Network curve({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1}, {1, 2}, {2, 3}});
  EXPECT_FALSE(is_embedded(curve));
  EXPECT_TRUE(is_embedded(Network()));
}

// A polyline without the points that repeat the one before them.
std::vector<brute_force::Lattice_point> distinct_points(
    std::vector<brute_force::Lattice_point> points, bool is_closed)
{
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while(is_closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

TEST(Files, are_accepted_exactly_if_the_merged_curve_is_embedded)
{
  std::mt19937 random(3);
  int number_of_accepted = 0;
  for(int repetition = 0; repetition < 3000; ++repetition) {
    const std::size_t n = 1 + random() % 7;
    const bool is_closed = random() % 2 == 0;
    std::vector<brute_force::Lattice_point> points;
    std::string text, line = "l";
    for(std::size_t v = 0; v < n; ++v) {
      points.push_back(points.empty() || random() % 4 > 0
                           ? brute_force::Lattice_point{brute_force::Integer(random() % 3),
                                                        brute_force::Integer(random() % 3),
                                                        brute_force::Integer(random() % 3)}
                           : points.back());
      text += "v";
      for(const auto x : points.back()) text += " " + std::to_string(x);
      text += "\n";
      line += " " + std::to_string(v + 1);
    }
    internal::Curve_draft file =
        internal::read_obj(text + line + (is_closed ? " 1" : ""), Junctions::FORBIDDEN);
    Network network;
    std::vector<Curve_defect> defects;
    const bool is_accepted =
        internal::draft_to_embedded_network(file, network, defects, Junctions::FORBIDDEN);
    brute_force::Curve curve{distinct_points(points, is_closed), {}};
    const std::size_t m = curve.points.size();
    for(std::size_t v = 0; v + (is_closed ? 0 : 1) < m; ++v)
      curve.edges.push_back({v, (v + 1) % m});
    EXPECT_EQ(is_accepted, m >= (is_closed ? 3u : 2u) && brute_force::is_embedded(curve)) << text;
    if(!is_accepted) continue;
    ++number_of_accepted;
    EXPECT_EQ(network.number_of_nodes(), m);
    EXPECT_EQ(network.is_closed(0), is_closed);
  }
  EXPECT_GT(number_of_accepted, 300);
}

TEST(Contacts, kept_are_the_first)
{
  std::mt19937 random(2);
  std::vector<Network::Point_3> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 0; v < 300; ++v) points.emplace_back(double(random() % 1000), double(v), 0);
  for(std::size_t v = 0; v < 300; ++v) edges.push_back({v, (v * 7 + 2) % 300});
  internal::Self_contacts<Curve_flow_traits_3<>> all(points, edges), some(points, edges);
  all.find(1000000);
  some.find(100);
  ASSERT_GT(all.count(), 100u);
  EXPECT_EQ(some.count(), all.count());
  EXPECT_TRUE(std::equal(some.kept().begin(), some.kept().end(), all.kept().begin()));
}

TEST(Contacts, end_the_search_when_there_are_millions)
{
  std::string text;
  for(int i = 0; i < 10000; ++i) text += "v " + std::to_string(i % 2) + " 0 0\n";
  const auto defects = check_obj(text);
  ASSERT_FALSE(defects.empty());
  EXPECT_EQ(defects.back().message,
            "at least 1000000 pairs of edges meet in total, the first 1000 are listed");
}

} // namespace test_self_contacts
