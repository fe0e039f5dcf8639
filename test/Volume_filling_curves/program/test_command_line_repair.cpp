// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Surfaces that the program vfc mends, and obstacles in them.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/command_line_meshes_test_support.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_command_line_repair {

using namespace command_line_meshes_test;
using program_test::Finished;

// The cube without its first face: a hole of three edges.
TEST_F(Command_line_meshes, repair_mends_what_fill_refuses_and_says_so)
{
  write("open.obj", cube_vertices + cube_faces.substr(cube_faces.find('\n') + 1));
  const Finished refused = run("fill open.obj -o a.obj --thickness 0.5");
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("open boundary"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("vfc repair, or fill with --repair"), std::string::npos)
      << refused.err;
  const Finished mended = run("repair open.obj -o mended.off --report r.json");
  EXPECT_EQ(mended.status, 0);
  EXPECT_NE(mended.err.find("open.obj: repaired: 1 hole closed, of width"), std::string::npos)
      << mended.err;
  const Json report = json("r.json");
  EXPECT_EQ(report["status"], "done");
  EXPECT_EQ(report["faces"], 12);
  EXPECT_EQ(report["mending"]["steps"].size(), 1u);
  EXPECT_GT(report["mending"]["distance_from_file"], 0.5) << "into the hole";
  EXPECT_LT(report["mending"]["distance_to_mended"], 1e-12);
  EXPECT_EQ(run("check mended.off").out, "");
  EXPECT_EQ(run("repair mended.off -o again.ply").status, 0);
  EXPECT_EQ(run("check again.ply").status, 0);
  const Finished filled =
      run("fill open.obj --repair -o b.obj --thickness 0.5 --max-iterations 2 --report f.json");
  EXPECT_EQ(filled.status, 2) << filled.err;
  EXPECT_EQ(json("f.json")["mending"]["steps"], report["mending"]["steps"]);
  EXPECT_EQ(run("check b.obj mended.off").status, 0);
}

TEST_F(Command_line_meshes, repair_refuses_what_it_cannot_mend_or_write)
{
  make_files();
  EXPECT_EQ(run("repair cube.obj -o cube.stl").status, 1) << "floats";
  EXPECT_EQ(run("repair cube.obj -o cube.obj").status, 1) << "it exists";
  write("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
  EXPECT_EQ(run("repair nan.off -o mended.off").status, 4);
  EXPECT_EQ(run("repair square.obj -o mended.off").status, 4);
}

TEST_F(Command_line_meshes, repair_ends_at_its_time_limit_and_says_so)
{
  write("open.obj", cube_vertices + cube_faces.substr(cube_faces.find('\n') + 1));
  const Finished late = run("repair open.obj -o mended.off --time-limit 0 --report r.json");
  EXPECT_EQ(late.status, 2) << late.err;
  EXPECT_NE(late.err.find("not repaired within 0 s"), std::string::npos) << late.err;
  EXPECT_EQ(json("r.json")["status"], "limit");
  EXPECT_FALSE(exists("mended.off"));
  EXPECT_EQ(run("fill open.obj --repair -o a.obj --thickness 0.5 --time-limit 0").status, 2);
  EXPECT_FALSE(exists("a.obj"));
  EXPECT_EQ(run("repair open.obj -o mended.off --time-limit 1e9").status, 0);
}

// the cube, scaled and moved
std::string small_cube(double corner, double size)
{
  std::istringstream words(cube_vertices);
  std::string text;
  for(std::string word; words >> word;)
    text += word == "v" ? "\nv" : ' ' + std::to_string(corner + size / 4 * std::stod(word));
  return text + '\n' + cube_faces;
}

TEST_F(Command_line_meshes, fillings_keep_out_of_obstacles)
{
  make_files();
  write("obstacle.obj", small_cube(1.5, 1));
  write("other.obj", small_cube(0.5, 0.5));
  const std::string obstacles = " --obstacle obstacle.obj --obstacle other.obj";
  const Finished filled =
      run("fill cube.obj --thickness 0.5 --max-iterations 3 --certificate c -o o.obj" + obstacles);
  EXPECT_TRUE(filled.status == 0 || filled.status == 2) << filled.err;
  EXPECT_FALSE(points("o.obj").empty());
  for(const Point& p : points("o.obj"))
    EXPECT_TRUE(std::any_of(p.begin(), p.end(), [](double x) { return x < 1.5 || x > 2.5; }));
  const std::string verify = "check --certificate c c.start.obj o.obj ";
  EXPECT_EQ(run(verify + "--domain cube.obj" + obstacles).status, 0);
  EXPECT_EQ(run(verify + obstacles).status, 1) << "of no domain";
  EXPECT_EQ(run("check o.obj cube.obj" + obstacles).status, 0);
  EXPECT_EQ(run("check o.obj" + obstacles).status, 1) << "of no domain";
  write("within.obj", "v 1.7 1.7 2\nv 2.3 1.7 2\nv 2 2.3 2\nl 1 2 3 1\n");
  EXPECT_EQ(run("check within.obj cube.obj").status, 0);
  EXPECT_EQ(run("check within.obj cube.obj" + obstacles).status, 4);
}

TEST_F(Command_line_meshes, bad_obstacles_are_named)
{
  make_files();
  write("across.obj", small_cube(3.5, 1));
  write("outside.obj", small_cube(5, 1));
  for(const std::string name : {"across.obj", "outside.obj", "square.obj"}) {
    const Finished refused = run("fill cube.obj --thickness 0.5 -o o.obj --obstacle " + name);
    EXPECT_EQ(refused.status, 4) << name;
    EXPECT_NE(refused.err.find(name), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("o.obj"));
  }
}

// An obstacle that comes out of a pipe when the time is over.
TEST_F(Command_line_meshes, the_time_limit_holds_for_obstacles_too)
{
  make_files();
  write("obstacle.obj", small_cube(1, 1));
  for(const std::string command : {"repair cube.obj -o x.obj", "fill cube.obj --repair -o x.obj"}) {
    const Finished late = run_after("rm -f late.obj && mkfifo late.obj && "
                                    "{ (exec 3>late.obj; sleep 0.6; cat obstacle.obj >&3) & }",
                                    command + " --obstacle late.obj --time-limit 0.5");
    EXPECT_EQ(late.status, 2) << late.err;
    EXPECT_NE(late.err.find("not repaired within 0.5 s"), std::string::npos) << late.err;
    EXPECT_FALSE(exists("x.obj"));
  }
}

// a box from corner to corner
std::string box(const std::array<double, 3>& low, const std::array<double, 3>& high)
{
  std::istringstream words(cube_vertices);
  std::ostringstream text;
  std::size_t k = 0;
  for(std::string word; words >> word;) {
    if(word == "v")
      text << "\nv";
    else
      text << ' ' << (word == "0" ? low : high)[k++ % 3];
  }
  return text.str() + '\n' + cube_faces;
}

// The volume in an OBJ file: sixths of determinants, which are exact for the boxes here.
double volume(const std::string& obj)
{
  std::istringstream words(obj);
  std::vector<std::array<double, 3>> points;
  double six_volumes = 0;
  for(std::string word; words >> word;) {
    std::array<double, 3> x = {};
    if(word != "v" && word != "f") continue;
    words >> x[0] >> x[1] >> x[2];
    if(word == "v") {
      points.push_back(x);
      continue;
    }
    const auto corner = [&](std::size_t k) {
      return points.at(static_cast<std::size_t>(x[k]) - 1);
    };
    const auto a = corner(0), b = corner(1), c = corner(2);
    six_volumes += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six_volumes / 6;
}

TEST_F(Command_line_meshes, obstacles_that_cross_the_mesh_are_cut_out_of_it)
{
  make_files();
  write("bar.obj", box({-1, 1.5, 1.5}, {5, 2.5, 2.5}));
  write("second_bar.obj", box({1.6, 1.25, -1}, {2.4, 2.75, 5}));
  write("plug.obj", box({3, 1, 1}, {5, 2, 2}));
  write("flush.obj", box({3, 1, 1}, {4, 2, 2}));
  write("wall.obj", box({1.5, -1, -1}, {2.5, 5, 5}));
  write("within.obj", box({0.5, 0.5, 0.5}, {1, 1, 1}));
  const auto rest = [&](const std::string& names) {
    std::string options;
    std::istringstream words(names);
    for(std::string name; words >> name;) options += " --obstacle " + name + ".obj";
    EXPECT_EQ(run("repair cube.obj -o rest.obj --force" + options).status, 0) << names;
    EXPECT_EQ(run("check rest.obj").status, 0) << names;
    return volume(read("rest.obj"));
  };
  EXPECT_EQ(rest("bar"), 60);
  EXPECT_EQ(rest("plug"), 63);
  EXPECT_EQ(rest("flush"), 63) << "it ends in the plane of a wall";
  EXPECT_EQ(rest("wall"), 48) << "two parts are left";
  EXPECT_EQ(rest("within"), 63.875) << "a cavity";
  EXPECT_NEAR(rest("bar second_bar"), 56, 1e-12) << "they cross each other, too";
  const Finished filled = run("fill cube.obj --repair --obstacle bar.obj --thickness 0.5 "
                              "--max-iterations 3 -o o.obj");
  EXPECT_TRUE(filled.status == 0 || filled.status == 2) << filled.err;
  EXPECT_NE(filled.err.find("bar.obj: cut out of the mesh"), std::string::npos) << filled.err;
  EXPECT_FALSE(points("o.obj").empty());
  for(const Point& p : points("o.obj"))
    EXPECT_FALSE(p[1] > 1.5 && p[1] < 2.5 && p[2] > 1.5 && p[2] < 2.5);
}

TEST_F(Command_line_meshes, obstacles_that_leave_no_domain_are_refused)
{
  make_files();
  write("outside.obj", small_cube(5, 1));
  write("around.obj", small_cube(-1, 6));
  write("same.obj", cube_vertices + cube_faces);
  for(const std::string name : {"outside.obj", "around.obj", "same.obj", "square.obj"}) {
    const Finished refused = run("repair cube.obj -o rest.obj --obstacle " + name);
    EXPECT_EQ(refused.status, 4) << name;
    EXPECT_NE(refused.err.find(name), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("rest.obj"));
  }
}

TEST_F(Command_line_meshes, constant_directions_fit_meshes_that_must_be_mended)
{
  write("open.obj", cube_vertices + cube_faces.substr(0, cube_faces.rfind('f')));
  const std::string fill = "fill open.obj --repair --max-iterations 3 --force -o o.obj ";
  const int with_direction = run(fill + "--thickness 0.7 --direction-field 0,0,1").status;
  EXPECT_TRUE(with_direction == 0 || with_direction == 2);
  EXPECT_EQ(run(fill + "--direction-field d.csv").status, 4) << "there is no such file";
  EXPECT_EQ(run(fill + "--thickness-field r.csv").status, 4);
}

} // namespace test_command_line_repair

#endif // json.hpp
