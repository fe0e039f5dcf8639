// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Symmetric fillings by the program vfc.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace test_command_line_symmetry {

using program_test::Finished;
using program_test::Json;

class Command_line_symmetry : public program_test::Program_test
{
protected:
  void SetUp() override
  {
    Program_test::SetUp();
    if(IsSkipped()) return;
    write("box.off", "OFF\n8 12 0\n-2 -1 -1\n2 -1 -1\n2 1 -1\n-2 1 -1\n-2 -1 1\n2 -1 1\n2 1 1\n"
                     "-2 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n"
                     "3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
    write("cube.off",
          "OFF\n8 12 0\n-1 -1 -1\n1 -1 -1\n-1 1 -1\n1 1 -1\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 "
          "1\n3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n3 "
          "0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n");
  }

  // Verifies what holds of each filling of the box, and returns its nodes.
  std::vector<Point> filling(const std::string& symmetry)
  {
    const Finished fill = run("fill box.off --preview --thickness .25 --symmetry " + symmetry +
                              " -o c.obj --force --report r.json");
    EXPECT_EQ(fill.status, 0) << fill.err;
    const Json report = json("r.json");
    EXPECT_EQ(report["components"], 1);
    EXPECT_EQ(report["outside_segments"], 0);
    EXPECT_GT(report["coverage"]["fraction_within_r"], .7);
    EXPECT_LT(report["coverage"]["p99"], 1.6);
    EXPECT_EQ(run("check c.obj box.off").status, 0);
    return points("c.obj");
  }
};

TEST_F(Command_line_symmetry, mirror_images_agree_in_all_bits)
{
  const std::vector<Point> nodes = filling("mirror");
  const std::size_t n = nodes.size();
  ASSERT_EQ(n % 2, 0u);
  for(std::size_t k = 0; k < n / 2; ++k) {
    const Point &p = nodes[k], &q = nodes[n - 1 - k];
    EXPECT_EQ(q, (Point{-p[0], p[1], p[2]}));
    EXPECT_GT(p[0], 0);
  }
}

TEST_F(Command_line_symmetry, half_a_turn_maps_the_curve_onto_itself)
{
  const std::vector<Point> nodes = filling("rotation:2");
  const std::size_t n = nodes.size();
  ASSERT_EQ(n % 2, 0u);
  for(std::size_t k = 0; k < n / 2; ++k) {
    const Point &p = nodes[k], &q = nodes[k + n / 2];
    EXPECT_EQ(q, (Point{-p[0], -p[1], p[2]}));
  }
}

TEST_F(Command_line_symmetry, planes_and_axes_may_lie_anywhere)
{
  filling("mirror:0,0,0,0,0,2");
  const std::vector<Point> nodes = filling("rotation:2:0,0,0,1,0,0");
  EXPECT_EQ(nodes[nodes.size() / 2], (Point{nodes[0][0], -nodes[0][1], -nodes[0][2]}));
}

TEST_F(Command_line_symmetry, the_length_of_a_normal_does_not_matter)
{
  const std::string fill = "fill box.off --preview --thickness .25 --max-iterations 1 --force "
                           "--symmetry mirror:0,0,0,";
  run(fill + "1,0,0 -o one.obj");
  ASSERT_FALSE(points("one.obj").empty());
  for(const std::string length : {"1e200", "1e-200", "5e-324", "1.7e308"}) {
    EXPECT_EQ(run(fill + length + ",0,0 -o c.obj").status, 2) << length;
    EXPECT_EQ(read("c.obj"), read("one.obj")) << length;
  }
  const Finished far =
      run("fill box.off --thickness .25 -o f.obj --symmetry mirror:1e308,0,0,1,0,0");
  EXPECT_EQ(far.status, 1);
  EXPECT_NE(far.err.find("--symmetry"), std::string::npos) << far.err;
}

// All corners of the plate are near the walls, so that the mesh passes for a symmetric one, but the
// images of strands cross it.
TEST_F(Command_line_symmetry, an_arc_whose_images_do_not_fit_is_written_alone)
{
  write("plate.off", "OFF\n8 12 0\n-1.001 -.999 -.999\n-1 -.999 -.999\n-1 .999 -.999\n"
                     "-1.001 .999 -.999\n-1.001 -.999 .999\n-1 -.999 .999\n-1 .999 .999\n"
                     "-1.001 .999 .999\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                     "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  const Finished fill = run("fill box.off --obstacle plate.off --preview --thickness .25 "
                            "--symmetry mirror --max-iterations 3 -o c.obj");
  EXPECT_EQ(fill.status, 4) << fill.err;
  EXPECT_NE(fill.err.find("c.obj: holds the arc in its sector"), std::string::npos) << fill.err;
  const std::vector<Point> arc = points("c.obj");
  ASSERT_FALSE(arc.empty());
  EXPECT_TRUE(std::all_of(arc.begin(), arc.end(), [](const Point& p) { return p[0] > 0; }));
  EXPECT_EQ(run("check c.obj box.off").status, 0);
}

TEST_F(Command_line_symmetry, thirds_of_a_torus_are_alike)
{
  const Finished fill =
      run("fill '" VFC_DATA_DIR "/torus.off' --preview --thickness .2 --symmetry rotation:3 "
          "-o c.obj --report r.json");
  ASSERT_EQ(fill.status, 0) << fill.err;
  EXPECT_EQ(json("r.json")["components"], 1);
  const std::vector<Point> nodes = points("c.obj");
  const std::size_t n = nodes.size() / 3;
  ASSERT_EQ(nodes.size(), 3 * n);
  const double c = std::cos(2 * 3.141592653589793 / 3), s = std::sin(2 * 3.141592653589793 / 3);
  for(std::size_t k = 0; k < 2 * n; ++k) {
    const Point &p = nodes[k], &q = nodes[k + n];
    EXPECT_NEAR(q[0], c * p[0] - s * p[1], 1e-12);
    EXPECT_NEAR(q[1], s * p[0] + c * p[1], 1e-12);
    EXPECT_NEAR(q[2], p[2], 1e-12);
  }
}

TEST_F(Command_line_symmetry, arc_is_certified_in_its_sector)
{
  for(const std::string symmetry : {"mirror", "rotation:2:0,0,0,1,0,0"}) {
    const Finished fill = run("fill box.off --preview --thickness .25 --max-iterations 5 --force "
                              "--certificate c.cert -o c.obj --symmetry " +
                              symmetry);
    ASSERT_EQ(fill.status, 2) << fill.err;
    const std::string replay = "check --certificate c.cert c.cert.start.obj c.cert.end.obj "
                               "--domain ";
    EXPECT_EQ(run(replay + "c.cert.domain.off").status, 0) << symmetry;
    const std::vector<Point> arc = points("c.cert.end.obj"), nodes = points("c.obj");
    ASSERT_EQ(nodes.size(), 2 * arc.size());
    EXPECT_TRUE(std::equal(arc.begin(), arc.end(), nodes.begin()) ||
                std::equal(arc.rbegin(), arc.rend(), nodes.begin()));
  }
  write("thin.off", "OFF\n8 12 0\n.1 -1 -.1\n2 -1 -.1\n2 1 -.1\n.1 1 -.1\n.1 -1 .1\n2 -1 .1\n"
                    "2 1 .1\n.1 1 .1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n"
                    "3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  EXPECT_EQ(
      run("check --certificate c.cert c.cert.start.obj c.cert.end.obj --domain thin.off").status,
      4);
}

// The planes pass through vertices and along edges.
TEST_F(Command_line_symmetry, sectors_of_a_cube_about_its_diagonal_can_be_filled)
{
  const Finished fill = run("fill cube.off --thickness .13 -o c.obj --symmetry "
                            "rotation:3:0,0,0,1,1,1");
  EXPECT_EQ(fill.status, 0) << fill.err;
}

TEST_F(Command_line_symmetry, nothing_is_written_if_the_run_ends_before_there_is_an_arc)
{
  write("c.obj", "kept");
  const Finished fill =
      run("fill box.off --thickness .1 --symmetry mirror --time-limit 1e-3 -o c.obj --force");
  EXPECT_EQ(fill.status, 2);
  EXPECT_NE(fill.err.find("before there was a curve"), std::string::npos) << fill.err;
  EXPECT_EQ(read("c.obj"), "kept");
}

TEST_F(Command_line_symmetry, distance_from_the_wall_is_kept_by_all_images)
{
  const Finished fill = run("fill box.off --preview --thickness .25 --symmetry rotation:2 "
                            "--wall-distance .2 -o c.obj --report r.json");
  ASSERT_EQ(fill.status, 0) << fill.err;
  EXPECT_GE(json("r.json")["min_wall_distance"], .2);
  EXPECT_EQ(run("check c.obj box.off --wall-distance .2").status, 0);
}

// With seed 1, an image of the arc came within 0.1292 of this box, which is symmetric up to 0.0019.
TEST_F(Command_line_symmetry, distance_from_the_wall_is_kept_where_the_mesh_is_not_quite_symmetric)
{
  write("uneven.off",
        "OFF\n8 12 0\n-1.1981 -1 -1\n1.2 -1 -1\n-1.1981 1 -1\n1.2 1 -1\n-1.1981 -1 1\n1.2 -1 1\n"
        "-1.1981 1 1\n1.2 1 1\n3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n"
        "3 3 6 7\n3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n");
  for(const std::string seed : {"0", "1"}) {
    const Finished fill = run("fill uneven.off --preview --thickness .2 --wall-distance .13 "
                              "--symmetry mirror:0,0,0,1,0,0 -o c.obj --force --report r.json "
                              "--seed " +
                              seed);
    EXPECT_EQ(fill.status, 0) << fill.err;
    EXPECT_GE(json("r.json")["min_wall_distance"], .13);
  }
}

// The arc keeps the distance from the cut, too, and thought nothing of the gap there.
TEST_F(Command_line_symmetry, tells_of_gaps_between_images_far_from_the_wall)
{
  const Finished fill = run("fill box.off --preview --thickness .15 --symmetry mirror "
                            "--wall-distance .3 -o c.obj --report r.json");
  EXPECT_EQ(fill.status, 2) << fill.err;
  const Json report = json("r.json");
  EXPECT_EQ(report["status"], "partial");
  EXPECT_GT(report["unfilled_fraction"], .01);
  EXPECT_GE(report["min_wall_distance"], .3);
  EXPECT_NE(fill.out.find("leave gaps at the planes of --symmetry"), std::string::npos) << fill.out;
}

// Strands near a cut do not see those of the other images: if they kept no distance from it, both
// runs would miss the limit.
TEST_F(Command_line_symmetry, images_are_as_far_apart_as_required)
{
  for(const std::string seed : {"0", "1"}) {
    const Finished fill = run("fill cube.off --thickness .15 --symmetry mirror -o c.obj --force "
                              "--report r.json --seed " +
                              seed);
    EXPECT_EQ(fill.status, 0) << fill.err;
    const Json report = json("r.json");
    EXPECT_EQ(report["status"], "converged");
    EXPECT_GE(report["min_strand_distance"], 1.6 * .15);
    EXPECT_GE(report["min_bend_radius"], .85 * .15);
  }
}

TEST_F(Command_line_symmetry, refuses_what_is_not_symmetric)
{
  const Finished third = run("fill box.off --thickness .25 --symmetry rotation:3 -o c.obj");
  EXPECT_EQ(third.status, 4);
  EXPECT_NE(third.err.find("the mesh and its image are up to"), std::string::npos) << third.err;
  EXPECT_FALSE(exists("c.obj"));
  const Finished shifted =
      run("fill box.off --thickness .25 --symmetry mirror:.1,0,0,1,0,0 -o c.obj");
  EXPECT_EQ(shifted.status, 4);
  for(const char* text : {"mirrors", "rotation", "rotation:1", "rotation:1001", "mirror:1,2,3",
                          "mirror:0,0,0,0,0,0", "rotation:4x", "mirror0,0,0,1,0,0"}) {
    const Finished wrong =
        run("fill box.off --thickness .25 -o c.obj --symmetry " + std::string(text));
    EXPECT_EQ(wrong.status, 1) << text;
    EXPECT_NE(wrong.err.find(text), std::string::npos) << wrong.err;
  }
  EXPECT_EQ(run("fill box.off --symmetry mirror -o c.obj").status, 1) << "without a thickness";
}

} // namespace test_command_line_symmetry

#endif
