// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc identify, and what untangle reports of knots.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <algorithm>
#include <cmath>
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
  EXPECT_EQ(hopf.out.rfind("hopf.obj: 2^2_1, amphichiral (proved)\n", 0), 0u) << hopf.out;
  const Json report = json("hopf.json");
  EXPECT_EQ(report["linking_matrix"], Json::parse("[[0, 1], [1, 0]]"));
  EXPECT_EQ(report["homfly_polynomial"], "v z^-1 + v z - v^3 z^-1");
  EXPECT_EQ(report["jones_polynomial"], "-s - s^5");
  EXPECT_EQ(report["knotted"], "knotted");
  EXPECT_EQ(report["name"], "2^2_1");
  EXPECT_EQ(report["is_proved"], true);
  ASSERT_EQ(run("generate braid --word '1 -1' -o unlink.obj").status, 0);
  EXPECT_EQ(
      run("identify unlink.obj").out.rfind("unlink.obj: unlink of 2 components (proved)\n", 0), 0u);
}

TEST_F(Command_line_identify, refuses_curves_that_have_no_such_code_or_no_knot)
{
  write("both.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nl 1 2 3 1\nl 4 5\n");
  const Finished both = run("identify both.obj");
  EXPECT_EQ(both.status, 4);
  EXPECT_NE(both.err.find("component 2 is not a closed curve"), std::string::npos) << both.err;
  ASSERT_EQ(run("generate braid --word '1 1' -o hopf.obj").status, 0);
  const Finished link = run("identify hopf.obj --codes pd,dt");
  EXPECT_EQ(link.status, 4);
  EXPECT_EQ(link.out, "");
  EXPECT_NE(link.err.find("only a knot has a Dowker-Thistlethwaite code"), std::string::npos)
      << link.err;
  EXPECT_EQ(run("identify hopf.obj --codes pd,gauss").status, 0);
  EXPECT_EQ(run("identify hopf.obj --codes xy").status, 1);
}

// A trefoil of 40 nodes without one edge, and behind it other nodes and lines.
std::string open_trefoil(const std::string& rest = "")
{
  std::string nodes, line = "l";
  for(int k = 0; k < 40; ++k) {
    const double t = 2 * 3.14159265358979 * k / 40, r = 2 + std::cos(3 * t);
    nodes += "v " + std::to_string(r * std::cos(2 * t)) + ' ' +
             std::to_string(r * std::sin(2 * t)) + ' ' + std::to_string(std::sin(3 * t)) + '\n';
    line += ' ' + std::to_string(k + 1);
  }
  return nodes + line + '\n' + rest;
}

const std::string segment = "v 9 9 9\nv 9 9 10\nl 41 42\n";

TEST_F(Command_line_identify, reports_the_knots_of_open_chains)
{
  write("chain.obj", open_trefoil());
  const Finished chain = run("identify chain.obj --closures 60 --core --report report.json");
  ASSERT_EQ(chain.status, 0) << chain.err;
  const Json report = json("report.json");
  ASSERT_EQ(report["chains"].size(), 1u);
  const Json& knots = report["chains"][0]["knots"];
  const std::string name = knots[0]["name"];
  EXPECT_EQ(name.substr(0, 3), "3_1");
  EXPECT_EQ(report["name"], name);
  EXPECT_TRUE(report["is_proved"].is_null()); // an open chain has no knot type
  EXPECT_TRUE(knots[0]["is_proved"]);
  int closures = 0;
  for(const Json& knot : knots) closures += int(knot["count"]);
  EXPECT_EQ(closures, 60);
  EXPECT_EQ(report["chains"][0]["direct"]["name"], name);
  EXPECT_EQ(report["chains"][0]["core"]["name"], name);
  EXPECT_TRUE(report["chains"][0]["slipknots"].is_null());
  EXPECT_EQ(chain.out.rfind(
                "chain.obj: " + name + " in " + knots[0]["count"].dump() + " of 60 closures\n", 0),
            0u)
      << chain.out;
  EXPECT_NE(chain.out.find("\ncore "), std::string::npos) << chain.out;
}

TEST_F(Command_line_identify, depends_on_the_seed_but_not_on_the_run)
{
  write("chain.obj", open_trefoil());
  const std::string first = run("identify chain.obj --closures 40").out;
  EXPECT_EQ(run("identify chain.obj --closures 40 --threads 1").out, first);
  bool is_other = false;
  for(const char* seed : {"1", "2", "3", "4"})
    is_other = is_other ||
               run("identify chain.obj --closures 40 --seed " + std::string(seed)).out != first;
  EXPECT_TRUE(is_other);
}

TEST_F(Command_line_identify, draws_fingerprints_and_never_overwrites_them)
{
  write("chain.obj", open_trefoil());
  const std::string command = "identify chain.obj --closures 10 --stride 4 --fingerprint ";
  for(const std::string file : {"f.svg", "f.png", "f.csv"})
    ASSERT_EQ(run(command + file).status, 0) << file;
  EXPECT_NE(read("f.svg").find("3_1"), std::string::npos);
  EXPECT_EQ(read("f.png").substr(1, 3), "PNG");
  const std::string csv = read("f.csv");
  EXPECT_EQ(csv.rfind("first,last,knot,share\n1,5,0_1,1\n", 0), 0u) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 11 * 10 / 2); // nodes 1, 5, ..., 37, 40
  EXPECT_EQ(run(command + "f.svg").status, 1);
  EXPECT_EQ(run(command + "f.svg --force").status, 0);
  const Finished wrong = run(command + "f.gif");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("fingerprints are .svg, .png or .csv files"), std::string::npos);
  make_trefoil();
  EXPECT_EQ(run("identify trefoil.obj --fingerprint t.svg").status, 1);
  write("two.obj", open_trefoil(segment));
  EXPECT_NE(run("identify two.obj --fingerprint t.svg").err.find("has 2 chains, not one"),
            std::string::npos);
  EXPECT_EQ(run("identify chain.obj --codes pd").status, 1);
}

TEST_F(Command_line_identify, names_several_files_in_one_run)
{
  make_trefoil();
  write("two.obj", open_trefoil(segment));
  write("bad.obj", "v 0 0 0\nv x 0 0\nl 1 2\n");
  const Finished good = run("identify trefoil.obj two.obj --report good.json");
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_EQ(std::count(good.out.begin(), good.out.end(), '\n'), 3) << good.out;
  EXPECT_NE(good.out.find("\ntwo.obj: chain 2: 0_1 in 100 of 100 closures\n"), std::string::npos)
      << good.out;
  const Finished all = run("identify bad.obj trefoil.obj two.obj --report all.json");
  EXPECT_EQ(all.status, 4);
  EXPECT_EQ(all.out, good.out);
  EXPECT_NE(all.err.find("bad.obj:2: error"), std::string::npos) << all.err;
  const Json curves = json("all.json")["curves"];
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0]["exit_status"], 4);
  EXPECT_EQ(curves[0]["error"]["line"], 2);
  EXPECT_EQ(curves[1]["input"], "trefoil.obj");
  EXPECT_EQ(curves[1]["is_proved"], true);
  EXPECT_EQ(curves[2]["chains"].size(), 2u);
  const Json report = json("all.json");
  EXPECT_EQ(report["exit_status"], 4);
  EXPECT_EQ(report["status"], "error");
  EXPECT_EQ(report["error"], curves[0]["error"]);
  EXPECT_EQ(json("good.json")["status"], "done");
  EXPECT_TRUE(json("good.json")["error"].is_null());
  const Json printed = Json::parse(run("identify trefoil.obj two.obj --report -").out);
  EXPECT_EQ(printed["curves"].size(), 2u);
}

TEST_F(Command_line_identify, keeps_the_time_limit)
{
  write("chain.obj", open_trefoil());
  const Finished late =
      run("identify chain.obj --closures 1000000 --time-limit 0.3 --report r.json");
  EXPECT_EQ(late.status, 2);
  EXPECT_NE(late.err.find("chain.obj: not identified within the time limit"), std::string::npos);
  EXPECT_EQ(json("r.json")["status"], "limit");
  EXPECT_LT(double(json("r.json")["cpu_seconds"]), 2);
}

TEST_F(Command_line_identify, reads_chains_of_pdb_and_mmcif_files)
{
  write("p.cif", "data_p\nloop_\n_atom_site.label_atom_id\n_atom_site.label_asym_id\n"
                 "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                 "_atom_site.Cartn_z\nCA A 1 0 0 0\nCA A 2 3 0 0\nCA A 9 9 9 0\n#\n");
  const Finished cif = run("identify p.cif");
  EXPECT_EQ(cif.status, 0) << cif.err;
  EXPECT_EQ(cif.out.rfind("p.cif: 0_1 in 100 of 100 closures\n", 0), 0u) << cif.out;
  EXPECT_NE(cif.err.find("p.cif:11: warning: chain gap: residues are missing between A 2 and A 9"),
            std::string::npos)
      << cif.err;
  write("p.ent", "ATOM      2  CA  PHE A   6       4.586  32.024   2.913  1.00 36.15\n"
                 "ATOM      3  CA  PHE A   7       7.586  32.024   2.913  1.00 36.15\n");
  EXPECT_EQ(run("identify p.ent").status, 0);
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
