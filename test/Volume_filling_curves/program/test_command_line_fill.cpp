// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The command vfc fill.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace test_command_line_fill {

using program_test::Finished;
using program_test::Json;

class Command_line_fill : public program_test::Program_test
{
protected:
  // a cube with sides of 4
  void make_cube() const
  {
    write("cube.off", "OFF\n8 12 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 4\n4 0 4\n4 4 4\n0 4 4\n"
                      "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                      "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  }

  // two ports
  void make_arc() const { write("arc.obj", "v 0.5 2 2\nv 3.5 2 2\nl 1 2\n"); }
};

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

TEST_F(Command_line_fill, default_thickness_is_told)
{
  make_cube();
  EXPECT_NE(run("fill cube.off -o c.obj --max-iterations 1").err.find("thickness 0.4"),
            std::string::npos);
}

TEST_F(Command_line_fill, length_can_be_asked_for)
{
  make_cube();
  ASSERT_EQ(run("fill cube.off --length 60 --report r.json").status, 0);
  EXPECT_NEAR(json("r.json")["length_end"], 60, 1.2);
}

TEST_F(Command_line_fill, a_curve_with_ends_goes_from_port_to_port)
{
  make_cube();
  make_arc();
  run("fill cube.off --curve arc.obj -o c.obj --map map.txt --thickness 0.6 --max-iterations 50");
  EXPECT_EQ(points("c.obj").front(), points("arc.obj").front());
  EXPECT_EQ(points("c.obj").back(), points("arc.obj").back());
  EXPECT_EQ(read("map.txt").substr(0, 2), "1\n");
}

TEST_F(Command_line_fill, ports_make_arcs_with_straight_necks)
{
  make_cube();
  const Finished fill = run("fill cube.off --port 0,2,2 --port 4,1,3,-1,0.5,0 --thickness 0.6 "
                            "--report r.json -o c.obj --certificate c.cert");
  ASSERT_EQ(fill.status, 0) << fill.err;
  EXPECT_EQ(run("check --certificate c.cert c.cert.start.obj c.obj --domain cube.off").status, 0);
  const Json ports = json("r.json")["ports"];
  ASSERT_EQ(ports.size(), 2u);
  EXPECT_EQ(ports[1]["point"], Json::array({4., 1., 3.}));
  EXPECT_NEAR(ports[1]["direction"][0], -std::sqrt(0.8), 1e-12);
  for(const Json& port : ports) {
    EXPECT_NEAR(port["neck"], 0.6, 1e-9);
    EXPECT_EQ(port["is_free"], true);
  }
  const std::string again = run("fill cube.off --port 0,2,2 --port 4,1,3 -o d.obj "
                                "--thickness 0.6 --max-iterations 3")
                                .out;
  EXPECT_NE(again.find("necks: 0.6, 0.6\n"), std::string::npos) << again;
}

TEST_F(Command_line_fill, arcs_divide_the_volume_by_their_shares)
{
  make_cube();
  const std::string fill = "fill cube.off --thickness 0.5 --preview -o c.obj --port 0,1,2 "
                           "--port 4,1,2 --port 0,3,2 --port 4,3,2 --volume-shares ";
  ASSERT_EQ(run(fill + "1,3").status, 0);
  const std::string curve = read("c.obj");
  const std::size_t second = curve.rfind("\nl ");
  EXPECT_GT(curve.size() - second, 2 * (second - curve.find("\nl "))) << "lines of node numbers";
  for(const std::string wrong : {"1", "1,2,3", "1,0", "1,-2", "1,x", "1,inf", "1,,2", "1,2,", "''"})
    EXPECT_NE(run(fill + wrong + " --force").err.find("shares"), std::string::npos) << wrong;
}

TEST_F(Command_line_fill, ports_that_make_no_sense_are_refused)
{
  make_cube();
  make_arc();
  for(const std::string wrong :
      {"--port 0,2,2", "--port 0,2 --port 4,2,2", "--port 0,2,2,1 --port 4,2,2",
       "--port 0,2,2 --port 4,2,2 --curve arc.obj", "--port 2,2,2 --port 4,2,2"}) {
    const Finished refused = run("fill cube.off --thickness 0.6 -o c.obj " + wrong);
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_NE(refused.err.find("port"), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("c.obj"));
  }
}

TEST_F(Command_line_fill, a_start_outside_is_invalid_input)
{
  make_cube();
  write("out.obj", "v 1 1 2\nv 5 1 2\nv 3 3 2\nl 1 2 3 1\n");
  EXPECT_EQ(run("fill cube.off --curve out.obj --report r.json").status, 4);
  EXPECT_EQ(json("r.json")["error"]["file"], "out.obj");
  EXPECT_EQ(json("r.json")["error"]["nodes"], Json::array({2}));
}

TEST_F(Command_line_fill, thickness_may_vary)
{
  make_cube();
  write("r.csv", "thickness\n0.4\n0.8\n0.8\n0.4\n0.4\n0.8\n0.8\n0.4\n");
  run("fill cube.off --thickness-field r.csv --report a.json -o a.obj --max-iterations 60");
  EXPECT_GT(json("a.json")["thickness"], 0.4);
  EXPECT_LT(json("a.json")["thickness"], 0.8);
  write("r.ply", "ply\nformat ascii 1.0\nelement vertex 8\nproperty double thickness\nend_header\n"
                 "0.4\n0.8\n0.8\n0.4\n0.4\n0.8\n0.8\n0.4\n");
  run("fill cube.off --thickness-field r.ply -o b.obj --max-iterations 60");
  EXPECT_EQ(read("a.obj"), read("b.obj"));
}

TEST_F(Command_line_fill, bad_values_of_the_thickness_are_named)
{
  make_cube();
  const auto expect_refused = [&](const std::string& text, const std::string& message) {
    write("r.csv", text);
    const Finished fill = run("fill cube.off -o c.obj --thickness-field r.csv");
    EXPECT_EQ(fill.status, 4) << text;
    EXPECT_NE(fill.err.find(message), std::string::npos) << fill.err;
  };
  expect_refused("0.4\n0.8\n", "2 values for 8 vertices");
  expect_refused("thickness\n0.4\nhello\n", "r.csv:3: error");
  expect_refused("1\n1\n1\n1\n1\n1\n1\n-1\n", "r.csv:8: error");
  EXPECT_EQ(run("fill cube.off -o c.obj --thickness-field missing.csv").status, 4);
}

TEST_F(Command_line_fill, strands_follow_a_direction_field)
{
  make_cube();
  const std::string fill = "fill cube.off --thickness 0.5 --max-iterations 12 ";
  run(fill + "--report none.json -o none.obj");
  EXPECT_TRUE(json("none.json")["alignment"].is_null());
  run(fill + "--direction-field 0,0,1 --report z.json -o z.obj");
  EXPECT_GT(json("z.json")["alignment"], 0.5);
  std::string csv = "x,y,z\n", ply = "ply\nformat ascii 1.0\nelement vertex 8\n"
                                     "property double direction_x\nproperty double direction_y\n"
                                     "property double direction_z\nend_header\n";
  for(int v = 0; v < 8; ++v) {
    csv += v % 2 == 0 ? "0, 0, -1\n" : "0;0;2\n";
    ply += v % 2 == 0 ? "0 0 -1\n" : "0 0 2\n";
  }
  write("d.csv", csv);
  write("d.ply", ply);
  run(fill + "--direction-field d.csv -o csv.obj");
  run(fill + "--direction-field d.ply -o ply.obj");
  EXPECT_EQ(read("csv.obj"), read("ply.obj"));
  EXPECT_EQ(read("csv.obj"), read("z.obj"));
}

TEST_F(Command_line_fill, bad_direction_fields_are_named)
{
  make_cube();
  const auto expect_refused = [&](const std::string& text, const std::string& message) {
    write("d.csv", text);
    const Finished fill = run("fill cube.off -o c.obj --direction-field d.csv");
    EXPECT_EQ(fill.status, 4) << text;
    EXPECT_NE(fill.err.find(message), std::string::npos) << fill.err;
  };
  expect_refused("1,0,0\n0,1,0\n", "2 values for 8 vertices");
  expect_refused("x,y,z\n1,0,0\n1,0\n", "d.csv:3: error");
  expect_refused("x,y,z\n1,0,0\n1,0,inf\n", "d.csv:3: error");
  EXPECT_EQ(run("fill cube.off -o c.obj --direction-field missing.csv").status, 4);
  EXPECT_EQ(run("fill cube.off -o c.obj --direction-weight 1").status, 1) << "there is no field";
}

TEST_F(Command_line_fill, a_preview_is_not_rounded)
{
  make_cube();
  const std::string fill = "fill cube.off --thickness 1 --preview -o x.obj ";
  EXPECT_EQ(run(fill).status, 0);
  for(const std::string rounding : {"--finish", "--bend-radius 1", "--strand-distance 1"}) {
    const Finished refused = run(fill + "--force " + rounding);
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("--preview excludes --"), std::string::npos) << refused.err;
  }
}

TEST_F(Command_line_fill, nonsense_is_refused_before_it_eats_the_memory)
{
  make_cube();
  for(const std::string options :
      {"--thickness 1e-6", "--thickness 1e300", "--length 1e30", "--thickness 0.5 --spacing 1e-9"})
    EXPECT_EQ(run("fill cube.off -o c.obj " + options).status, 1) << options;
  EXPECT_EQ(
      run("fill cube.off -o c.obj --thickness 1e-6 --bend-radius 0.6 --max-iterations 1").status, 2)
      << "the bends need a thickness of 0.6";
}

TEST_F(Command_line_fill, options_with_too_small_or_too_large_lengths_are_named_as_given)
{
  make_cube();
  const auto expect_named = [&](const std::string& options, const std::string& named) {
    const Finished fill = run("fill cube.off -o c.obj " + options);
    EXPECT_EQ(fill.status, 1) << options;
    EXPECT_NE(fill.err.find(": " + named), std::string::npos) << fill.err;
  };
  expect_named("--thickness 1e-6", "--thickness 1e-06 and --spacing 0.2: there would be more than");
  expect_named("--thickness 1e-6 --bend-radius 1e-5",
               "--thickness 1e-06, --bend-radius 1e-05 and --spacing");
  expect_named("--thickness 1e-5 --strand-distance 1e-6",
               "--thickness 1e-05, --strand-distance 1e-06 and --spacing");
  expect_named("--length 1e30 --bend-radius 1e-5", "--length 1e+30 and --spacing");
  expect_named("--thickness 7 --bend-radius 1", "--thickness 7 is larger than the mesh");
  expect_named("--thickness 1 --bend-radius 7", "--bend-radius 7 is larger than the mesh");
  expect_named("--strand-distance 7", "--strand-distance 7 is larger than the mesh");
}

TEST_F(Command_line_fill, the_mesh_is_never_replaced)
{
  make_cube();
  const std::string before = read("cube.off");
  for(const std::string option : {"--report cube.off", "--map cube.off"})
    EXPECT_EQ(run("fill cube.off --force --max-iterations 1 " + option).status, 1) << option;
  EXPECT_EQ(read("cube.off"), before);
}

} // namespace test_command_line_fill

#endif // json.hpp
