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
  EXPECT_EQ(report["knotted"], "knotted");
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

struct Expected
{
  std::string options; // of vfc generate
  std::string text, name, chirality;
};

TEST_F(Command_line_identify, names_generated_knots)
{
  const Expected all[] = {
      {"braid --word '1 1 1'", "3_1, right-handed (proved)", "3_1", "chiral"},
      {"braid --word '-1 -1 -1'", "3_1*, left-handed (proved)", "3_1*", "chiral"},
      {"braid --word '1 -2 1 -2'", "4_1, amphichiral (proved)", "4_1", "amphichiral"},
      {"braid --word '1 1 -2 1 3 -2 3'", "7_6, chiral (proved)", "7_6", "chiral"},
      {"braid --word '-1 -1 2 -1 -3 2 -3'", "7_6*, chiral (proved)", "7_6*", "chiral"},
      {"braid --word '1 1 1 -2 -2 -2'", "3_1#3_1*, amphichiral (proved)", "3_1#3_1*",
       "amphichiral"},
      {"hard-unknot --nodes 100 --moves 2000", "0_1, unknotted (proved)", "0_1", "amphichiral"}};
  for(const Expected& knot : all) {
    ASSERT_EQ(run("generate " + knot.options + " -o knot.obj --force").status, 0) << knot.options;
    const Finished finished = run("identify knot.obj --report report.json --force");
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.out.substr(0, finished.out.find('\n')), "knot.obj: " + knot.text);
    const Json report = json("report.json");
    EXPECT_EQ(report["name"], knot.name);
    EXPECT_EQ(report["is_proved"], true) << knot.name;
    EXPECT_EQ(report["chirality"], knot.chirality) << knot.name;
    EXPECT_EQ(report["knotted"], knot.name == "0_1" ? "unknotted" : "knotted") << knot.name;
  }
}

TEST_F(Command_line_identify, names_torus_knots_of_both_chiralities)
{
  for(const std::string name : {"3_1", "5_1", "7_1", "9_1"})
    for(const bool is_mirror : {false, true}) { // the sign of q is that of the crossings
      const std::string q = (is_mirror ? "-" : "") + name.substr(0, 1);
      ASSERT_EQ(run("generate torus-knot --q " + q + " -o torus.obj --force").status, 0) << q;
      ASSERT_EQ(run("identify torus.obj --report report.json --force").status, 0) << q;
      const Json report = json("report.json");
      EXPECT_EQ(report["name"], is_mirror ? name + '*' : name);
      EXPECT_EQ(std::to_string(int(report["writhe"])), q);
      EXPECT_EQ(report["is_proved"], true) << q;
    }
}

TEST_F(Command_line_identify, names_sums_beyond_10_crossings_and_states_that_no_name_is_found)
{
  // a reduced alternating diagram of 4_1#7_6 has 11 crossings, the least number
  ASSERT_EQ(run("generate braid --nodes 400 --word '1 -2 1 -2 3 3 -4 3 5 -4 5' -o sum.obj").status,
            0);
  const Finished sum = run("identify sum.obj");
  EXPECT_EQ(sum.out.rfind("sum.obj: 4_1#7_6, chiral (proved)\n", 0), 0u) << sum.out;
  ASSERT_EQ(run("generate braid --word '1 1 1 1 1 1 1 1 1 1 1' -o t.obj").status, 0);
  const Finished beyond_table = run("identify t.obj --report report.json");
  EXPECT_EQ(beyond_table.out.rfind("t.obj: unnamed knot, nontrivial (proved)\n", 0), 0u)
      << beyond_table.out;
  EXPECT_TRUE(json("report.json")["name"].is_null());
  EXPECT_TRUE(json("report.json")["chirality"].is_null());
  EXPECT_EQ(json("report.json")["is_proved"], false);
}

TEST_F(Command_line_identify, reports_linking_numbers_and_polynomials_of_links)
{
  ASSERT_EQ(run("generate braid --word '1 1' -o hopf.obj").status, 0);
  const Finished hopf = run("identify hopf.obj --report hopf.json");
  EXPECT_EQ(hopf.out.rfind("hopf.obj: link of 2 components, nontrivial (proved)\n", 0), 0u)
      << hopf.out;
  const Json report = json("hopf.json");
  EXPECT_EQ(report["linking_matrix"], Json::parse("[[0, 1], [1, 0]]"));
  EXPECT_EQ(report["homfly_polynomial"], "v z^-1 + v z - v^3 z^-1");
  EXPECT_EQ(report["jones_polynomial"], "-s - s^5");
  EXPECT_EQ(report["knotted"], "knotted");
  EXPECT_TRUE(report["name"].is_null());
  ASSERT_EQ(run("generate braid --word '1 -1' -o unlink.obj").status, 0);
  EXPECT_EQ(
      run("identify unlink.obj").out.rfind("unlink.obj: unlink of 2 components (proved)\n", 0), 0u);
}

TEST_F(Command_line_identify, refuses_curves_that_have_no_such_code_or_no_knot)
{
  write("arc.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  const Finished arc = run("identify arc.obj");
  EXPECT_EQ(arc.status, 4);
  EXPECT_NE(arc.err.find("component 1 is not a closed curve"), std::string::npos) << arc.err;
  ASSERT_EQ(run("generate braid --word '1 1' -o hopf.obj").status, 0);
  const Finished link = run("identify hopf.obj --codes pd,dt");
  EXPECT_EQ(link.status, 4);
  EXPECT_EQ(link.out, "");
  EXPECT_NE(link.err.find("only a knot has a Dowker-Thistlethwaite code"), std::string::npos)
      << link.err;
  EXPECT_EQ(run("identify hopf.obj --codes pd,gauss").status, 0);
  EXPECT_EQ(run("identify hopf.obj --codes xy").status, 1);
}

TEST_F(Command_line_identify, names_the_proof_in_the_report_of_untangle)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o o.obj --report knot.json").status, 0);
  EXPECT_EQ(json("knot.json")["knotted"], "knotted");
  EXPECT_EQ(json("knot.json")["knottedness"], "knotted_by_determinant");
  write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1\n");
  ASSERT_EQ(run("untangle square.obj -o o.obj --force --report unknot.json").status, 0);
  EXPECT_EQ(json("unknot.json")["knotted"], "unknotted");
  EXPECT_EQ(json("unknot.json")["knottedness"], "unknotted");
  write("arc.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nl 1 2 3 4\n");
  run("untangle arc.obj -o o.obj --force --report arc.json");
  EXPECT_TRUE(json("arc.json")["knotted"].is_null());
  EXPECT_TRUE(json("arc.json")["knottedness"].is_null());
}

} // namespace test_command_line_identify

#endif
