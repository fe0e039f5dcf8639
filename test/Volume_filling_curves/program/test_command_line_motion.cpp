// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The command vfc untangle.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace test_command_line_motion {

namespace fs = std::filesystem;
using program_test::Finished;
using program_test::Json;

using Point = std::array<double, 3>;

// 4 pi times the area over the square of the length: 1 for a circle, 0.79 for a square
double roundness(const std::vector<Point>& polygon)
{
  double length = 0;
  Point area = {0, 0, 0};
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
      area[k] += (p[x] * q[y] - p[y] * q[x]) / 2;
    }
  }
  return 4 * M_PI * std::hypot(area[0], area[1], area[2]) / (length * length);
}

class Command_line_motion : public program_test::Program_test
{
protected:
  // A tangle that keeps the program busy for as long as a test needs.
  void make_tangle()
  {
    ASSERT_EQ(run("generate random-polygon --nodes 1500 --seed 7 -o tangle.obj").status, 0);
  }

  // An unknot with a kink, a proof of which is found at once.
  void make_unknot()
  {
    ASSERT_EQ(run("generate braid --word 1 --nodes 60 -o unknot.obj").status, 0);
  }

  void make_arc() { write("arc.obj", "v 0 0 0\nv 1 2 0\nv 2 0 1\nv 3 0 0\nl 1 2 3 4\n"); }
};

TEST_F(Command_line_motion, unlink_and_link_are_told_apart)
{
  run("generate braid --word \"1 1\" -o hopf.obj");
  EXPECT_EQ(run("untangle hopf.obj --report hopf.json").status, 0);
  EXPECT_EQ(json("hopf.json")["link"], "linked");
  EXPECT_EQ(std::abs(json("hopf.json")["linking_matrix"][0][1].get<int>()), 1);
  run("generate braid --word \"1 -1\" -o unlink.obj");
  EXPECT_EQ(run("untangle unlink.obj --report unlink.json").status, 0);
  EXPECT_EQ(json("unlink.json")["link"], "trivial");
  EXPECT_EQ(json("unlink.json")["status"], "unknotted");
}

TEST_F(Command_line_motion, pinned_nodes_stay)
{
  make_arc();
  ASSERT_EQ(run("untangle arc.obj -o tight.obj --thickness 0.5").status, 0);
  EXPECT_EQ(points("tight.obj").front(), points("arc.obj").front());
  EXPECT_EQ(points("tight.obj").back(), points("arc.obj").back());
  run("untangle arc.obj -o free.obj --thickness 0.5 --free-ends --max-iterations 3");
  EXPECT_NE(points("free.obj").front(), points("arc.obj").front());
  EXPECT_NE(run("untangle arc.obj -o point.obj --free-ends").out.find("shrinks to a point"),
            std::string::npos);
  write("fixed.obj", read("arc.obj") + "fixed 2\n");
  ASSERT_EQ(run("untangle fixed.obj -o fixed_tight.obj --pin 3 --thickness 0.5").status, 0);
  const auto after = points("fixed_tight.obj");
  for(const Point& p : points("arc.obj"))
    EXPECT_NE(std::find(after.begin(), after.end(), p), after.end());
}

TEST_F(Command_line_motion, an_arc_at_a_limit_says_whether_its_closure_is_kept)
{
  ASSERT_EQ(run("generate hard-unknot --nodes 100 --moves 2000 --seed 3 -o ring.obj").status, 0);
  std::string arc = read("ring.obj");
  arc.erase(arc.find_last_of(' ')); // the index that closes the ring
  write("arc.obj", arc + '\n');
  const Finished finished = run("untangle arc.obj -o out.obj --report r.json --max-iterations 1");
  EXPECT_EQ(finished.status, 2) << finished.err;
  EXPECT_TRUE(json("r.json")["is_closure_kept"].is_boolean());
  ASSERT_EQ(run("untangle ring.obj -o round.obj --report round.json").status, 0);
  EXPECT_TRUE(json("round.json")["is_closure_kept"].is_null());
}

TEST_F(Command_line_motion, search_is_a_strategy_with_two_names)
{
  make_unknot();
  const std::string untangle = "untangle unknot.obj --seed 3 --report r.json --force --strategy ";
  ASSERT_EQ(run(untangle + "search -o a.obj").status, 0);
  EXPECT_EQ(json("r.json")["status"], "unknotted");
  EXPECT_LE(points("a.obj").size(), 5u) << "the flow does not remove so many nodes";
  ASSERT_EQ(run(untangle + "tighten -o b.obj").status, 0);
  EXPECT_EQ(read("a.obj"), read("b.obj"));
}

TEST_F(Command_line_motion, junctions_need_the_network_option)
{
  write("y.polylines.txt", "2 0 0 0 1 0 0\n2 0 0 0 0 1 0\n2 0 0 0 0 0 1\n");
  EXPECT_EQ(run("check y.polylines.txt --network").status, 0);
  EXPECT_EQ(run("untangle y.polylines.txt --network -o y.obj --thickness 0.3").status, 0);
  EXPECT_EQ(run("check y.obj").status, 4);
  EXPECT_EQ(run("check y.obj --network").status, 0);
  EXPECT_NE(run("untangle y.obj -o x.obj").err.find("--network accepts junctions"),
            std::string::npos);
}

TEST_F(Command_line_motion, threads_do_not_change_the_result)
{
  make_tangle();
  run("untangle tangle.obj -o one.obj --threads 1 --max-iterations 5");
  run("untangle tangle.obj -o two.obj --threads 2 --max-iterations 5");
  EXPECT_FALSE(read("one.obj").empty());
  EXPECT_EQ(read("one.obj"), read("two.obj"));
}

TEST_F(Command_line_motion, scaling_the_input_scales_the_output_exactly)
{
  make_trefoil();
  const double scale = 0x1p-20;
  std::ostringstream scaled;
  scaled.precision(17);
  for(const Point& p : points("trefoil.obj"))
    scaled << "v " << scale * p[0] << ' ' << scale * p[1] << ' ' << scale * p[2] << '\n';
  write("small.obj", scaled.str());
  run("untangle trefoil.obj -o a.obj");
  run("untangle small.obj -o b.obj");
  const auto a = points("a.obj"), b = points("b.obj");
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t k = 0; k < 3; ++k) EXPECT_EQ(scale * a[i][k], b[i][k]);
}

TEST_F(Command_line_motion, keep_length_keeps_the_length)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o tight.obj --keep-length --report r.json").status, 0);
  const double start = json("r.json")["length_start"], end = json("r.json")["length_end"];
  EXPECT_NEAR(end, start, 1e-9 * start);
}

TEST_F(Command_line_motion, an_unknot_comes_out_round)
{
  make_unknot();
  ASSERT_EQ(run("untangle unknot.obj -o round.obj --report r.json").status, 0);
  EXPECT_EQ(json("r.json")["is_round"], true);
  EXPECT_GT(roundness(points("round.obj")), 0.99);
}

TEST_F(Command_line_motion, finish_makes_an_unknot_round)
{
  make_unknot();
  const std::string untangle = "untangle unknot.obj --strategy flow ";
  ASSERT_EQ(run(untangle + "-o proof.obj --report proof.json").status, 0);
  EXPECT_EQ(json("proof.json")["status"], "unknotted");
  EXPECT_LT(roundness(points("proof.obj")), 0.9);
  ASSERT_EQ(run(untangle + "-o round.obj --finish --report round.json").status, 0);
  const Json report = json("round.json");
  EXPECT_EQ(report["status"], "unknotted");
  EXPECT_LT(report["total_curvature"], 1.001 * 2 * M_PI);
  EXPECT_GT(roundness(points("round.obj")), 0.99);
}

TEST_F(Command_line_motion, finish_lowers_the_ropelength_of_a_knot)
{
  constexpr double ideal = 32.74;
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o tight.obj --report tight.json").status, 0);
  EXPECT_EQ(json("tight.json")["is_ropelength_lowered"], false);
  EXPECT_GT(json("tight.json")["ropelength"], 1.05 * ideal);
  ASSERT_EQ(run("untangle trefoil.obj -o ideal.obj --finish --report ideal.json").status, 0);
  EXPECT_EQ(json("ideal.json")["status"], "converged");
  EXPECT_EQ(json("ideal.json")["is_ropelength_lowered"], true);
  EXPECT_LT(json("ideal.json")["ropelength"], 1.01 * ideal);
}

TEST_F(Command_line_motion, limits_of_the_shape_are_kept_or_told)
{
  make_trefoil();
  const std::string untangle = "untangle trefoil.obj --report r.json --force -o ";
  const std::string limits = " --bend-radius 0.2 --strand-distance 0.3 ";
  ASSERT_EQ(run(untangle + "kept.obj --certificate kept.cert" + limits).status, 0);
  EXPECT_GE(json("r.json")["min_bend_radius"], 0.2);
  EXPECT_GE(json("r.json")["min_clearance"], 0.3);
  EXPECT_EQ(run("check --certificate kept.cert trefoil.obj kept.obj").status, 0);
  const double too_much = 0.1 * json("r.json")["length_start"].get<double>();
  const Finished told =
      run(untangle + "told.obj --keep-length --strand-distance " + std::to_string(too_much));
  EXPECT_EQ(told.status, 2);
  EXPECT_EQ(json("r.json")["status"], "constraint_not_reached");
  EXPECT_NE(told.out.find("strands have a distance of"), std::string::npos) << told.out;
  EXPECT_EQ(run(untangle + "x.obj --strategy tighten" + limits).status, 1);
}

// The thickness is the one that is given or measured, or the least for the limits of the shape.
TEST_F(Command_line_motion, the_larger_of_two_thicknesses_decides_on_the_number_of_nodes)
{
  make_trefoil();
  const std::string untangle = "untangle trefoil.obj --max-iterations 1 --force -o x.obj ";
  EXPECT_EQ(run(untangle + "--thickness 0.5 --bend-radius 1e-7").status, 2);
  EXPECT_EQ(run(untangle + "--thickness 1e-7 --bend-radius 0.3").status, 2);
  EXPECT_EQ(run(untangle + "--bend-radius 1e-7").status, 2);
  const Finished dense = run(untangle + "--thickness 1e-7 --bend-radius 1e-8");
  EXPECT_EQ(dense.status, 1);
  EXPECT_NE(dense.err.find("--thickness 1e-07, --bend-radius 1e-08 and --spacing 0.2 are too "
                           "small"),
            std::string::npos)
      << dense.err;
}

TEST_F(Command_line_motion, signals_interrupt_and_save_the_curve)
{
  make_tangle();
  for(const int signal : {SIGINT, SIGTERM}) {
    const std::string name = "interrupted" + std::to_string(signal);
    program_test::Background_program vfc(path("."), {"untangle", "tangle.obj", "-o", name + ".obj",
                                                     "--report", name + ".json", "--frames", name,
                                                     "--quiet", "--tolerance", "0"});
    ASSERT_TRUE(vfc.wait_for([&] { return exists(name + "/frame_000001.obj"); }));
    EXPECT_EQ(vfc.end(signal), 5);
    EXPECT_EQ(json(name + ".json")["status"], "interrupted");
    EXPECT_GE(json(name + ".json")["iterations"], 1);
    EXPECT_EQ(run("check " + name + ".obj").status, 0);
  }
}

TEST_F(Command_line_motion, signals_leave_no_files_under_temporary_names)
{
  program_test::Background_program vfc(
      path("."), {"generate", "random-polygon", "--nodes", "300000", "-o", "big.obj"});
  ASSERT_TRUE(vfc.wait_for([&] { return exists("big.obj.tmp0") || exists("big.obj"); }));
  const int status = vfc.end(SIGTERM);
  EXPECT_TRUE(status == 5 || status == 0) << status;
  if(exists("big.obj")) {
    EXPECT_EQ(run("check big.obj").status, 0);
  }
  for(const auto& entry : std::filesystem::directory_iterator(path(".")))
    EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
}

TEST_F(Command_line_motion, files_that_appear_during_a_run_are_kept)
{
  make_tangle();
  program_test::Background_program vfc(
      path("."), {"untangle", "tangle.obj", "-o", "tight.obj", "--frames", "film", "--tolerance",
                  "0", "--checkpoint", "state", "--save-every", "1000"});
  ASSERT_TRUE(vfc.wait_for([&] { return exists("film/frame_000001.obj"); }));
  for(const std::string name : {"tight.obj", "state"}) write(name, "of another run");
  EXPECT_EQ(vfc.end(SIGINT), 1);
  for(const std::string name : {"tight.obj", "state"}) {
    EXPECT_EQ(read(name), "of another run");
    EXPECT_NE(read("err").find(name + ": exists now"), std::string::npos) << read("err");
    EXPECT_TRUE(exists(name + ".tmp0"));
  }
  ASSERT_TRUE(exists("tight.obj.tmp0"));
  std::filesystem::rename(path("tight.obj.tmp0"), path("saved.obj"));
  EXPECT_EQ(run("check saved.obj").status, 0);
}

// A run that waits for its input has checked its outputs.
TEST_F(Command_line_motion, frames_that_appear_during_a_run_are_kept)
{
  make_trefoil();
  const std::string trefoil = read("trefoil.obj");
  ASSERT_EQ(mkfifo(path("pipe.obj").c_str(), 0600), 0);
  program_test::Background_program vfc(path("."), {"untangle", "pipe.obj", "--frames", "film"});
  int pipe = -1;
  const auto is_read = [&] {
    pipe = open(path("pipe.obj").c_str(), O_WRONLY | O_NONBLOCK);
    return pipe >= 0;
  };
  ASSERT_TRUE(vfc.wait_for(is_read));
  fs::create_directory(path("film"));
  const std::vector<std::string> frames = {"film/frame_000000.obj", "film/frame_000003.obj"};
  for(const std::string& frame : frames) write(frame, "of another run");
  EXPECT_EQ(::write(pipe, trefoil.data(), trefoil.size()), static_cast<ssize_t>(trefoil.size()));
  close(pipe);
  EXPECT_EQ(vfc.wait(), 0);
  for(const std::string& frame : frames) EXPECT_EQ(read(frame), "of another run");
  EXPECT_NE(read("err").find("frame_000000.obj: exists now"), std::string::npos) << read("err");
}

// A trefoil so far away that its coordinates are multiples of 1.5e-5.
TEST_F(Command_line_motion, a_length_that_is_not_kept_is_no_success)
{
  constexpr int number_of_nodes = 60;
  constexpr double far = 1e11;
  std::ostringstream knot;
  knot.precision(17);
  for(int k = 0; k < number_of_nodes; ++k) {
    const double t = 8 * std::atan(1.) * k / number_of_nodes, radius = 2 + std::cos(3 * t);
    knot << "v " << far + radius * std::cos(2 * t) << ' ' << far + radius * std::sin(2 * t) << ' '
         << far + std::sin(3 * t) << '\n';
  }
  knot << 'l';
  for(int k = 1; k <= number_of_nodes; ++k) knot << ' ' << k;
  write("far.obj", knot.str() + " 1\n");
  const Finished untangle = run("untangle far.obj --keep-length -o shrunk.obj --report r.json");
  EXPECT_EQ(untangle.status, 2) << untangle.err;
  EXPECT_EQ(json("r.json")["status"], "length_not_reached");
  EXPECT_EQ(json("r.json")["exit_status"], 2);
}

} // namespace test_command_line_motion

#endif // json.hpp
