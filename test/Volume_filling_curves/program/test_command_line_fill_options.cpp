// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The options of the command vfc fill.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/command_line_fill_test_support.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace test_command_line_fill_options {

using command_line_fill_test::Command_line_fill;
using program_test::Finished;
using program_test::Json;

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

} // namespace test_command_line_fill_options

#endif // json.hpp
