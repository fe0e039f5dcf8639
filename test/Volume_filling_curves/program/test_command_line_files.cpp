// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The files that the program vfc writes, and those that it must not.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_command_line_files {

namespace fs = std::filesystem;
using program_test::Finished;

class Command_line_files : public program_test::Program_test
{};

TEST_F(Command_line_files, existing_outputs_are_refused_before_work_starts)
{
  make_trefoil();
  write("there.obj", "mine");
  fs::create_directory(path("film"));
  write("film/frame_000000.obj", "mine");
  for(const std::string option :
      {"-o there.obj", "--report there.obj", "--map there.obj", "--frames film"}) {
    const Finished refused = run("untangle trefoil.obj " + option);
    EXPECT_EQ(refused.status, 1) << option;
    EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  }
  EXPECT_EQ(run("draw trefoil.obj -o there.obj").status, 1);
  EXPECT_EQ(run("generate random-polygon -o there.obj").status, 1);
  EXPECT_EQ(read("there.obj"), "mine");
  EXPECT_EQ(read("film/frame_000000.obj"), "mine");
}

TEST_F(Command_line_files, force_overwrites)
{
  make_trefoil();
  write("there.obj", "mine");
  fs::create_directory(path("film"));
  write("film/frame_000009.obj", "mine");
  EXPECT_EQ(run("untangle trefoil.obj -o there.obj --frames film --every 5 --force").status, 0);
  EXPECT_EQ(run("check there.obj").status, 0);
  EXPECT_FALSE(exists("film/frame_000009.obj")) << "a frame of an earlier film is left";
  EXPECT_EQ(run("untangle trefoil.obj -o trefoil.obj --force").status, 0);
}

TEST_F(Command_line_files, unwritable_paths_are_refused_before_work_starts)
{
  make_trefoil();
  for(const std::string option :
      {"-o none/x.obj", "--report none/x", "--map none/x", "--frames none/x", "--report ."})
    EXPECT_EQ(run("untangle trefoil.obj " + option).status, 1) << option;
  EXPECT_EQ(run("untangle missing.obj -o none/x.obj").status, 1) << "the output comes first";
}

TEST_F(Command_line_files, nothing_partial_is_left)
{
  write("bad.obj", "v 0 0 0\n");
  run("untangle bad.obj -o x.obj --map x.map --frames film");
  std::set<std::string> files;
  for(const auto& entry : fs::directory_iterator(path(".")))
    files.insert(entry.path().filename().string());
  EXPECT_EQ(files, std::set<std::string>({"bad.obj", "out", "err"}));
}

TEST_F(Command_line_files, a_value_that_is_empty_is_a_wrong_option)
{
  make_trefoil();
  for(const std::string option : {"-o ''", "--report ''", "--report=", "--map ''", "--frames ''"}) {
    const Finished wrong = run("untangle trefoil.obj --max-iterations 1 " + option);
    EXPECT_EQ(wrong.status, 1) << option;
    EXPECT_NE(wrong.err.find("--"), std::string::npos) << wrong.err;
  }
  write("mesh.off", "OFF\n");
  for(const std::string option :
      {"--symmetry", "--direction-field", "--volume-shares", "--port", "--obstacle"}) {
    const Finished wrong = run("fill mesh.off -o x.obj --thickness 1 " + option + " ''");
    EXPECT_EQ(wrong.status, 1) << option;
    EXPECT_NE(wrong.err.find(option), std::string::npos) << wrong.err;
  }
  EXPECT_EQ(run("untangle ''").status, 1);
  EXPECT_EQ(run("untangle --batch '' -o results").status, 1);
  EXPECT_EQ(run("draw trefoil.obj -o ''").status, 1);
}

TEST_F(Command_line_files, a_report_never_replaces_the_input)
{
  make_trefoil();
  const std::string before = read("trefoil.obj");
  fs::create_hard_link(path("trefoil.obj"), path("hard.obj"));
  fs::create_symlink("trefoil.obj", path("soft.obj"));
  for(const std::string command :
      {"untangle trefoil.obj", "check trefoil.obj", "measure trefoil.obj",
       "draw trefoil.obj -o x.svg", "untangle trefoil.obj --bogus"})
    for(const std::string report : {"trefoil.obj", "hard.obj", "soft.obj", "./trefoil.obj"}) {
      const Finished refused = run(command + " --force --report " + report);
      EXPECT_EQ(refused.status, 1) << command << ' ' << report;
      EXPECT_EQ(read("trefoil.obj"), before) << command << ' ' << report;
    }
  EXPECT_EQ(run("untangle trefoil.obj --force --map hard.obj").status, 1);
  EXPECT_EQ(read("trefoil.obj"), before);
}

TEST_F(Command_line_files, two_outputs_are_two_files)
{
  make_trefoil();
  fs::create_symlink("b.obj", path("a.obj"));
  fs::create_symlink("c.obj", path("d.obj"));
  for(const std::string outputs : {"-o x.obj --report x.obj", "-o y.obj --report ./y.obj",
                                   "-o a.obj --report b.obj", "-o c.obj --map d.obj"}) {
    const Finished refused = run("untangle trefoil.obj " + outputs);
    EXPECT_EQ(refused.status, 1) << outputs;
    EXPECT_NE(refused.err.find("is also the file of"), std::string::npos) << refused.err;
  }
}

TEST_F(Command_line_files, frames_replace_neither_input_nor_output)
{
  make_trefoil();
  fs::create_directory(path("film"));
  fs::copy_file(path("trefoil.obj"), path("film/frame_000000.obj"));
  EXPECT_EQ(run("untangle film/frame_000000.obj --frames film --force").status, 1);
  EXPECT_EQ(run("untangle trefoil.obj --frames film -o film/frame_000001.obj --force").status, 1);
  EXPECT_EQ(read("film/frame_000000.obj"), read("trefoil.obj"));
  EXPECT_EQ(run("untangle trefoil.obj --frames film -o film/x.obj --force --quiet").status, 0);
}

// The result would be lost: a folder of frames would be in the place of its file.
TEST_F(Command_line_files, frames_that_do_not_exist_yet_are_no_other_output)
{
  make_trefoil();
  for(const std::string option : {"-o", "--report", "--certificate", "--map", "--checkpoint"}) {
    const std::string name = option == "--map" ? "x" : "x.obj";
    const Finished refused =
        run("untangle trefoil.obj --frames ./" + name + "/ " + option + " " + name);
    EXPECT_EQ(refused.status, 1) << option;
    EXPECT_NE(refused.err.find("--frames"), std::string::npos) << refused.err;
    EXPECT_EQ(exists(name), option == "--report") << option;
    fs::remove_all(path(name));
  }
}

TEST_F(Command_line_files, frames_do_not_replace_the_state)
{
  make_trefoil();
  fs::create_directory(path("film"));
  const Finished refused = run(
      "untangle trefoil.obj --frames film --checkpoint film/frame_000001.obj --max-iterations 2");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("holds the file of --checkpoint"), std::string::npos) << refused.err;
}

TEST_F(Command_line_files, a_run_goes_on_without_frames_that_cannot_be_written)
{
  make_trefoil();
  fs::create_directory(path("film"));
  fs::create_directory(path("film/frame_000002.obj")); // which no file replaces
  write("film/frame_000002.obj/kept", "");
  const Finished told = run("untangle trefoil.obj --max-iterations 4 --frames film -o x.obj "
                            "--report r.json --force");
  EXPECT_EQ(json("r.json")["iterations"], 4);
  EXPECT_EQ(run("check x.obj").status, 0);
  const std::size_t warning = told.err.find("--frames: film/frame_000002.obj: cannot be written");
  EXPECT_NE(warning, std::string::npos) << told.err;
  EXPECT_EQ(told.err.find("--frames", warning + 1), std::string::npos) << "once";
  EXPECT_TRUE(exists("film/frame_000001.obj"));
  EXPECT_FALSE(exists("film/frame_000003.obj"));
}

TEST_F(Command_line_files, a_report_that_cannot_be_written_is_told_after_any_other_error)
{
  if(!exists("/dev/full")) GTEST_SKIP() << "the system has no /dev/full";
  write("tetrahedron.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                           "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  for(const std::string command : {"repair tetrahedron.off -o x.off --time-limit 0",
                                   "fill tetrahedron.off --repair -o x.obj --time-limit 0"}) {
    const Finished late = run(command + " --report /dev/full");
    EXPECT_EQ(late.status, 2) << late.err;
    EXPECT_NE(late.err.find("/dev/full: cannot be written"), std::string::npos) << late.err;
  }
}

TEST_F(Command_line_files, a_standard_output_that_cannot_be_written_is_an_error)
{
  if(!exists("/dev/full")) GTEST_SKIP() << "the system has no /dev/full";
  make_trefoil();
  for(const std::string command :
      {"--help-all", "--version", "fill --help", "measure trefoil.obj"}) {
    const Finished finished = run(command + " >/dev/full 2>err #"); // instead of run()'s own files
    EXPECT_EQ(finished.status, 1) << command;
    EXPECT_NE(finished.err.find("standard output cannot be written"), std::string::npos);
  }
}

TEST_F(Command_line_files, a_link_that_leads_nowhere_gets_its_file)
{
  make_trefoil();
  fs::create_symlink("target.obj", path("link.obj"));
  EXPECT_EQ(run("untangle trefoil.obj -o link.obj").status, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.obj")));
  EXPECT_EQ(run("check target.obj").status, 0);
}

TEST_F(Command_line_files, a_limit_of_the_size_of_files_is_an_error)
{
  EXPECT_EQ(run_after("ulimit -f 2", "generate torus-knot --nodes 1000 -o x.obj").status, 1);
  for(const auto& entry : fs::directory_iterator(path(".")))
    EXPECT_NE(entry.path().filename().string().substr(0, 1), "x");
}

TEST_F(Command_line_files, writes_polylines_and_pictures)
{
  make_trefoil();
  EXPECT_EQ(run("untangle trefoil.obj -o tight.polylines.txt").status, 0);
  EXPECT_EQ(run("measure tight.polylines.txt").status, 0);
  EXPECT_EQ(run("draw tight.polylines.txt -o tight.svg").status, 0);
  EXPECT_NE(read("tight.svg").find("</svg>"), std::string::npos);
}

TEST_F(Command_line_files, frames_are_curves_of_every_kth_iteration_and_the_result)
{
  make_trefoil();
  EXPECT_EQ(run("untangle trefoil.obj --frames film --every 3 --max-iterations 7").status, 2);
  std::set<std::string> files;
  for(const auto& entry : fs::directory_iterator(path("film")))
    files.insert(entry.path().filename().string());
  EXPECT_EQ(files, std::set<std::string>({"frame_000000.obj", "frame_000003.obj",
                                          "frame_000006.obj", "frame_000007.obj"}));
  EXPECT_EQ(run("check film/frame_000003.obj").status, 0);
}

TEST_F(Command_line_files, map_names_the_nodes_of_the_input)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o tight.obj --map map.txt --pin 20,150").status, 0);
  const auto before = points("trefoil.obj"), after = points("tight.obj");
  std::istringstream numbers(read("map.txt"));
  std::vector<std::size_t> map;
  for(std::size_t number; numbers >> number;) map.push_back(number);
  ASSERT_EQ(map.size(), after.size());
  for(const std::size_t pinned : {20u, 150u}) {
    const auto found = std::find(map.begin(), map.end(), pinned);
    ASSERT_NE(found, map.end());
    EXPECT_EQ(after[static_cast<std::size_t>(found - map.begin())], before[pinned - 1]);
  }
}

TEST_F(Command_line_files, rings_in_lists_of_points_need_closed_or_open)
{
  std::string ring;
  for(int i = 0; i < 24; ++i)
    ring += std::to_string(std::cos(i * CGAL_PI / 12)) + ' ' +
            std::to_string(std::sin(i * CGAL_PI / 12)) + " 0\n";
  write("ring.xyz", ring);
  for(const std::string arguments :
      {"untangle ring.xyz -o o.obj", "simplify ring.xyz -o o.obj", "check ring.xyz",
       "measure ring.xyz", "draw ring.xyz -o o.svg", "convert ring.xyz -o o.obj"}) {
    const Finished refused = run(arguments + " --force");
    EXPECT_EQ(refused.status, 4) << arguments;
    const std::string said = refused.out + refused.err;
    EXPECT_NE(said.find("--closed"), std::string::npos) << said;
    EXPECT_NE(said.find("--open"), std::string::npos) << said;
    EXPECT_EQ(run(arguments + " --closed --open").status, 1) << arguments;
    EXPECT_EQ(run(arguments + " --closed --force").status, 0) << arguments;
    EXPECT_EQ(run(arguments + " --open --force").status, 0) << arguments;
  }
  ASSERT_EQ(run("convert ring.xyz --closed -o ring.obj").status, 0);
  EXPECT_NE(read("ring.obj").find(" 24 1\n"), std::string::npos) << read("ring.obj");
  ASSERT_EQ(run("convert ring.obj --open -o arc.obj").status, 0);
  EXPECT_EQ(read("arc.obj").find(" 24 1\n"), std::string::npos) << read("arc.obj");
}

} // namespace test_command_line_files

#endif // json.hpp
