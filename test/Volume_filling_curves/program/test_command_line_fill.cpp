// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The results of the command vfc fill.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/command_line_fill_test_support.h"

#include <string>

namespace test_command_line_fill {

using command_line_fill_test::Command_line_fill;
using program_test::Finished;
using program_test::Json;

TEST_F(Command_line_fill, curve_stays_inside_and_covers)
{
  make_cube();
  const Finished fill =
      run("fill cube.off -o c.obj --thickness 0.6 --report r.json --max-iterations 200");
  ASSERT_TRUE(fill.status == 0 || fill.status == 2) << fill.err;
  EXPECT_EQ(run("check c.obj cube.off").status, 0);
  const Json report = json("r.json");
  EXPECT_EQ(report["input"], "cube.off");
  EXPECT_EQ(report["outside_nodes"], 0);
  EXPECT_EQ(report["outside_segments"], 0);
  EXPECT_EQ(report["thickness"], 0.6);
  EXPECT_GT(report["coverage"]["fraction_within_r"], 0.5);
  EXPECT_TRUE(report["empty_regions"].is_array());
  EXPECT_GT(report["medial_radius"], 0);
}

TEST_F(Command_line_fill, what_was_not_measured_is_null_and_a_dash)
{
  make_cube();
  const std::string fill = "fill cube.off --thickness 0.6 --report r.json --force ";
  for(const std::string limit : {"--time-limit 0 ", "--max-iterations 1 "}) {
    const std::string summary = run(fill + limit + "-o a.obj").out;
    const auto has = [&](const char* text) { return summary.find(text) != std::string::npos; };
    const Json report = json("r.json"), coverage = report["coverage"];
    EXPECT_EQ(report["empty_regions"].is_null(), has("empty regions -\n")) << limit;
    EXPECT_EQ(coverage["samples"] == 0, has("within r -,")) << limit;
    for(const char* key : {"mean", "p50", "p95", "p99", "max", "fraction_within_r"})
      EXPECT_EQ(coverage["samples"] == 0, coverage[key].is_null()) << limit << key;
  }
  EXPECT_TRUE(json("r.json")["empty_regions"].is_array()) << "there was time";
}

TEST_F(Command_line_fill, the_report_the_last_line_and_measure_have_the_least_distances)
{
  make_cube();
  const Finished fill = run("fill cube.off -o c.obj --thickness 0.6 --report r.json");
  EXPECT_NE(fill.out.find("\nbend radius 0."), std::string::npos) << fill.out;
  EXPECT_NE(fill.out.find(" away at the least; nearer than r "), std::string::npos) << fill.out;
  const Json filled = json("r.json");
  run("measure c.obj cube.off --thickness 0.6 --report m.json");
  const Json measured = json("m.json");
  for(const char* key : {"min_bend_radius", "min_strand_distance", "min_wall_distance"}) {
    EXPECT_GT(filled[key], 0.01) << key;
    EXPECT_NEAR(filled[key], measured[key], 1e-9) << key;
  }
  EXPECT_NEAR(filled["crowded_fraction"], measured["crowded_fraction"], 1e-9);
  for(const char* key : {"min_bend_point", "min_wall_point"})
    EXPECT_EQ(measured[key].size(), 3u) << key;
  EXPECT_EQ(measured["min_strand_points"].size(), 2u);
  run("measure c.obj --report n.json");
  for(const char* key : {"min_strand_distance", "min_wall_distance", "crowded_fraction"})
    EXPECT_TRUE(json("n.json")[key].is_null()) << key;
}

TEST_F(Command_line_fill, walls_are_not_called_thin_if_there_was_no_time_to_look)
{
  make_cube();
  const Finished fill =
      run("fill cube.off --thickness 0.6 --time-limit 0 -o a.obj --report r.json");
  EXPECT_EQ(fill.err.find("too thin"), std::string::npos) << fill.err;
  EXPECT_NE(fill.out.find("medial radius -,"), std::string::npos) << fill.out;
  EXPECT_TRUE(json("r.json")["medial_radius"].is_null());
  EXPECT_TRUE(json("r.json")["thin_fraction"].is_null());
  EXPECT_TRUE(json("r.json")["fitting_thickness"].is_null());
}

TEST_F(Command_line_fill, what_is_kept_clear_of_counts_in_the_share_of_the_whole)
{
  make_cube();
  const Finished fill =
      run("fill cube.off --thickness 0.6 --wall keep-clear -o c.obj --report r.json");
  const double whole = json("r.json")["uncovered_fraction"];
  EXPECT_GT(whole, 0.01);
  EXPECT_LE(json("r.json")["unfilled_fraction"], 0.01);
  EXPECT_NE(fill.out.find(" (apart from the boundary "), std::string::npos) << fill.out;
  run("measure c.obj cube.off --thickness 0.6 --report m.json");
  EXPECT_NEAR(json("m.json")["unfilled_fraction"], whole, 0.01);
}

TEST_F(Command_line_fill, keeps_a_distance_from_the_wall_that_check_verifies)
{
  make_cube();
  const Finished fill =
      run("fill cube.off -o c.obj --preview --thickness 0.6 --wall-distance 0.5 --report r.json");
  EXPECT_EQ(fill.status, 0) << fill.err;
  const double distance = json("r.json")["min_wall_distance"];
  EXPECT_GE(distance, 0.5);
  EXPECT_EQ(run("check c.obj cube.off --wall-distance 0.5").status, 0);
  const Finished nearer = run("check c.obj cube.off --wall-distance 2");
  EXPECT_EQ(nearer.status, 4);
  EXPECT_NE(nearer.out.find("near wall: an edge comes as near to the mesh as "), std::string::npos)
      << nearer.out;
  EXPECT_EQ(run("check c.obj --wall-distance 2").status, 1);
  const Finished replay = run("check --certificate c.cert c.obj c.obj --wall-distance 2");
  EXPECT_EQ(replay.status, 1);
  EXPECT_NE(replay.err.find("--wall-distance: is for FILE MESH"), std::string::npos) << replay.err;
  const Finished no_room = run("fill cube.off -o d.obj --thickness 0.6 --wall-distance 3");
  EXPECT_EQ(no_room.status, 1);
  EXPECT_NE(no_room.err.find("wall_distance is 3, but no point"), std::string::npos) << no_room.err;
}

// A run in the cube was not one in its lower half.
TEST_F(Command_line_fill, can_be_verified_to_have_stayed_inside)
{
  make_cube();
  write("half.off", "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  run("fill cube.off -o c.obj --certificate c.cert --thickness 0.6 --max-iterations 20");
  const std::string check = "check --certificate c.cert c.cert.start.obj c.obj";
  const std::string isotopic = "operations; c.obj is ambient isotopic to c.cert.start.obj";
  EXPECT_NE(run(check).out.find(isotopic + "\n"), std::string::npos);
  const Finished verified = run(check + " --domain cube.off");
  EXPECT_EQ(verified.status, 0);
  EXPECT_EQ(verified.out.substr(0, 10), "verified: ");
  EXPECT_NE(verified.out.find(isotopic + " and never left cube.off\n"), std::string::npos)
      << verified.out;
  const Finished rejected = run(check + " --domain half.off");
  EXPECT_EQ(rejected.status, 4);
  EXPECT_NE(rejected.out.find("domain"), std::string::npos) << rejected.out;
  EXPECT_EQ(run("check c.obj --domain cube.off").status, 1);
  // a file that would be overwritten
  EXPECT_EQ(run("fill cube.off --certificate c.cert").status, 1);
}

// A thickness that does not fit is reported before and after the run.
TEST_F(Command_line_fill, a_plate_that_is_too_thin_is_filled_in_part_only)
{
  write("plate.off", "OFF\n8 12 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 .1\n4 0 .1\n4 4 .1\n0 4 .1\n"
                     "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                     "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  const Finished fill = run("fill plate.off --preview --thickness 0.5 --report r.json");
  EXPECT_EQ(fill.status, 2);
  EXPECT_NE(fill.err.find("warning: the inside is too thin for the thickness 0.5 in 100 %"),
            std::string::npos)
      << fill.err;
  const Json report = json("r.json");
  EXPECT_EQ(report["status"], "partial");
  EXPECT_GT(report["unfilled_fraction"], 0.01);
  EXPECT_GT(report["thin_fraction"], 0.99);
  EXPECT_GT(report["fitting_thickness"], 0.03);
  EXPECT_LT(report["fitting_thickness"], 0.07);
  EXPECT_NE(report["reason"].get<std::string>().find("walls are too thin"), std::string::npos);
  EXPECT_EQ(report["parts"], 1);
  EXPECT_EQ(report["unreachable_parts"], 0);
}

TEST_F(Command_line_fill, parts_get_a_curve_each_and_the_certificate_starts_from_all)
{
  write("two.off", "OFF\n8 8 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n10 0 0\n14 0 0\n10 4 0\n10 0 4\n"
                   "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n");
  run("fill two.off -o c.obj --certificate c.cert --thickness 0.4 --max-iterations 10 "
      "--report r.json");
  EXPECT_EQ(json("r.json")["components"], 2);
  EXPECT_EQ(json("r.json")["parts"], 2);
  EXPECT_EQ(run("check --certificate c.cert c.cert.start.obj c.obj --domain two.off").status, 0);
}

TEST_F(Command_line_fill, untangling_stays_inside_of_a_domain)
{
  make_cube();
  write("loop.obj", "v 1 1 2\nv 3 1 2\nv 1.2 2.8 2.1\nv 3 3 1.9\nv 1 3 2\nl 1 2 3 4 5 1\n");
  const std::string untangle = "untangle loop.obj --domain ";
  ASSERT_EQ(run(untangle + "cube.off -o out.obj --certificate u.cert").status, 0);
  EXPECT_EQ(run("check --certificate u.cert loop.obj out.obj --domain cube.off").status, 0);
  EXPECT_EQ(run(untangle + "cube.off --strategy tighten").status, 1);
  write("far.obj", "v 1 1 2\nv 9 1 2\nv 1 3 2\nl 1 2 3 1\n");
  EXPECT_EQ(run("untangle far.obj -o x.obj --domain cube.off").status, 4);
}

} // namespace test_command_line_fill

#endif // json.hpp
