// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Help and refusals of the program vfc, which is missing if it could not be built.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

namespace test_command_line {

namespace fs = std::filesystem;
using program_test::Command_line;
using program_test::Finished;

TEST_F(Command_line, help_and_version_succeed)
{
  for(const char* arguments : {"--help", "--version", "untangle --help", "check --help",
                               "measure --help", "generate --help", "draw --help", "fill --help"}) {
    const Finished help = run(arguments);
    EXPECT_EQ(help.status, 0) << arguments;
    EXPECT_FALSE(help.out.empty()) << arguments;
  }
}

TEST_F(Command_line, version_names_all_parts)
{
  const std::string out = run("--version").out;
  for(const char* part : {"vfc ", "CGAL ", "Eigen "})
    EXPECT_NE(out.find(part), std::string::npos) << part;
}

TEST_F(Command_line, version_is_that_of_the_build_system)
{
  const fs::path lists = fs::path(VFC_DATA_DIR "/../CMakeLists.txt").lexically_normal();
  const std::string text = program_test::read_file(lists);
  if(text.empty()) GTEST_SKIP() << "no " << lists;
  const std::string out = run("--version").out;
  const std::string version = out.substr(4, out.find('\n') - 4);
  EXPECT_NE(text.find("VERSION " + version + " "), std::string::npos) << version;
}

TEST_F(Command_line, help_shows_both_jobs_first)
{
  const std::string help = run("--help").out;
  const std::size_t usage = help.find("Usage");
  EXPECT_LT(help.find("vfc untangle knot.obj -o tight.obj"), usage) << help;
  EXPECT_LT(help.find("vfc fill mesh.off -o curve.obj"), usage) << help;
}

TEST_F(Command_line, help_shows_ten_options_and_help_all_the_rest)
{
  for(const std::string command : {"untangle", "fill", "simplify"}) {
    const std::string help = run(command + " --help").out;
    const std::string all = run(command + " --help-all").out;
    const auto number_of_options = [](const std::string& text) {
      std::size_t number = 0;
      for(std::size_t at = text.find("\n  -"); at != std::string::npos;
          at = text.find("\n  -", at + 1))
        ++number;
      return number;
    };
    EXPECT_LE(number_of_options(help), 12u) << help; // two of them are --help and --help-all
    EXPECT_GT(number_of_options(all), number_of_options(help)) << all;
    EXPECT_NE(help.find(command + " --help-all"), std::string::npos) << help;
    EXPECT_EQ(help.find("--directions"), std::string::npos) << help;
  }
}

TEST_F(Command_line, misspelt_names_are_met_with_a_question)
{
  const std::array<const char*, 2> cases[] = {
      {"untangel x.obj", "there is no command 'untangel'; did you mean untangle?"},
      {"fil x.off", "did you mean fill?"},
      {"untangle x.obj --thicknes 9", "not expected: --thicknes 9; did you mean --thickness?"},
      {"fill x.off --time-limt=3", "did you mean --time-limit?"}};
  for(const auto& [arguments, question] : cases) {
    const Finished wrong = run(arguments);
    EXPECT_EQ(wrong.status, 1) << arguments;
    EXPECT_NE(wrong.err.find(question), std::string::npos) << wrong.err;
  }
  EXPECT_EQ(run("untangle x.obj --xyz").err.find("did you mean"), std::string::npos);
}

TEST_F(Command_line, ten_of_many_equal_errors_are_printed_and_all_are_in_the_report)
{
  std::string file = "v 0 0 0\n"; // lines to vertices that there are not
  for(int k = 0; k < 30; ++k) file += "l 1 99\n";
  write("bad.obj", file);
  const Finished measure = run("measure bad.obj --report r.json");
  EXPECT_EQ(measure.status, 4);
  std::size_t lines = 0;
  for(std::size_t at = 0; (at = measure.err.find("bad.obj:", at)) != std::string::npos; ++at)
    lines += measure.err.compare(at + 8, 1, " ") != 0; // with the number of a line
  EXPECT_EQ(lines, 10u) << measure.err;
  EXPECT_NE(measure.err.find("and 20 more\n"), std::string::npos) << measure.err;
}

TEST_F(Command_line, one_is_no_plural)
{
  make_trefoil();
  const std::string out = run("untangle trefoil.obj -o o.obj --max-iterations 1").out;
  EXPECT_NE(out.find("1 iteration and "), std::string::npos) << out;
}

TEST_F(Command_line, wrong_options_fail_and_are_named)
{
  make_trefoil();
  const std::array<const char*, 2> cases[] = {
      {"untangle trefoil.obj --thickness -1", "--thickness"},
      {"untangle trefoil.obj --thickness nan", "--thickness"},
      {"untangle trefoil.obj --thickness 1e999", "--thickness"},
      {"untangle trefoil.obj --tolerance abc", "--tolerance"},
      {"untangle trefoil.obj --tolerance 1,5", "--tolerance"},
      {"untangle trefoil.obj --max-iterations -5", "--max-iterations"},
      {"untangle trefoil.obj --seed 1.5", "--seed"},
      {"untangle trefoil.obj --threads 0", "--threads"},
      {"untangle trefoil.obj -o x.obj --thickness 1e-9", "--thickness"},
      {"untangle trefoil.obj -o x.obj --thickness 1e300", "--thickness"},
      {"untangle trefoil.obj -o x.obj --thickness 9", "--thickness"},
      {"untangle trefoil.obj --rmax 1e300", "--rmax"},
      {"untangle trefoil.obj -o x.obj --spacing 1e-9", "--spacing"},
      {"untangle trefoil.obj --spacing 1.5", "--spacing"},
      {"untangle trefoil.obj --strategy fast", "--strategy"},
      {"untangle trefoil.obj --chains 0", "--chains"},
      {"simplify trefoil.obj --max-distance -1", "--max-distance"},
      {"untangle trefoil.obj --preconditioner l3", "--preconditioner"},
      {"untangle trefoil.obj --every 3", "--frames"},
      {"untangle trefoil.obj -o x.obj --pin 201", "--pin"},
      {"untangle trefoil.obj -o x.obj --pin 0", "--pin"},
      {"untangle trefoil.obj -o x.obj --pin 1,", "--pin"},
      {"untangle trefoil.obj --pin ''", "--pin"},
      {"untangle trefoil.obj -o x.obj --pin 1 --keep-length", "--keep-length"},
      {"untangle trefoil.obj --quiet --verbose", "--verbose"},
      {"untangle trefoil.obj -o result.stl", "--output"},
      {"untangle trefoil.obj -o x.obj --map x.obj", "--map"},
      {"untangle", "CURVE"},
      {"untangle trefoil.obj --thicknes 9 8", "not expected: --thicknes 9 8"},
      {"draw trefoil.obj -o picture.gif", "--output"},
      {"draw trefoil.obj", "--output"},
      {"generate torus-knot --q 0 -o x.obj", "torus-knot"},
      {"generate torus-knot --word 1 -o x.obj", "--word"},
      {"generate braid -o x.obj", "--word"},
      {"generate braid --word 1,2 -o x.obj", "1,2"},
      {"generate sphere -o x.obj", "sphere"},
      {"fill trefoil.obj --pin 1", "--curve"},
      {"fill trefoil.obj --length 1 --thickness 1", "--length"},
      {"fill trefoil.obj --wall away", "--wall"},
      {"fill", "MESH"}};
  for(const auto& [arguments, culprit] : cases) {
    const Finished wrong = run(arguments);
    EXPECT_EQ(wrong.status, 1) << arguments;
    EXPECT_NE(wrong.err.find(culprit), std::string::npos) << arguments << ": " << wrong.err;
  }
  EXPECT_FALSE(exists("x.obj"));
}

// All outputs count, and the refusal comes before the input is read.
TEST_F(Command_line, work_whose_result_would_be_lost_is_refused)
{
  make_trefoil();
  for(const std::string command : {"untangle", "simplify", "fill"}) {
    const Finished lost = run(command + " missing.obj --quiet");
    EXPECT_EQ(lost.status, 1) << command;
    for(const char* option : {"--output", "--report", "--certificate", "--map"})
      EXPECT_NE(lost.err.find(option), std::string::npos) << lost.err;
  }
  EXPECT_EQ(run("untangle trefoil.obj --resume missing").status, 1);
  const std::string command = "untangle trefoil.obj --max-iterations 1 ";
  for(const std::string output :
      {"-o a.obj", "--report a.json", "--report -", "--certificate a.cert", "--map a.map",
       "--frames film", "--checkpoint state", "--map /dev/null"})
    EXPECT_EQ(run(command + output).status, 2) << output;
}

} // namespace test_command_line

#endif // json.hpp
