// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc identify, and what untangle reports of knots.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <cstdlib>
#include <string>

namespace test_command_line_identify {

using program_test::Finished;
using program_test::Json;

class Command_line_identify : public program_test::Program_test
{};

TEST_F(Command_line_identify, prints_and_reports_exact_invariants)
{
  make_trefoil();
  const Finished run_of_trefoil =
      run("identify trefoil.obj --codes pd,gauss,dt --report report.json");
  EXPECT_EQ(run_of_trefoil.status, 0) << run_of_trefoil.err;
  const Json report = json("report.json");
  EXPECT_EQ(report["knottedness"], "knotted_by_determinant");
  EXPECT_EQ(report["crossings"], 3);
  EXPECT_EQ(std::abs(int(report["writhe"])), 3);
  EXPECT_EQ(report["determinant"], 3);
  EXPECT_EQ(std::abs(int(report["signature"])), 2);
  EXPECT_EQ(report["alexander_polynomial"], Json::parse("[1, -1, 1]"));
  EXPECT_EQ(report["codes"].size(), 3u);
  EXPECT_NE(run_of_trefoil.out.find("PD[X["), std::string::npos) << run_of_trefoil.out;
  EXPECT_NE(run_of_trefoil.out.find("1 -1 1\n"), std::string::npos) << run_of_trefoil.out;
}

TEST_F(Command_line_identify, refuses_arcs_and_unknown_codes)
{
  write("arc.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  const Finished arc = run("identify arc.obj");
  EXPECT_EQ(arc.status, 4);
  EXPECT_NE(arc.err.find("component 1 is not a closed curve"), std::string::npos) << arc.err;
  make_trefoil();
  EXPECT_EQ(run("identify trefoil.obj --codes xy").status, 1);
}

TEST_F(Command_line_identify, names_the_proof_in_the_report_of_untangle)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o o.obj --report knot.json").status, 0);
  EXPECT_EQ(json("knot.json")["knottedness"], "knotted_by_determinant");
  write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1\n");
  ASSERT_EQ(run("untangle square.obj -o o.obj --force --report unknot.json").status, 0);
  EXPECT_EQ(json("unknot.json")["knottedness"], "unknotted");
  write("arc.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nl 1 2 3 4\n");
  run("untangle arc.obj -o o.obj --force --report arc.json");
  EXPECT_TRUE(json("arc.json")["knottedness"].is_null());
}

} // namespace test_command_line_identify

#endif
