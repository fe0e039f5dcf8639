// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// What the program vfc does with polygons in the plane.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <string>

namespace test_command_line_plane {

using program_test::Finished;
using program_test::Json;

class Command_line_plane : public program_test::Program_test
{
protected:
  // a plate of 3 x 2 with a hole, in several lines
  void make_plate() const
  {
    write("plate.wkt",
          "polygon ((0 0, 3 0,\n 3 2, 0 2, 0 0),\n (1 .5, 1 1.5, 2 1.5, 2 .5, 1 .5))\n");
  }

  bool has(const std::string& text, const std::string& part) const
  {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(Command_line_plane, fills_a_plate_in_the_plane)
{
  make_plate();
  const Finished fill = run("fill plate.wkt -o c.obj --thickness .1 --report r.json");
  ASSERT_EQ(fill.status, 0) << fill.err;
  const Json report = json("r.json");
  EXPECT_EQ(report["status"], "converged");
  EXPECT_EQ(report["outside_segments"], 0);
  EXPECT_GT(report["coverage"]["fraction_within_r"], .9);
  for(const Point& p : points("c.obj")) EXPECT_EQ(p[2], 0);
  EXPECT_GT(points("c.obj").size(), 300u);
  EXPECT_FALSE(has(read("c.obj"), " -0\n"));
  EXPECT_EQ(run("check c.obj plate.wkt").status, 0);
  EXPECT_EQ(run("check plate.wkt").status, 0);
  const Finished measure = run("measure c.obj plate.wkt --thickness .1 --report m.json");
  EXPECT_EQ(measure.status, 0) << measure.err;
  EXPECT_GT(json("m.json")["coverage"]["fraction_within_r"], .9);
}

TEST_F(Command_line_plane, draws_and_writes_svg_at_true_scale)
{
  make_plate();
  ASSERT_EQ(run("fill plate.wkt -o c.svg --thickness .1 --quiet").status, 0);
  const std::string svg = read("c.svg");
  EXPECT_TRUE(has(svg, "mm\" viewBox=\"")) << svg.substr(0, 200);
  EXPECT_TRUE(has(svg, "<polygon points=\""));
  ASSERT_EQ(run("fill plate.wkt -o c.obj --thickness .1 --quiet").status, 0);
  EXPECT_EQ(run("draw c.obj plate.wkt -o d.svg").status, 0);
  EXPECT_TRUE(has(read("d.svg"), "<svg"));
}

TEST_F(Command_line_plane, gives_each_polygon_a_curve_and_verifies_the_record)
{
  write("two.wkt", "POLYGON((0 0, 1 0, 1 1, 0 1))\n"
                   "MULTIPOLYGON(((2 0, 3 0, 3 1, 2 1)), ((4 0, 5 0, 5 1, 4 1)))\n");
  const Finished fill =
      run("fill two.wkt -o c.obj --thickness .1 --certificate c.cert --report r.json");
  ASSERT_EQ(fill.status, 0) << fill.err;
  EXPECT_EQ(json("r.json")["components"], 3);
  const Finished check = run("check --certificate c.cert c.cert.start.obj c.obj --domain two.wkt");
  EXPECT_EQ(check.status, 0) << check.err << check.out;
  write("one.wkt", "POLYGON((0 0, 1 0, 1 1, 0 1))\n");
  EXPECT_EQ(run("check --certificate c.cert c.cert.start.obj c.obj --domain one.wkt").status, 4);
}

TEST_F(Command_line_plane, leads_between_ports_and_along_a_direction)
{
  make_plate();
  write("arc.obj", "v .1 .1 0\nv 2.9 .1 0\nl 1 2\n");
  const Finished fill = run("fill plate.wkt --curve arc.obj --pin ends -o c.obj --thickness .1 "
                            "--directions 8 --direction-field 1,0,0");
  ASSERT_EQ(fill.status, 0) << fill.err;
  EXPECT_EQ(points("c.obj").front(), (Point{.1, .1, 0}));
  EXPECT_EQ(points("c.obj").back(), (Point{2.9, .1, 0}));
}

TEST_F(Command_line_plane, refuses_wrong_polygons_with_line_and_corners)
{
  write("eight.wkt", "POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))\n");
  const Finished eight = run("fill eight.wkt -o c.obj --thickness .1");
  EXPECT_EQ(eight.status, 4);
  EXPECT_TRUE(has(eight.err, "eight.wkt: error: self-contact: the edge of corners")) << eight.err;
  EXPECT_EQ(run("check eight.wkt").status, 4);
  write("words.wkt", "POLYGON((0 0, 2 0, 2 2))\nPOINT(1 2)\n");
  const Finished words = run("fill words.wkt -o c.obj --thickness .1");
  EXPECT_EQ(words.status, 4);
  EXPECT_TRUE(has(words.err, "words.wkt:2: error: syntax error")) << words.err;
  EXPECT_EQ(run("fill missing.wkt -o c.obj").status, 4);
  EXPECT_EQ(run("check words.wkt c.obj").status, 1) << "polygons take no second file";
}

TEST_F(Command_line_plane, refuses_rings_without_corners)
{
  for(const char* text :
      {"POLYGON EMPTY", "POLYGON()", "POLYGON(( ))", "MULTIPOLYGON EMPTY", "MULTIPOLYGON(())",
       "POLYGON((0 0, 1 0, 1 1), ())", "POLYGON((0 0, 1 0"}) {
    write("empty.wkt", text);
    const Finished check = run("check empty.wkt");
    EXPECT_EQ(check.status, 4) << text;
    EXPECT_TRUE(has(check.out, "empty.wkt:1: error: syntax error")) << check.out;
  }
}

TEST_F(Command_line_plane, refuses_options_that_are_for_meshes)
{
  make_plate();
  for(const char* option : {"--repair", "--obstacle plate.wkt", "--thickness-field plate.wkt",
                            "--direction-field plate.wkt"}) {
    const Finished fill = run("fill plate.wkt -o c.obj " + std::string(option));
    EXPECT_EQ(fill.status, 1) << option;
    EXPECT_TRUE(has(fill.err, "is for meshes")) << fill.err;
  }
}

} // namespace test_command_line_plane

#endif // json.hpp
