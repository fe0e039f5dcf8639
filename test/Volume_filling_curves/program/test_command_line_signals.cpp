// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <csignal>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

// SIGINT and SIGTERM at places of a run that do not depend on a clock: an input that is a pipe has
// the program wait, and reports when it has begun to read.
namespace test_command_line_signals {

using program_test::Background_program;

class Command_line_signals : public program_test::Program_test
{
protected:
  void make_pipe(const std::string& name) const { ASSERT_EQ(mkfifo(path(name).c_str(), 0600), 0); }

  // Waits until the program reads a pipe, and returns its other end, or -1 if the program has
  // ended.
  int open_when_read(const std::string& name, Background_program& vfc) const
  {
    int file = -1;
    const auto is_open = [&] {
      file = open(path(name).c_str(), O_WRONLY | O_NONBLOCK);
      return file >= 0;
    };
    return vfc.wait_for(is_open) ? file : -1;
  }

  void expect_interrupted(const std::string& report) const
  {
    EXPECT_EQ(json(report)["status"], "interrupted");
    EXPECT_EQ(json(report)["exit_status"], 5);
  }
};

TEST_F(Command_line_signals, while_reading_leave_a_line_and_a_report)
{
  make_pipe("in.off");
  make_pipe("in.obj");
  for(const std::vector<std::string>& command :
      std::vector<std::vector<std::string>>{{"fill", "in.off", "-o", "out.obj"},
                                            {"fill", "in.off", "--repair", "-o", "out.obj"},
                                            {"repair", "in.off", "-o", "out.off"},
                                            {"check", "in.off"},
                                            {"untangle", "in.obj", "-o", "out.obj"},
                                            {"simplify", "in.obj", "-o", "out.obj"},
                                            {"measure", "in.obj"}}) {
    std::vector<std::string> arguments = command;
    for(const char* more : {"--report", "r.json", "--force"}) arguments.push_back(more);
    for(const int signal : {SIGINT, SIGTERM}) {
      Background_program vfc(path("."), arguments);
      const int pipe = open_when_read(command[1], vfc);
      ASSERT_GE(pipe, 0) << command[0];
      EXPECT_EQ(vfc.end(signal), 5) << command[0];
      close(pipe);
      EXPECT_EQ(read("err"), "vfc: interrupted\n");
      expect_interrupted("r.json");
      EXPECT_EQ(json("r.json")["command"], command[0]);
      EXPECT_EQ(json("r.json")["input"], command[1]);
      EXPECT_TRUE(json("r.json")["error"].is_null());
      EXPECT_FALSE(exists("out.obj"));
    }
  }
}

// The report is that of all files, not of the one being read.
TEST_F(Command_line_signals, while_reading_one_of_several_files_leave_a_line_and_a_report)
{
  make_pipe("in.obj");
  for(const int signal : {SIGINT, SIGTERM}) {
    Background_program vfc(path("."),
                           {"identify", "in.obj", "other.obj", "--report", "r.json", "--force"});
    const int pipe = open_when_read("in.obj", vfc);
    ASSERT_GE(pipe, 0);
    EXPECT_EQ(vfc.end(signal), 5);
    close(pipe);
    EXPECT_EQ(read("err"), "vfc: interrupted\n");
    expect_interrupted("r.json");
  }
}

// Wherever it is by then: this takes minutes.
TEST_F(Command_line_signals, before_the_first_step_of_a_filling_end_it_with_a_report)
{
  const std::string mesh = "OFF\n4 4 0\n0 0 0\n3 0 0\n0 3 0\n0 0 3\n"
                           "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  make_pipe("in.off");
  for(const int signal : {SIGINT, SIGTERM}) {
    Background_program vfc(path("."), {"fill", "in.off", "--thickness", "0.02", "-o", "out.obj",
                                       "--report", "r.json", "--force"});
    const int pipe = open_when_read("in.off", vfc);
    ASSERT_GE(pipe, 0);
    ASSERT_EQ(::write(pipe, mesh.data(), mesh.size()), static_cast<ssize_t>(mesh.size()));
    close(pipe);
    EXPECT_EQ(vfc.end(signal), 5);
    expect_interrupted("r.json");
    EXPECT_EQ(json("r.json")["input"], "in.off");
  }
}

} // namespace test_command_line_signals

#endif // json.hpp
