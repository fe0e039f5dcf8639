// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PROGRAM_TEST_SUPPORT_H
#define VFC_PROGRAM_TEST_SUPPORT_H

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace program_test {

using Json = nlohmann::json;

inline std::string read_file(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Results of a run of the program.
struct Finished
{
  int status;
  std::string out, err;
};

// A test with a folder of its own, in which the program runs.
class Program_test : public testing::Test
{
protected:
  void SetUp() override
  {
    if(!std::filesystem::exists(VFC_PROGRAM)) GTEST_SKIP() << "there is no program vfc";
    const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = std::filesystem::temp_directory_path() /
               ("vfc_" + std::to_string(getpid()) + "_" + info->name());
    std::filesystem::create_directory(m_folder);
  }

  void TearDown() override
  {
    if(!m_folder.empty()) std::filesystem::remove_all(m_folder);
  }

  std::filesystem::path path(const std::string& name) const { return m_folder / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  std::string read(const std::string& name) const { return read_file(path(name)); }
  Json json(const std::string& name) const { return Json::parse(read(name)); }
  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
  }

  Finished run(const std::string& arguments) const { return run_after("true", arguments); }

  // The same after a command of the shell.
  Finished run_after(const std::string& preparation, const std::string& arguments) const
  {
    const std::string command = "cd '" + m_folder.string() + "' && " + preparation + " && '" +
                                VFC_PROGRAM + "' " + arguments + " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out"), read("err")};
  }

  // A trefoil, tight after a dozen iterations.
  void make_trefoil() const
  {
    ASSERT_EQ(run("generate torus-knot --p 2 --q 3 -o trefoil.obj").status, 0);
  }

  using Point = std::array<double, 3>;

  // the vertices of an OBJ file
  std::vector<Point> points(const std::string& file) const
  {
    std::vector<Point> result;
    std::istringstream lines(read(file));
    for(std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword;
      Point p;
      if(words >> keyword >> p[0] >> p[1] >> p[2] && keyword == "v") result.push_back(p);
    }
    return result;
  }

private:
  std::filesystem::path m_folder;
};

// Tests of what all commands have in common.
class Command_line : public Program_test
{};

// The program, running at the same time as the test.
class Background_program
{
public:
  // Standard error goes to the file `err` in the folder.
  Background_program(const std::filesystem::path& folder, std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), VFC_PROGRAM);
    std::vector<char*> argv;
    for(std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    m_process = fork();
    if(m_process != 0) return;
    if(chdir(folder.c_str()) == 0 && std::freopen("err", "w", stderr) != nullptr)
      execv(VFC_PROGRAM, argv.data());
    _exit(127);
  }

  ~Background_program()
  {
    if(m_process > 0) end(SIGKILL);
  }

  // Waits until a condition holds, however long that takes; false if the program ends before.
  template <typename Condition>
  bool wait_for(const Condition& holds)
  {
    using namespace std::chrono_literals;
    while(!holds()) {
      if(has_ended()) return holds();
      std::this_thread::sleep_for(1ms);
    }
    return true;
  }

  void send(int signal) const { kill(m_process, signal); }

  // Waits for the end and returns the exit status.
  int wait()
  {
    if(!has_ended()) waitpid(m_process, &m_status, 0);
    m_process = 0;
    return WIFEXITED(m_status) ? WEXITSTATUS(m_status) : -1;
  }

  // Sends a signal, waits for the end and returns the exit status.
  int end(int signal)
  {
    if(!has_ended()) send(signal);
    return wait();
  }

private:
  bool has_ended()
  {
    if(m_process > 0 && waitpid(m_process, &m_status, WNOHANG) == m_process) m_process = 0;
    return m_process == 0;
  }

  pid_t m_process;
  int m_status = -1;
};

} // namespace program_test

#endif // VFC_PROGRAM_TEST_SUPPORT_H
