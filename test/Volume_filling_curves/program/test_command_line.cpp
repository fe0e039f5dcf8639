// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Runs the program vfc, which is missing if it could not be built.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_command_line {

namespace fs = std::filesystem;
using program_test::Finished;
using program_test::Json;

class Command_line : public program_test::Program_test
{};

// Exit status

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

TEST_F(Command_line, goal_limit_and_stall_have_their_status)
{
  make_trefoil();
  EXPECT_EQ(run("untangle trefoil.obj -o a.obj --report a.json").status, 0);
  EXPECT_EQ(json("a.json")["status"], "converged");
  EXPECT_EQ(run("untangle trefoil.obj -o b.obj --report b.json --max-iterations 2").status, 2);
  EXPECT_EQ(json("b.json")["status"], "limit");
  EXPECT_EQ(json("b.json")["iterations"], 2);
  EXPECT_EQ(run("untangle trefoil.obj -o c.obj --report c.json --time-limit 0").status, 2);
  EXPECT_EQ(json("c.json")["status"], "limit");
  EXPECT_EQ(
      run("untangle trefoil.obj -o d.obj --report d.json --strategy flow --tolerance 0").status, 3);
  EXPECT_EQ(json("d.json")["status"], "stalled");
  for(const char* file : {"a.obj", "b.obj", "c.obj", "d.obj"})
    EXPECT_EQ(run(std::string("check ") + file).status, 0) << file;
}

TEST_F(Command_line, invalid_input_is_told_with_its_place)
{
  write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 zero\nl 1 2 3 1\n");
  for(const std::string command : {"untangle", "check", "measure"}) {
    const Finished bad = run(command + " bad.obj --report " + command + ".json");
    EXPECT_EQ(bad.status, 4) << command;
    EXPECT_NE((bad.out + bad.err).find("bad.obj:3: error: "), std::string::npos) << command;
    const Json report = json(command + ".json");
    EXPECT_EQ(report["status"], "error");
    EXPECT_EQ(report["error"]["file"], "bad.obj");
    EXPECT_EQ(report["error"]["line"], 3);
    EXPECT_EQ(report["error"]["nodes"], Json::array({3}));
  }
  EXPECT_EQ(run("draw bad.obj -o bad.svg").status, 4);
  EXPECT_EQ(run("untangle missing.obj -o x.obj").status, 4);
  EXPECT_EQ(run("check missing.obj").status, 4);
}

TEST_F(Command_line, check_accepts_what_it_should)
{
  const std::string manifest = read(VFC_SHARED_DATA "/MANIFEST_bad_curves.csv");
  if(manifest.empty()) GTEST_SKIP() << "no " VFC_SHARED_DATA "/MANIFEST_bad_curves.csv";
  std::istringstream lines(manifest);
  std::string line;
  std::getline(lines, line); // the header
  while(std::getline(lines, line)) {
    const std::string file = line.substr(0, line.find(','));
    const bool is_rejected = line.find(",reject") != std::string::npos;
    if(line.find(" or reject") != std::string::npos) continue;
    EXPECT_EQ(run("check " VFC_SHARED_DATA "/" + file).status, is_rejected ? 4 : 0) << line;
  }
}

// Reports

TEST_F(Command_line, report_has_all_keys)
{
  make_trefoil();
  run("untangle trefoil.obj --report untangle.json");
  run("check trefoil.obj --report check.json");
  run("measure trefoil.obj --report measure.json");
  run("generate random-polygon -o x.obj --report generate.json");
  run("draw trefoil.obj -o x.svg --report draw.json");
  run("untangle missing.obj --report missing.json");
  run("untangle trefoil.obj --thickness x --report wrong.json");
  for(const char* name : {"untangle", "check", "measure", "generate", "draw", "missing", "wrong"}) {
    const Json report = json(std::string(name) + ".json");
    for(const char* key : {"command",
                           "input",
                           "version",
                           "commit",
                           "seed",
                           "threads",
                           "status",
                           "proof",
                           "link",
                           "iterations",
                           "seconds",
                           "cpu_seconds",
                           "seconds_by_stage",
                           "peak_memory_bytes",
                           "nodes_start",
                           "nodes_end",
                           "components",
                           "length_start",
                           "length_end",
                           "thickness",
                           "gradient_norm",
                           "moves_certified",
                           "moves_rejected",
                           "shortened_steps",
                           "refused_remeshing",
                           "min_clearance",
                           "min_strand_distance",
                           "min_strand_points",
                           "min_wall_distance",
                           "min_wall_point",
                           "crowded_fraction",
                           "total_curvature",
                           "max_curvature",
                           "min_bend_radius",
                           "min_bend_point",
                           "ropelength",
                           "average_crossing_number",
                           "linking_matrix",
                           "medial_radius",
                           "coverage",
                           "uncovered_fraction",
                           "empty_regions",
                           "outside_nodes",
                           "outside_segments",
                           "defects",
                           "error"})
      EXPECT_TRUE(report.contains(key)) << name << ": " << key;
  }
  EXPECT_EQ(json("wrong.json")["status"], "error");
  EXPECT_EQ(json("wrong.json")["command"], "untangle");
}

TEST_F(Command_line, report_describes_the_run)
{
  make_trefoil();
  run("untangle trefoil.obj -o tight.obj --report r.json --seed 3 --threads 1");
  const Json report = json("r.json");
  EXPECT_EQ(report["seed"], 3);
  EXPECT_EQ(report["threads"], 1);
  EXPECT_EQ(report["input"], "trefoil.obj");
  EXPECT_EQ(report["nodes_start"], 200);
  EXPECT_EQ(report["nodes_end"], points("tight.obj").size());
  EXPECT_EQ(report["proof"], Json::array({nullptr}));
  EXPECT_TRUE(report["link"].is_null());
  EXPECT_TRUE(report["error"].is_null());
  EXPECT_LT(report["gradient_norm"], 7e-3);
  EXPECT_LT(report["length_end"], report["length_start"]);
  EXPECT_GT(report["ropelength"], 32.7);
  EXPECT_TRUE(report["seconds_by_stage"].is_object());
}

TEST_F(Command_line, report_takes_the_place_of_the_summary)
{
  make_trefoil();
  EXPECT_EQ(Json::parse(run("untangle trefoil.obj --report -").out)["status"], "converged");
  EXPECT_EQ(Json::parse(run("measure trefoil.obj --report -").out)["components"], 1);
  EXPECT_EQ(Json::parse(run("check missing.obj --report -").out)["status"], "error");
  EXPECT_EQ(Json::parse(run("check missing.obj --report - --bogus").out)["status"], "error");
  EXPECT_NE(run("untangle trefoil.obj -o a.obj").out.find("converged"), std::string::npos);
  EXPECT_TRUE(run("untangle trefoil.obj -o b.obj --quiet").out.empty());
}

TEST_F(Command_line, check_lists_defects)
{
  write("bad.obj", "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 -1 0\nv 7 7 7\nl 1 2 3 4 1\n");
  const Finished bad = run("check bad.obj --report r.json");
  EXPECT_EQ(bad.status, 4);
  EXPECT_EQ(std::count(bad.out.begin(), bad.out.end(), '\n'), 2);
  const Json defects = json("r.json")["defects"];
  ASSERT_EQ(defects.size(), 2u);
  std::set<std::string> severities;
  for(const Json& defect : defects) {
    severities.insert(defect["severity"]);
    for(const char* key : {"kind", "severity", "file", "line", "nodes", "component", "message"})
      EXPECT_TRUE(defect.contains(key)) << key;
  }
  EXPECT_EQ(severities, std::set<std::string>({"error", "warning"}));
}

} // namespace test_command_line

#endif // json.hpp
