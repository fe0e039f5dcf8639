// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/csv_cells.h"
#include "support/curve_defects_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace test_curve_defects {

using namespace curve_defects_test;
namespace fs = std::filesystem;

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
  const std::string ray = std::string("v 1 \x01 2\n") + '\0';
  expect_only(check_obj(square + ray), Kind::BINARY_DATA, 5, {});
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

TEST(Curve_repair, merges_coincident_nodes_with_a_warning)
{
  const auto defects = check_obj(square + "v 0 1 -0\nl 1 2 3 4 5 1\n");
  EXPECT_FALSE(has_error(defects));
  expect_only(defects, Kind::COINCIDENT_NODES, 5, {4, 5});
  EXPECT_FALSE(has_error(check_obj(square + "v 0 0 0\nl 1 2 3 4 5 1\n")));
  EXPECT_FALSE(has_error(check_obj(square + "l 1 1 2 2 2 3 4 4 1 1\n")));
}

TEST(Curve_repair, drops_edges_that_are_given_again)
{
  expect_only(check_obj(square + "l 1 2 3 4 1 2\n"), Kind::DUPLICATE_EDGE, 5, {1, 2});
  expect_only(check_obj(square + "l 1 2 3 4 1\nl 4 3\n"), Kind::DUPLICATE_EDGE, 6, {4, 3});
  EXPECT_FALSE(has_error(check_obj(square + "l 1 2 3 4 1 2 3 4 1\n")));
}

TEST(Curve_repair, ignores_vertices_without_edges)
{
  expect_only(check_obj("v 7 7 7\n" + square + "v 8 8 8\nl 2 3 4 5 2\n"), Kind::ISOLATED_VERTEX, 1,
              {1, 6});
}

TEST(Curve_repair, must_not_change_a_loop_into_an_arc)
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

TEST(Curve_repair, does_not_hide_a_line_that_runs_straight_back)
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

TEST(Components, are_numbered_from_one_in_the_order_of_their_first_edges)
{
  const auto defects = check_obj("v 0 0 0\nv 4 0 0\nv 0 0 5\nv 4 0 5\nv 2 0 5\nl 1 2\nl 3 4 5\n");
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].component, 2u);
}

#ifdef VFC_SHARED_DATA

const fs::path shared_data = VFC_SHARED_DATA;

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
    const std::vector<std::string> row = csv_cells(line);
    SCOPED_TRACE(row.at(0) + ": " + row.at(2));
    Network network;
    std::vector<Curve_defect> defects;
    const bool is_accepted =
        CGAL::IO::read_embedded_curve_network((shared_data / row[0]).string(), network, defects);
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
      EXPECT_TRUE(CGAL::IO::read_embedded_curve_network(entry.path().string(), network, defects));
      EXPECT_TRUE(defects.empty()) << to_string(defects.front(), entry.path().string());
    }
  }
}

#endif

} // namespace test_curve_defects
