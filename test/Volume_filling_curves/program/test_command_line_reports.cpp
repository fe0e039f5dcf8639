// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Exit status and reports of the program vfc.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

namespace test_command_line_reports {

using program_test::Command_line;
using program_test::Finished;
using program_test::Json;

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

} // namespace test_command_line_reports

#endif // json.hpp
