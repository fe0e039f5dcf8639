// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "brute_force_curve.h"

#include <CGAL/Volume_filling_curves/IO/polylines.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Volume_filling_curves;
namespace fs = std::filesystem;

using Kind = Curve_defect_kind;
using Nodes = std::vector<std::size_t>;
using Network = Curve_network_3<>;

std::vector<Curve_defect> check(internal::Curve_file file, Junctions junctions)
{
  Network network;
  std::vector<Curve_defect> defects;
  internal::make_network(file, network, defects, junctions);
  return defects;
}

std::vector<Curve_defect> check_obj(const std::string& text,
                                    Junctions junctions = Junctions::FORBIDDEN)
{
  return check(internal::read_obj(text, junctions), junctions);
}

std::vector<Curve_defect> check_txt(const std::string& text,
                                    Junctions junctions = Junctions::FORBIDDEN)
{
  return check(internal::read_polylines_txt(text, junctions), junctions);
}

bool has_error(const std::vector<Curve_defect>& defects)
{
  return std::any_of(defects.begin(), defects.end(),
                     [](const Curve_defect& defect) { return is_error(defect.kind); });
}

bool has(const std::vector<Curve_defect>& defects, Kind kind)
{
  return std::any_of(defects.begin(), defects.end(),
                     [&](const Curve_defect& defect) { return defect.kind == kind; });
}

void expect_only(const std::vector<Curve_defect>& defects,
                 Kind kind,
                 std::size_t line,
                 const Nodes& nodes)
{
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, kind) << to_string(defects[0].kind);
  EXPECT_EQ(defects[0].line, line);
  EXPECT_EQ(defects[0].nodes, nodes);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Coordinates, that_cannot_be_read_name_line_and_node)
{
  const std::string rest = "v 1 1 1\nl 1 2 3\n";
  expect_only(check_obj("v 0 0 0\nv 1 nan 0\n" + rest), Kind::NON_FINITE_COORDINATE, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 0 -inf\n" + rest), Kind::NON_FINITE_COORDINATE, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 0 1e400\n" + rest), Kind::NON_FINITE_COORDINATE, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 0 2e150\n" + rest), Kind::COORDINATE_TOO_LARGE, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 x 0\n" + rest), Kind::UNPARSABLE_NUMBER, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 0,5 0\n" + rest), Kind::UNPARSABLE_NUMBER, 2, {2});
  expect_only(check_obj("v 0 0 0\nv 1 0\n" + rest), Kind::MISSING_COORDINATES, 2, {2});
  expect_only(check_txt("3 0 0 0 1 0 x\n1 1 1"), Kind::UNPARSABLE_NUMBER, 1, {2});
}

TEST(Coordinates, are_all_listed)
{
  const auto defects = check_obj("v 0 0\nv nan 0 0\nv 0 0 0\nv 2 0 0\nv 1 0 0\nl 1 2\nl 3 4 5\n");
  ASSERT_EQ(defects.size(), 3u);
  EXPECT_EQ(defects[0].kind, Kind::MISSING_COORDINATES);
  EXPECT_EQ(defects[1].kind, Kind::NON_FINITE_COORDINATE);
  EXPECT_EQ(defects[2].kind, Kind::SELF_CONTACT);
}

TEST(Indices, that_mean_nothing_name_the_line)
{
  for(const std::string index : {"0", "5", "-5", "two", "1.5", "2x", "/1", "99999999999999999999"})
    expect_only(check_obj(square + "\nl 1 2 " + index + " 4\n"), Kind::BAD_INDEX, 6, {});
  expect_only(check_obj(square + "l 1 2 3 4 1\nfixed 7\n"), Kind::BAD_INDEX, 6, {});
  expect_only(check_obj(square + "l 1 2 3 4 1\nl 1\n"), Kind::SHORT_LINE, 6, {});
}

TEST(Files, without_a_curve_are_errors)
{
  expect_only(check_obj(""), Kind::NO_GEOMETRY, 1, {});
  expect_only(check_obj("# nothing\n"), Kind::NO_GEOMETRY, 2, {});
  expect_only(check_txt("# nothing"), Kind::NO_GEOMETRY, 1, {});
  expect_only(check_obj(square + "f 1 2 3\nf 1 3 4\n"), Kind::FACES_ONLY, 5, {});
  const auto defects = check_txt("1 0 0 0\n1 1 0 0\n");
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[1].kind, Kind::NO_GEOMETRY);
}

TEST(Files, with_binary_data_name_the_line)
{
  const std::string tail = std::string("v 1 \x01 2\n") + '\0';
  expect_only(check_obj(square + tail), Kind::BINARY_DATA, 5, {});
  expect_only(check_txt("1 0 0 0\r\n1 2 \x7f 3"), Kind::BINARY_DATA, 2, {});
  const std::string utf16("\xFF\xFEv\0 \0", 6);
  expect_only(check_obj(utf16), Kind::BINARY_DATA, 1, {});
  EXPECT_TRUE(has(check_obj(square + "\xFF\xD8 x\n"), Kind::BINARY_DATA));
}

TEST(Files, with_unknown_records_are_warned_of_once)
{
  const auto defects = check_obj(square + "l 1 2 3 4 1\nline 1 2\nline 2 3\n");
  expect_only(defects, Kind::UNKNOWN_RECORD, 6, {});
  EXPECT_FALSE(has_error(defects));
}

TEST(Messages, look_like_those_of_a_compiler)
{
  const auto defects = check_obj(square + "l 1 2 3 4 1\nl 1 2\n");
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(to_string(defects[0], "a.obj"),
            "a.obj:6: warning: duplicate edge: an edge is given again and is dropped (nodes 1 2)");
  EXPECT_EQ(to_string({Kind::UNREADABLE_FILE, "no"}, "b"), "b: error: unreadable file: no");
}

TEST(Messages, quote_in_printable_ascii)
{
  const auto defects = check_obj("v 0 0 \xC3\xA4" + std::string(100, 'x') + "\nl 1 1\n");
  ASSERT_FALSE(defects.empty());
  EXPECT_EQ(defects[0].message, "'??" + std::string(38, 'x') + "...' is not a number");
}

TEST(Lists, stay_short)
{
  std::string text;
  for(int i = 0; i < 5000; ++i) text += "v x\n";
  const auto defects = check_obj(text + square + "l -1 -2 -3 -4 -1\n");
  ASSERT_EQ(defects.size(), 1001u);
  EXPECT_EQ(defects.back().message, "5000 of this kind in total, the first 1000 are listed");
}

TEST(Repair, merges_coincident_nodes_with_a_warning)
{
  const auto defects = check_obj(square + "v 0 1 -0\nl 1 2 3 4 5 1\n");
  EXPECT_FALSE(has_error(defects));
  expect_only(defects, Kind::COINCIDENT_NODES, 5, {4, 5});
  EXPECT_FALSE(has_error(check_obj(square + "v 0 0 0\nl 1 2 3 4 5 1\n")));
  EXPECT_FALSE(has_error(check_obj(square + "l 1 1 2 2 2 3 4 4 1 1\n")));
}

TEST(Repair, drops_edges_that_are_given_again)
{
  expect_only(check_obj(square + "l 1 2 3 4 1 2\n"), Kind::DUPLICATE_EDGE, 5, {1, 2});
  expect_only(check_obj(square + "l 1 2 3 4 1\nl 4 3\n"), Kind::DUPLICATE_EDGE, 6, {4, 3});
  EXPECT_FALSE(has_error(check_obj(square + "l 1 2 3 4 1 2 3 4 1\n")));
}

TEST(Repair, ignores_vertices_without_edges)
{
  expect_only(check_obj("v 7 7 7\n" + square + "v 8 8 8\nl 2 3 4 5 2\n"), Kind::ISOLATED_VERTEX, 1,
              {1, 6});
}

TEST(Repair, must_not_change_a_loop_into_an_arc)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 0 0 0\n";
  for(const std::string lines : {"l 1 2 1", "l 1 2 3 1", "l 1 2 3 4 1", "l 1 2\nl 2 3\nl 3 1",
                                 "l 1 2 2 1", "l 1 4 1", "l 1 1", "l 1 4", "l 2 3\nl 3 2"}) {
    const auto defects = check_obj(points + lines + "\n");
    EXPECT_TRUE(has(defects, Kind::DEGENERATE_LOOP)) << lines;
  }
  EXPECT_TRUE(has(check_obj("v 1 2 3\n"), Kind::DEGENERATE_LOOP));
  EXPECT_TRUE(has(check_obj("v 1 2 3\nv 2 3 4\n"), Kind::DEGENERATE_LOOP));
  EXPECT_TRUE(has(check_txt("2 0 0 0 0 0 0"), Kind::DEGENERATE_LOOP));
  EXPECT_TRUE(has(check_txt("3 0 0 0 1 0 0 0 0 0"), Kind::DEGENERATE_LOOP));
}

TEST(Repair, does_not_hide_a_line_that_runs_straight_back)
{
  for(const std::string line : {"l 1 2 3 2", "l 1 2 3 4 3 2 1", "l 1 2 3 3 2 4"})
    EXPECT_TRUE(has(check_obj(square + line), Kind::SELF_CONTACT)) << line;
}

TEST(Edges, that_are_almost_points_are_warned_of)
{
  const auto defects = check_obj("v 0 0 0\nv 1 0 0\nv 1 1e-13 0\nv 0 1 0\nl 1 2 3 4 1\n");
  EXPECT_FALSE(has_error(defects));
  expect_only(defects, Kind::NEARLY_COINCIDENT_NODES, 3, {2, 3});
}

TEST(Size, that_underflows_is_an_error)
{
  EXPECT_TRUE(
      has(check_obj("v 0 0 0\nv 9e-151 0 0\nv 0 9e-151 0\nl 1 2 3 1"), Kind::SIZE_TOO_SMALL));
  EXPECT_FALSE(has_error(check_obj("v 0 0 0\nv 2e-150 0 0\nv 0 2e-150 0\nl 1 2 3 1")));
  EXPECT_FALSE(has_error(check_obj("v 1e150 0 0\nv 0 -1e150 0\nv 0 0 1e150\nl 1 2 3 1")));
}

TEST(Junctions, are_errors_unless_allowed)
{
  const std::string figure_eight =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 1 0\nl 1 2 3 1\nl 1 4 5 1\n";
  expect_only(check_obj(figure_eight), Kind::JUNCTION, 7, {1});
  EXPECT_TRUE(check_obj(figure_eight, Junctions::ALLOWED).empty());
  const std::string tee = square + "v 2 2 2\nl 1 2 3 4 1\nl 2 5\n";
  expect_only(check_obj(tee), Kind::JUNCTION, 7, {2});
  EXPECT_TRUE(check_obj(tee, Junctions::ALLOWED).empty());
}

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
    number_of_embedded += expected.empty();
  }
  EXPECT_GT(number_of_embedded, 300);
  EXPECT_LT(number_of_embedded, 2700);
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
    internal::Curve_file file =
        internal::read_obj(text + line + (is_closed ? " 1" : ""), Junctions::FORBIDDEN);
    Network network;
    std::vector<Curve_defect> defects;
    const bool is_accepted = internal::make_network(file, network, defects, Junctions::FORBIDDEN);
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

TEST(Components, are_numbered_from_one_in_the_order_of_their_first_edges)
{
  const auto defects = check_obj("v 0 0 0\nv 4 0 0\nv 0 0 5\nv 4 0 5\nv 2 0 5\nl 1 2\nl 3 4 5\n");
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].component, 2u);
}

#ifdef VFC_SHARED_DATA

const fs::path shared_data = VFC_SHARED_DATA;

// The cells of a line of a CSV file; cells in quotes may contain commas.
std::vector<std::string> cells(const std::string& line)
{
  std::vector<std::string> result(1);
  bool is_quoted = false;
  for(const char c : line) {
    if(c == '"')
      is_quoted = !is_quoted;
    else if(c == ',' && !is_quoted)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

void expect(const std::vector<Curve_defect>& defects,
            bool is_accepted,
            const std::string& what,
            const std::string& expected)
{
  if(contains(expected, "or reject")) return;
  EXPECT_EQ(is_accepted, contains(expected, "accept"));
  EXPECT_EQ(is_accepted && !defects.empty(), contains(expected, "warning"));
  if(is_accepted) return;
  const auto error = std::find_if(defects.begin(), defects.end(),
                                  [](const Curve_defect& defect) { return is_error(defect.kind); });
  ASSERT_NE(error, defects.end());
  EXPECT_FALSE(error->message.empty());
  EXPECT_TRUE(error->line > 0 || !contains(expected, "with line number"));
  EXPECT_TRUE(error->line == 8 || !contains(what, "on line 8"));
  for(const auto& [part, kind] :
      {std::pair("self-contact", Kind::SELF_CONTACT), std::pair("(junction)", Kind::JUNCTION),
       std::pair("beyond 1e150", Kind::COORDINATE_TOO_LARGE),
       std::pair("below 1e-150", Kind::SIZE_TOO_SMALL)})
    EXPECT_TRUE(has(defects, kind) || !contains(expected, part)) << part;
}

TEST(Shared_data, bad_curves_get_what_their_manifest_says)
{
  std::ifstream manifest(shared_data / "MANIFEST_bad_curves.csv");
  if(!manifest) GTEST_SKIP() << "the shared data are absent";
  std::string line;
  std::getline(manifest, line);
  std::size_t count = 0;
  for(; std::getline(manifest, line); ++count) {
    const std::vector<std::string> row = cells(line);
    SCOPED_TRACE(row.at(0) + ": " + row.at(2));
    Network network;
    std::vector<Curve_defect> defects;
    const bool is_accepted =
        CGAL::IO::read_curve_network((shared_data / row[0]).string(), network, defects);
    expect(defects, is_accepted, row[1], row[2]);
  }
  EXPECT_GT(count, 40u);
}

TEST(Shared_data, valid_curves_have_no_defects)
{
  if(!fs::exists(shared_data)) GTEST_SKIP() << "the shared data are absent";
  for(const std::string folder :
      {"knot128", "trefoil100", "trefoil_hard", "paper", "links", "open_arcs", "hard_unknots"}) {
    if(!fs::exists(shared_data / folder)) continue;
    for(const auto& entry : fs::directory_iterator(shared_data / folder)) {
      Network network;
      std::vector<Curve_defect> defects;
      EXPECT_TRUE(CGAL::IO::read_curve_network(entry.path().string(), network, defects));
      EXPECT_TRUE(defects.empty()) << to_string(defects.front(), entry.path().string());
    }
  }
}

#endif

} // namespace
