// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_io_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <list>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_polylines_io {

using namespace curve_io_test;
using Point_3 = Network::Point_3;
using Edges = std::vector<std::array<std::size_t, 2>>;

void expect_same(const Network& a, const Network& b)
{
  ASSERT_EQ(a.number_of_nodes(), b.number_of_nodes());
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  ASSERT_EQ(a.number_of_components(), b.number_of_components());
  for(std::size_t v = 0; v < a.number_of_nodes(); ++v) {
    const std::array<double, 3> p{a.point(v).x(), a.point(v).y(), a.point(v).z()};
    const std::array<double, 3> q{b.point(v).x(), b.point(v).y(), b.point(v).z()};
    EXPECT_EQ(std::memcmp(p.data(), q.data(), sizeof(p)), 0) << "node " << v;
    EXPECT_EQ(a.component(v), b.component(v));
  }
  for(std::size_t e = 0; e < a.number_of_edges(); ++e) {
    EXPECT_EQ(a.source(e), b.source(e));
    EXPECT_EQ(a.target(e), b.target(e));
  }
  for(std::size_t c = 0; c < a.number_of_components(); ++c)
    EXPECT_EQ(a.is_closed(c), b.is_closed(c));
}

// Doubles of all magnitudes that a curve may have.
std::vector<Point_3> random_points(std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point_3> points;
  const auto coordinate = [&]() {
    for(;;) {
      const std::uint64_t bits = random();
      double x = 0;
      std::memcpy(&x, &bits, sizeof(x));
      if(std::abs(x) <= internal::largest_coordinate) return x;
    }
  };
  while(points.size() < count) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

TEST(Round_trip, is_exact_to_the_last_bit)
{
  const Folder folder;
  std::vector<Point_3> points = random_points(200, 1);
  points.emplace_back(std::numeric_limits<double>::denorm_min(), -0., 0.1);
  points.emplace_back(1e150, -1e150, std::numeric_limits<double>::min());
  Edges edges;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(v != 99) edges.push_back({v, v == 201 ? 100 : v + 1});
  Network network(points, edges);
  network.set_pinned(7);
  network.set_pinned(150);
  for(const std::string name : {"a.obj", "a.polylines.txt", "A.OBJ", "a.Polylines.TXT", "a.vect",
                                "a.xyz", "a.txt", "a.dat", "a.ply", "a.vtp"}) {
    Network copy;
    ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file(name), network));
    ASSERT_TRUE(CGAL::IO::read_curve_network(folder.file(name), copy, Junctions::FORBIDDEN,
                                             Closure::IF_REPEATED))
        << name;
    expect_same(network, copy);
    const bool has_pins = name == "a.obj" || name == "A.OBJ" || name == "a.ply" || name == "a.vtp";
    EXPECT_EQ(copy.is_pinned(150), has_pins);
  }
  EXPECT_EQ(folder.number_of_files(), 10u);
}

TEST(Round_trip, keeps_a_network_with_junctions)
{
  std::mt19937 random(5);
  for(int repetition = 0; repetition < 50; ++repetition) {
    const std::size_t n = 12;
    std::vector<Point_3> points;
    for(std::size_t i = 0; i < n; ++i) {
      const double t = double(i + 1); // on the moment curve no two edges meet
      points.emplace_back(t, t * t, t * t * t);
    }
    Edges edges;
    for(std::size_t v = 0; v < n; ++v)
      for(std::size_t w = v + 1; w < n; ++w)
        if(random() % 5 == 0) edges.push_back({v, w});
    std::shuffle(edges.begin(), edges.end(), random);
    for(auto& edge : edges)
      if(random() % 2 == 0) std::swap(edge[0], edge[1]);
    if(edges.empty()) continue;
    const Network network(points, edges);
    const internal::Curve_paths strands(network);
    const internal::Node_columns columns = internal::node_columns(network, {});
    for(const Reading& reading :
        {read_obj(internal::to_obj(strands), Junctions::ALLOWED),
         read_ply(internal::to_ply(strands, columns), Junctions::ALLOWED),
         read_vtp(internal::to_vtp(strands, columns), Junctions::ALLOWED)}) {
      ASSERT_TRUE(reading.is_accepted);
      expect_same(network, reading.network);
    }
    const Reading txt = read_txt(internal::to_polylines_txt(strands), Junctions::ALLOWED);
    ASSERT_TRUE(txt.is_accepted);
    EXPECT_EQ(txt.network.number_of_nodes(), network.number_of_nodes());
    EXPECT_EQ(txt.network.number_of_edges(), network.number_of_edges());
  }
}

TEST(Reading, of_a_missing_file_or_an_unknown_format_is_an_error)
{
  const Folder folder;
  Network network;
  std::vector<Curve_defect> defects;
  EXPECT_FALSE(CGAL::IO::read_curve_network(folder.file("a.obj"), network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::UNREADABLE_FILE);
  EXPECT_FALSE(CGAL::IO::read_curve_network(folder.file("a.stl"), network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::UNKNOWN_FORMAT);
}

TEST(Reading, that_fails_leaves_the_network)
{
  Network network = read_obj(square + "l 1 2 3 4 1").network;
  std::vector<Curve_defect> defects;
  internal::Curve_draft file = internal::read_obj("v 0 0", Junctions::FORBIDDEN);
  EXPECT_FALSE(internal::draft_to_embedded_network(file, network, defects, Junctions::FORBIDDEN));
  EXPECT_EQ(network.number_of_nodes(), 4u);
}

TEST(Polylines, become_a_network_and_come_back)
{
  const std::list<std::vector<Point_3>> polylines = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 0, 1}, {1, 0, 1}}, {}};
  Network network;
  std::vector<Curve_defect> defects;
  ASSERT_TRUE(polylines_to_curve_network(polylines, network, defects));
  EXPECT_TRUE(defects.empty());
  std::vector<std::vector<Point_3>> result;
  curve_network_to_polylines(network, std::back_inserter(result));
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0], polylines.front());
  EXPECT_EQ(result[1], *std::next(polylines.begin()));
}

TEST(Polylines, have_a_point_map_and_any_kernel)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_point = Exact_kernel::Point_3;
  using Item = std::pair<int, Exact_point>;
  const std::vector<std::vector<Item>> polylines = {
      {{1, Exact_point(0, 0, 0)}, {2, Exact_point(1, 0, 0)}, {3, Exact_point(1, 1, 2)}}};
  Curve_network_3<Curve_flow_traits_3<Exact_kernel>> network;
  std::vector<Curve_defect> defects;
  const auto np = CGAL::parameters::point_map(CGAL::Second_of_pair_property_map<Item>());
  ASSERT_TRUE(polylines_to_curve_network(polylines, network, defects, np));
  EXPECT_EQ(network.number_of_nodes(), 3u);
  EXPECT_EQ(network.point(2), Exact_point(1, 1, 2));
}

TEST(Polylines, may_meet_until_that_is_tested)
{
  const std::string cross = "v -1 0 0\nv 1 0 0\nv 0 -1 0\nv 0 1 0\nl 1 2\nl 3 4\n";
  const Folder folder;
  const std::string file = folder.file("cross.obj");
  write(file, cross);
  Network network;
  std::vector<Curve_defect> defects;
  EXPECT_FALSE(CGAL::IO::read_embedded_curve_network(file, network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::SELF_CONTACT);
  EXPECT_EQ(defects[0].nodes, (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_EQ(network.number_of_nodes(), 0u);
  EXPECT_TRUE(CGAL::IO::read_curve_network(file, network, defects));
  EXPECT_TRUE(defects.empty());
  EXPECT_EQ(network.number_of_nodes(), 4u);
}

TEST(Polylines, that_were_perhaps_meant_to_be_closed_are_warned_of)
{
  std::vector<Point_3> circle;
  for(int i = 0; i < 20; ++i)
    circle.emplace_back(std::cos(0.1 * CGAL_PI * i), std::sin(0.1 * CGAL_PI * i), 0);
  Network network;
  std::vector<Curve_defect> defects;
  EXPECT_TRUE(polylines_to_curve_network(circle, network, defects));
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Curve_defect_kind::NEARLY_CLOSED);
  EXPECT_EQ(defects[0].nodes, (std::vector<std::size_t>{1, 20}));
  EXPECT_FALSE(is_error(defects[0].kind));

  const auto closed = parameters::closure(Closure::CLOSED);
  EXPECT_TRUE(polylines_to_curve_network(circle, network, defects, closed));
  EXPECT_TRUE(defects.empty());
  EXPECT_TRUE(network.is_closed(0));
  EXPECT_EQ(network.number_of_nodes(), 20u);
  circle.resize(18);
  EXPECT_TRUE(polylines_to_curve_network(circle, network, defects));
  EXPECT_TRUE(defects.empty());
}

// What the constructor makes of polylines, the reader of polylines makes of them, too.
TEST(Polylines, become_the_same_network_with_and_without_a_report)
{
  const std::vector<std::vector<Point_3>> polylines = {
      {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 0, 0}, {0, 0, 0}},
      {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}},
      {{0, 0, 2}, {0, 0, 1}}};
  for(const Junctions junctions : {Junctions::FORBIDDEN, Junctions::ALLOWED}) {
    const auto np = parameters::junctions(junctions);
    Network reported;
    std::vector<Curve_defect> defects;
    ASSERT_TRUE(polylines_to_curve_network(polylines, reported, defects, np));
    const Network constructed(polylines, np);
    ASSERT_EQ(reported.number_of_nodes(), constructed.number_of_nodes());
    ASSERT_EQ(reported.number_of_edges(), constructed.number_of_edges());
    for(const std::size_t v : reported.nodes()) {
      EXPECT_EQ(reported.point(v), constructed.point(v));
      EXPECT_EQ(reported.origin(v), constructed.origin(v));
    }
    EXPECT_EQ(edge_matrix(reported), edge_matrix(constructed));
    EXPECT_EQ(point_matrix(reported), point_matrix(constructed));
  }
}

} // namespace test_polylines_io
