// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/round_trip_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace test_polylines_io {

using namespace round_trip_test;

TEST(Round_trip, is_exact_to_the_last_bit)
{
  const Folder folder;
  const Network network = arc_and_loop();
  for(const std::string name : {"a.obj", "a.polylines.txt", "A.OBJ", "a.Polylines.TXT"}) {
    Network copy;
    ASSERT_TRUE(CGAL::IO::write_curve_network(folder.file(name), network));
    ASSERT_TRUE(CGAL::IO::read_curve_network(folder.file(name), copy)) << name;
    expect_same(network, copy);
    EXPECT_EQ(copy.is_pinned(150), name == "a.obj" || name == "A.OBJ");
  }
  EXPECT_EQ(folder.number_of_files(), 4u);
  EXPECT_FALSE(CGAL::IO::write_curve_network(folder.file("a.ply"), network));
  EXPECT_EQ(folder.number_of_files(), 4u);
}

TEST(Round_trip, keeps_a_network_with_junctions)
{
  for(unsigned seed = 0; seed < 50; ++seed) {
    const Network network = network_with_junctions(seed);
    const internal::Curve_paths strands(network);
    const Reading obj = read_obj(internal::to_obj(strands), Junctions::ALLOWED);
    ASSERT_TRUE(obj.is_accepted);
    expect_same(network, obj.network);
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

Network read_with_closure(const std::string& name, const std::string& text, Closure closure)
{
  const Folder folder;
  Network network;
  std::vector<Curve_defect> defects;
  write(folder.file(name), text);
  EXPECT_TRUE(CGAL::IO::read_curve_network(folder.file(name), network, defects,
                                           Junctions::FORBIDDEN, closure));
  return network;
}

TEST(Reading, opens_and_closes_curves_with_edges_that_are_dropped)
{
  for(const std::string lines :
      {"l 1 2 3 4", "l 1 2 3 4 1", "l 1 2 2 3 4", "l 1 2 2 3 4 1", "l 1 2 3 4 4", "l 1 2 3 4 1 1",
       "l 1 2 3 4\nl 2 3", "l 1 2 3 4 1\nl 1 4", "l 1 2 3 4 1 2", "l 1 1 2\nl 3 4\nl 3 2 2"}) {
    const Network closed = read_with_closure("a.obj", square + lines, Closure::CLOSED);
    EXPECT_EQ(closed.number_of_nodes(), 4u) << lines;
    EXPECT_EQ(closed.number_of_edges(), 4u) << lines;
    const Network open = read_with_closure("a.obj", square + lines, Closure::OPEN);
    EXPECT_EQ(open.number_of_nodes(), 4u) << lines;
    EXPECT_EQ(open.number_of_edges(), 3u) << lines;
  }
}

TEST(Reading, opens_curves_that_repeat_their_first_point_often)
{
  const std::string corners = " 0 0 0 1 0 0 1 1 0", origin = " 0 0 0";
  for(std::size_t repetitions = 1; repetitions < 4; ++repetitions) {
    std::string text = std::to_string(3 + repetitions) + corners;
    for(std::size_t i = 0; i < repetitions; ++i) text += origin;
    const Network open = read_with_closure("a.polylines.txt", text, Closure::OPEN);
    EXPECT_EQ(open.number_of_nodes(), 3u);
    EXPECT_EQ(open.number_of_edges(), 2u);
  }
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

// The reader of polylines gives the same result as the constructor.
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
