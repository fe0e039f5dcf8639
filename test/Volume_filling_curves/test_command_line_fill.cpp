// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// What the program vfc fill does.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "program_test_support.h"

#include <array>
#include <string>
#include <vector>

namespace {

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

TEST_F(Command_line_fill, default_thickness_is_told)
{
  make_cube();
  EXPECT_NE(run("fill cube.off --max-iterations 1").err.find("thickness 0.4"), std::string::npos);
}

TEST_F(Command_line_fill, length_can_be_asked_for)
{
  make_cube();
  ASSERT_EQ(run("fill cube.off --length 40 --report r.json").status, 0);
  EXPECT_NEAR(json("r.json")["length_end"], 40, 0.8);
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
    const Finished fill = run("fill cube.off --thickness-field r.csv");
    EXPECT_EQ(fill.status, 4) << text;
    EXPECT_NE(fill.err.find(message), std::string::npos) << fill.err;
  };
  expect_refused("0.4\n0.8\n", "2 values for 8 vertices");
  expect_refused("thickness\n0.4\nhello\n", "r.csv:3: error");
  expect_refused("1\n1\n1\n1\n1\n1\n1\n-1\n", "r.csv:8: error");
  EXPECT_EQ(run("fill cube.off --thickness-field missing.csv").status, 4);
}

TEST_F(Command_line_fill, nonsense_is_refused_before_it_eats_the_memory)
{
  make_cube();
  for(const std::string options :
      {"--thickness 1e-6", "--thickness 1e300", "--length 1e30", "--thickness 0.5 --spacing 1e-9"})
    EXPECT_EQ(run("fill cube.off " + options).status, 1) << options;
}

TEST_F(Command_line_fill, the_mesh_is_never_replaced)
{
  make_cube();
  const std::string before = read("cube.off");
  for(const std::string option : {"--report cube.off", "--map cube.off"})
    EXPECT_EQ(run("fill cube.off --force --max-iterations 1 " + option).status, 1) << option;
  EXPECT_EQ(read("cube.off"), before);
}

} // namespace

#endif // json.hpp
