// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Surfaces in the program vfc.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/command_line_meshes_test_support.h"
#include "support/csv_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_command_line_meshes {

using namespace command_line_meshes_test;
using program_test::Finished;

TEST_F(Command_line_meshes, check_judges_meshes_as_the_manifest_says)
{
  std::istringstream lines(read(VFC_SHARED_DATA "/MANIFEST_domains.csv"));
  std::string line;
  if(!std::getline(lines, line)) GTEST_SKIP() << "no " VFC_SHARED_DATA "/MANIFEST_domains.csv";
  std::size_t count = 0;
  for(; std::getline(lines, line); ++count) {
    const std::vector<std::string> row = csv_cells(line);
    const std::string& expected = row.at(19);
    SCOPED_TRACE(row[0] + ": " + expected);
    const bool is_accepted = expected.compare(0, 6, "accept") == 0;
    const Finished checked =
        run("check '" VFC_SHARED_DATA "/" + row[0] + "' --report r.json --force");
    EXPECT_EQ(checked.status, is_accepted ? 0 : 4);
    const Json defects = json("r.json")["defects"];
    EXPECT_EQ(static_cast<std::size_t>(std::count(checked.out.begin(), checked.out.end(), '\n')),
              defects.size());
    const bool is_silent = is_accepted && expected.find("warning") == std::string::npos;
    EXPECT_EQ(defects.empty(), is_silent) << checked.out;
  }
  EXPECT_GE(count, 20u);
}

TEST_F(Command_line_meshes, check_tells_curves_from_surfaces_by_what_an_obj_file_holds)
{
  make_files();
  EXPECT_EQ(run("check cube.obj").status, 0);
  EXPECT_EQ(run("check square.obj").status, 0);
  write("both.obj", read("square.obj") + "f 1 2 3\n");
  EXPECT_EQ(run("check both.obj").status, 0) << "lines make it a curve";
  write("open.obj", cube_vertices + "f 1 3 2\n");
  EXPECT_EQ(run("check open.obj --report r.json").status, 4);
  EXPECT_EQ(kinds("r.json").back(), "open boundary");
  EXPECT_EQ(run("check cube.obj cube.obj").status, 1);
}

TEST_F(Command_line_meshes, check_finds_where_a_curve_leaves_a_surface)
{
  make_files();
  EXPECT_EQ(run("check square.obj cube.obj --report in.json").status, 0);
  EXPECT_EQ(json("in.json")["outside_segments"], 0);
  write("out.obj", "v 1 1 2\nv 5 1 2\nv 3 3 2\nl 1 2 3 1\n");
  const Finished out = run("check out.obj cube.obj --report out.json");
  EXPECT_EQ(out.status, 4);
  EXPECT_EQ(json("out.json")["outside_nodes"], 1);
  EXPECT_EQ(json("out.json")["outside_segments"], 2);
  EXPECT_EQ(json("out.json")["defects"][0]["nodes"], Json::array({2}));
  EXPECT_EQ(kinds("out.json"),
            std::vector<std::string>({"outside node", "outside segment", "outside segment"}));
  EXPECT_NE(out.out.find("out.obj: error: outside node: "), std::string::npos) << out.out;
}

TEST_F(Command_line_meshes, a_curve_that_touches_the_surface_is_outside)
{
  make_files();
  write("touch.obj", "v 1 1 2\nv 4 1 2\nv 3 3 2\nl 1 2 3 1\n");
  EXPECT_EQ(run("check touch.obj cube.obj --report r.json").status, 4);
  EXPECT_EQ(json("r.json")["outside_nodes"], 1);
  EXPECT_EQ(json("r.json")["outside_segments"], 2);
}

TEST_F(Command_line_meshes, hints_tell_a_curve_from_a_surface)
{
  make_files();
  EXPECT_NE(run("fill square.obj -o x.obj").err.find("it holds a curve"), std::string::npos);
  EXPECT_NE(run("simplify cube.obj -o x.obj").err.find("it holds a surface"), std::string::npos);
}

TEST_F(Command_line_meshes, measure_tells_how_a_curve_fills_a_surface)
{
  make_files();
  ASSERT_EQ(run("measure square.obj cube.obj --thickness 0.5 --report r.json").status, 0);
  const Json report = json("r.json"), coverage = report["coverage"];
  EXPECT_EQ(report["outside_nodes"], 0);
  EXPECT_EQ(report["outside_segments"], 0);
  EXPECT_GE(coverage["samples"], 20000);
  for(const char* key : {"mean", "p50", "p95", "p99", "max", "fraction_within_r"})
    EXPECT_GT(coverage[key], 0) << key;
  EXPECT_LE(coverage["max"], 2 * std::sqrt(6.)) << "the corners are farthest";
  EXPECT_GT(coverage["max"], 4.5);
  ASSERT_FALSE(report["empty_regions"].empty());
  EXPECT_EQ(report["empty_regions"][0]["point"].size(), 3u);
  EXPECT_GT(report["empty_regions"][0]["volume"], 0);
}

TEST_F(Command_line_meshes, measure_without_a_thickness_gives_lengths)
{
  make_files();
  ASSERT_EQ(run("measure square.obj cube.obj --report a.json").status, 0);
  ASSERT_EQ(run("measure square.obj cube.obj --thickness 0.5 --report b.json").status, 0);
  const Json a = json("a.json"), b = json("b.json");
  EXPECT_NEAR(a["coverage"]["mean"], 0.5 * b["coverage"]["mean"].get<double>(), 1e-12);
  EXPECT_TRUE(a["coverage"]["fraction_within_r"].is_null());
  EXPECT_TRUE(a["empty_regions"].is_null());
}

TEST_F(Command_line_meshes, pictures_show_curve_and_surface)
{
  make_files();
  ASSERT_EQ(run("draw square.obj cube.obj -o a.svg").status, 0);
  EXPECT_NE(read("a.svg").find("#e9eef4"), std::string::npos);
  ASSERT_EQ(run("draw square.obj cube.obj -o a.png").status, 0);
  EXPECT_EQ(read("a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(run("draw square.obj square.obj -o b.png").status, 4) << "no surface";
}

TEST_F(Command_line_meshes, bad_meshes_are_refused_by_every_command)
{
  make_files();
  write("open.obj", cube_vertices + "f 1 3 2\n");
  for(const std::string command : {"check square.obj open.obj", "measure square.obj open.obj",
                                   "draw square.obj open.obj -o x.png"}) {
    const Finished bad = run(command + " --report r.json --force");
    EXPECT_EQ(bad.status, 4) << command;
    EXPECT_EQ(json("r.json")["error"]["file"], "open.obj") << command;
  }
  EXPECT_FALSE(exists("x.png"));
}

TEST_F(Command_line_meshes, convert_tells_the_order_of_the_vertices_of_stl)
{
  write("t.stl", "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\n"
                 "vertex 1 0 0\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\n"
                 "vertex 0 1 0\nvertex 0 0 0\nvertex 0 0 2\nendloop\nendfacet\nendsolid t\n");
  EXPECT_EQ(run("convert t.stl t.ply").status, 0);
  EXPECT_NE(read("t.ply").find("end_header\n0 0 0\n0 1 0\n1 0 0\n0 0 2\n3 0 1 2\n3 1 0 3\n"),
            std::string::npos)
      << read("t.ply");
  EXPECT_EQ(run("convert t.stl -o t.obj").status, 0);
  EXPECT_EQ(run("convert t.stl").status, 1);
  EXPECT_EQ(run("convert t.stl a.obj -o b.obj").status, 1);
  EXPECT_EQ(run("convert t.stl a.stl").status, 1);
  EXPECT_EQ(run("convert t.stl a.obj --tube 1").status, 1);
}

} // namespace test_command_line_meshes

#endif // json.hpp
