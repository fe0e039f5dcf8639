// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Runs of vfc that are interrupted and go on later.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <csignal>
#include <fstream>
#include <string>
#include <vector>

namespace test_command_line_checkpoints {

const std::string trefoil = "untangle trefoil.obj --strategy flow --quiet ";

class Command_line_checkpoints : public program_test::Program_test
{
protected:
  void make_state()
  {
    make_trefoil();
    ASSERT_EQ(run(trefoil + "--max-iterations 3 --checkpoint state").status, 2);
  }

  void make_tetrahedron() const
  {
    write("mesh.off", "OFF\n4 4 0\n0 0 0\n3 0 0\n0 3 0\n0 0 3\n"
                      "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  }

  // Ends a run by a signal, resumes it and compares it with one that was left alone.
  void expect_same_after_signal(std::vector<std::string> arguments)
  {
    std::string command;
    for(const std::string& argument : arguments) command += argument + ' ';
    command += "--quiet ";
    ASSERT_EQ(run(command + "-o whole.obj --certificate whole.cert").status, 0);
    for(const char* option : {"--quiet", "-o", "part.obj", "--certificate", "part.cert", "--frames",
                              "film", "--checkpoint", "state"})
      arguments.push_back(option);
    program_test::Background_program vfc(path("."), arguments);
    ASSERT_TRUE(vfc.wait_for([&] { return exists("film/frame_000002.obj"); }));
    ASSERT_EQ(vfc.end(SIGTERM), 5);
    EXPECT_NE(read("part.obj"), read("whole.obj"));
    ASSERT_EQ(run(command + "-o rest.obj --certificate rest.cert --resume state --checkpoint state "
                            "--frames other_film")
                  .status,
              0);
    EXPECT_EQ(read("rest.obj"), read("whole.obj"));
    EXPECT_EQ(read("rest.cert"), read("whole.cert"));
    EXPECT_FALSE(exists("other_film/frame_000001.obj"));
  }
};

TEST_F(Command_line_checkpoints, runs_go_on_after_a_signal)
{
  ASSERT_EQ(run("generate hard-unknot --nodes 300 --moves 600 -o unknot.obj").status, 0);
  expect_same_after_signal({"untangle", "unknot.obj", "--strategy", "flow"});
}

using Long_command_line_checkpoints = Command_line_checkpoints;

TEST_F(Long_command_line_checkpoints, fillings_go_on_after_a_signal)
{
  make_tetrahedron();
  expect_same_after_signal({"fill", "mesh.off", "--thickness", "0.1"});
}

TEST_F(Command_line_checkpoints, states_are_saved_now_and_then_and_carry_the_commit)
{
  make_trefoil();
  const std::string save = "--checkpoint state --save-every 0 ";
  ASSERT_EQ(run(trefoil + save + "-o whole.obj --report whole.json").status, 0);
  ASSERT_EQ(run(trefoil + "-o rest.obj --resume state").status, 0);
  EXPECT_EQ(read("rest.obj"), read("whole.obj"));
  const auto commit = json("whole.json")["commit"];
  const std::string name = commit.is_string() ? commit.get<std::string>() : "";
  EXPECT_NE(read("state").find(name), std::string::npos);
}

TEST_F(Command_line_checkpoints, states_that_are_damaged_or_of_another_run_are_invalid_input)
{
  make_state();
  std::string damaged = read("state");
  damaged[damaged.size() / 2] = static_cast<char>(~damaged[damaged.size() / 2]);
  std::ofstream(path("damaged"), std::ios::binary) << damaged;
  for(const std::string file : {"damaged", "trefoil.obj", "missing"}) {
    const auto refused = run(trefoil + "-o rest.obj --resume " + file);
    EXPECT_EQ(refused.status, 4) << file;
    EXPECT_NE(refused.err.find(file), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("rest.obj"));
  }
  const auto refused = run(trefoil + "--thickness 0.25 -o x.obj --resume state");
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("another thickness"), std::string::npos) << refused.err;
  make_tetrahedron();
  EXPECT_EQ(run("fill mesh.off -o x.obj --resume state").status, 4);
}

TEST_F(Command_line_checkpoints, a_state_is_overwritten_by_its_own_run_only)
{
  make_state();
  EXPECT_EQ(run(trefoil + "--checkpoint state").status, 1);
  EXPECT_EQ(run(trefoil + "--checkpoint state --resume state --max-iterations 5").status, 2);
  EXPECT_EQ(run(trefoil + "-o state --resume state --force").status, 1);
  EXPECT_EQ(run(trefoil + "--save-every 3").status, 1);
}

} // namespace test_command_line_checkpoints

#endif
