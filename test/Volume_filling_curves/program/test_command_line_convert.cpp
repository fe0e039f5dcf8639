// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// vfc convert, and the formats that other commands write.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <filesystem>
#include <set>
#include <string>

namespace test_command_line_convert {

using program_test::Finished;
using program_test::Json;

class Command_line_convert : public program_test::Program_test
{};

TEST_F(Command_line_convert, keeps_all_digits_through_all_formats)
{
  make_trefoil();
  std::string last = "trefoil.obj";
  for(const std::string name :
      {"a.ply", "a.vtp", "a.vect", "a.xyz", "a.txt", "a.dat", "a.polylines.txt", "a.obj"}) {
    ASSERT_EQ(run("convert " + last + " -o " + name).status, 0) << name;
    EXPECT_EQ(run("check " + name).status, 0) << name;
    last = name;
  }
  EXPECT_EQ(read("a.obj"), read("trefoil.obj"));
}

TEST_F(Command_line_convert, keeps_pinned_nodes_and_junctions)
{
  write("star.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 2 1 3\nl 1 4\nfixed 2 3\n");
  EXPECT_EQ(run("convert star.obj -o star.ply").status, 4) << "a junction";
  ASSERT_EQ(run("convert star.obj -o star.ply --network").status, 0);
  ASSERT_EQ(run("convert star.ply -o star.vtp --network").status, 0);
  ASSERT_EQ(run("convert star.vtp -o again.obj --network").status, 0);
  ASSERT_EQ(run("convert star.obj -o once.obj --network").status, 0);
  EXPECT_EQ(read("again.obj"), read("once.obj"));
}

TEST_F(Command_line_convert, tells_medial_radii_where_the_thickness_is_known)
{
  make_trefoil();
  ASSERT_EQ(run("convert trefoil.obj -o without.vtp").status, 0);
  ASSERT_EQ(run("convert trefoil.obj -o with.vtp --thickness 0.2").status, 0);
  ASSERT_EQ(run("untangle trefoil.obj -o tight.ply --max-iterations 3").status, 2);
  EXPECT_EQ(read("without.vtp").find("\"radius\""), std::string::npos);
  EXPECT_NE(read("with.vtp").find("\"radius\""), std::string::npos);
  EXPECT_NE(read("tight.ply").find("property double radius\n"), std::string::npos);
  for(const std::string name : {"x.obj", "x.polylines.txt", "x.vect", "x.dat"}) {
    const Finished refused = run("convert trefoil.obj -o " + name + " --thickness 0.2");
    EXPECT_EQ(refused.status, 1) << name;
    EXPECT_NE(refused.err.find("--thickness: " + name), std::string::npos) << refused.err;
    EXPECT_FALSE(exists(name));
  }
}

TEST_F(Command_line_convert, makes_tubes_that_are_closed_surfaces)
{
  make_trefoil();
  for(const std::string name : {"tube.off", "tube.ply", "tube.obj", "tube.stl"}) {
    const Finished made = run("convert trefoil.obj --tube 0.5 --report r.json --force -o " + name);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(made.err.find("warning"), std::string::npos) << made.err;
    const Finished checked = run("check " + name);
    EXPECT_EQ(checked.status, 0) << checked.out;
    EXPECT_EQ(checked.out, "") << "a warning";
  }
  const Json report = json("r.json");
  EXPECT_EQ(report["radius"], 0.5);
  EXPECT_EQ(report["faces"], 200 * 16 * 2);
  EXPECT_EQ(run("convert trefoil.obj --tube 0.5 --sides 5 -o five.off").status, 0);
  EXPECT_NE(read("five.off").find("OFF\n1000 2000 0\n"), std::string::npos);
}

TEST_F(Command_line_convert, warns_of_a_tube_that_may_meet_itself)
{
  make_trefoil();
  const Finished thick = run("convert trefoil.obj --tube 1.5 -o tube.off");
  EXPECT_EQ(thick.status, 0);
  EXPECT_NE(thick.err.find("polygonal thickness"), std::string::npos) << thick.err;
  EXPECT_EQ(run("check tube.off").status, 4);
}

TEST_F(Command_line_convert, refuses_what_makes_no_sense)
{
  make_trefoil();
  write("star.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 2 1 3\nl 1 4\n");
  write("there.off", "mine");
  write("bad.ply", "ply\nformat ascii 1.0\nelement vertex 2\n");
  for(const std::string wrong :
      {"trefoil.obj -o x.pdb", "trefoil.obj -o x.stl", "trefoil.obj -o x.vtp --tube 1",
       "trefoil.obj -o x.off --tube 0", "trefoil.obj -o x.ply --sides 8",
       "trefoil.obj -o x.off --tube 1 --sides 2", "trefoil.obj -o there.off --tube 1",
       "trefoil.obj", "star.obj -o x.off --tube 0.1 --network"}) {
    const Finished refused = run("convert " + wrong);
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_NE(refused.err, "") << wrong;
  }
  EXPECT_EQ(read("there.off"), "mine");
  const Finished invalid = run("convert bad.ply -o x.obj");
  EXPECT_EQ(invalid.status, 4);
  EXPECT_EQ(invalid.err.find("it holds a surface"), std::string::npos) << invalid.err;
  EXPECT_NE(invalid.err.find("bad.ply:4: error"), std::string::npos) << invalid.err;
  EXPECT_FALSE(exists("x.obj"));
}

// Far from the origin, or too large, STL's numbers lose the surface, and with it more than digits.
TEST_F(Command_line_convert, writes_no_stl_that_lost_the_surface)
{
  write("far.obj", "v 1e9 0 0\nv 1000000001 0 0\nv 1e9 1 0\nl 1 2 3 1\n");
  write("huge.obj", "v 1e99 0 0\nv 0 1e99 0\nv 0 0 1e99\nl 1 2 3 1\n");
  for(const std::string arguments : {"far.obj --tube 0.1", "huge.obj --tube 1e97"}) {
    const Finished refused = run("convert " + arguments + " -o x.stl");
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("single precision"), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("x.stl"));
    EXPECT_EQ(run("convert " + arguments + " --force -o x.off").status, 0);
  }
}

TEST_F(Command_line_convert, reads_proteins)
{
  write("p.pdb", "ATOM      2  CA  PHE A   6       4.586  32.024   2.913  1.00 36.15\n"
                 "ATOM     13  CA  MET A   7       3.035  33.278  -0.381  1.00 34.92\n"
                 "ATOM     21  CA  LYS A   9       4.780  39.587  -9.572  1.00 30.19\nEND\n");
  const Finished made = run("convert p.pdb -o p.obj");
  EXPECT_EQ(made.status, 0);
  EXPECT_NE(made.err.find("p.pdb:3: warning: chain gap"), std::string::npos) << made.err;
  EXPECT_EQ(points("p.obj").size(), 3u);
}

TEST_F(Command_line_convert, tells_curves_from_surfaces)
{
  make_trefoil();
  ASSERT_EQ(run("convert trefoil.obj -o curve.ply").status, 0);
  ASSERT_EQ(run("convert trefoil.obj -o curve.vtp").status, 0);
  ASSERT_EQ(run("convert trefoil.obj -o surface.ply --tube 0.2").status, 0);
  EXPECT_NE(run("fill curve.ply -o x.obj").err.find("it holds a curve"), std::string::npos);
  EXPECT_NE(run("fill curve.vtp -o x.obj").err.find("it holds a curve"), std::string::npos);
  EXPECT_NE(run("measure surface.ply").err.find("it holds a surface"), std::string::npos);
  EXPECT_EQ(run("check curve.vtp surface.ply").status, 0) << "the curve is inside of its tube";
}

TEST_F(Command_line_convert, frames_for_paraview_have_a_list)
{
  make_trefoil();
  const std::string frames = "untangle trefoil.obj --max-iterations 7 --frames film --every 3 ";
  EXPECT_EQ(run(frames + "--frame-format vtp").status, 2);
  const auto files = [&] {
    std::set<std::string> names;
    for(const auto& entry : std::filesystem::directory_iterator(path("film")))
      names.insert(entry.path().filename().string());
    return names;
  };
  EXPECT_EQ(files(), (std::set<std::string>{"frame_000000.vtp", "frame_000003.vtp",
                                            "frame_000006.vtp", "frame_000007.vtp", "frames.pvd"}));
  EXPECT_NE(read("film/frames.pvd").find("timestep=\"6\" part=\"0\" file=\"frame_000006.vtp\""),
            std::string::npos);
  EXPECT_EQ(run("check film/frame_000006.vtp").status, 0);
  EXPECT_EQ(run(frames + "--every 4 --force").status, 1) << "--every is given twice";
  EXPECT_EQ(run(frames + "--force").status, 2);
  EXPECT_EQ(files().count("frames.pvd"), 0u) << "a list of an earlier film is left";
  EXPECT_EQ(run("untangle trefoil.obj --frame-format vtp").status, 1) << "without --frames";
}

// A corner that the second strand cuts.
constexpr const char* cut_corner =
    "v 2 0 0\nv 0 0 0\nv 0 1 0\nv .2 .2 -1\nv .2 .2 1\nl 1 2 3\nl 4 5\n";

TEST_F(Command_line_convert, writes_arcs_of_a_tight_knot)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o tight.obj").status, 0);
  for(const std::string name : {"arcs.csv", "arcs.step", "arcs.stp"}) {
    const Finished made = run("convert tight.obj --arcs --report r.json --force -o " + name);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(exists(name));
  }
  const Json report = json("r.json");
  EXPECT_EQ(report["arcs"], report["nodes_end"]);
  EXPECT_GT(report["min_bend_radius"], 0);
  EXPECT_GT(report["distance"], 0);
  EXPECT_LT(report["length_end"], report["length_start"]);
  EXPECT_NE(run("convert tight.obj --arcs -o again.csv").out.find(", certified\n"),
            std::string::npos);
}

TEST_F(Command_line_convert, writes_arcs_without_certificate_only_when_asked_to)
{
  write("cut.obj", cut_corner);
  const Finished refused = run("convert cut.obj --arcs -o cut.csv");
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("another strand (nodes 2 4)"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--uncertified"), std::string::npos) << refused.err;
  EXPECT_FALSE(exists("cut.csv"));
  const Finished warned = run("convert cut.obj --arcs -o cut.csv --uncertified");
  EXPECT_EQ(warned.status, 2);
  EXPECT_NE(warned.err.find("not certified"), std::string::npos) << warned.err;
  EXPECT_TRUE(exists("cut.csv"));
}

TEST_F(Command_line_convert, certifies_arcs_inside_a_mesh)
{
  write("cube.off", "OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
                    "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n"
                    "3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n");
  write("in.obj", "v .2 .2 .5\nv .8 .2 .5\nv .8 .8 .5\nl 1 2 3 1\n");
  write("out.obj", "v .2 .2 .5\nv 1.8 .2 .5\nv .8 .8 .5\nl 1 2 3 1\n");
  EXPECT_EQ(run("convert in.obj --arcs --domain cube.off -o in.svg").status, 0);
  const Finished refused = run("convert out.obj --arcs --domain cube.off -o out.svg");
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("inside cube.off"), std::string::npos) << refused.err;
  write("flat.obj", "v .2 .2 0\nv .8 .2 0\nv .8 .8 0\nl 1 2 3 1\n");
  write("plate.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))\n");
  EXPECT_EQ(run("convert flat.obj --arcs --domain plate.wkt -o flat.svg").status, 0);
}

TEST_F(Command_line_convert, refuses_arcs_and_units_that_a_file_cannot_hold)
{
  make_trefoil();
  for(const std::string wrong :
      {"--arcs -o x.obj", "--arcs -o x.svg", "--arcs --tube 1 -o x.stl", "-o x.csv",
       "--domain m.off -o x.obj", "--uncertified -o x.obj", "--arcs --unit mm -o x.csv",
       "--unit mm -o x.obj", "--arcs --unit km -o x.step", "--spacing 0 -o x.obj",
       "--spacing 1e-9 -o x.obj"}) {
    const Finished refused = run("convert trefoil.obj " + wrong);
    EXPECT_EQ(refused.status, 1) << wrong;
    EXPECT_NE(refused.err, "") << wrong;
  }
  EXPECT_NE(run("convert trefoil.obj --arcs -o x.svg").err.find("planar"), std::string::npos);
}

TEST_F(Command_line_convert, notes_the_unit_in_the_header_of_stl)
{
  make_trefoil();
  ASSERT_EQ(run("convert trefoil.obj --tube 0.5 --unit inch -o inch.stl").status, 0);
  ASSERT_EQ(run("convert trefoil.obj --tube 0.5 -o plain.stl").status, 0);
  const std::string inch = read("inch.stl");
  EXPECT_EQ(inch.substr(0, 11), "UNITS=inch ");
  EXPECT_EQ(inch.substr(80), read("plain.stl").substr(80));
  EXPECT_EQ(run("check inch.stl").status, 0);
}

TEST_F(Command_line_convert, resamples_evenly_and_says_how_far_away)
{
  make_trefoil();
  const Finished made = run("convert trefoil.obj --spacing 0.5 --report r.json -o even.obj");
  ASSERT_EQ(made.status, 0) << made.err;
  const Json report = json("r.json");
  EXPECT_GT(report["distance"], 0);
  EXPECT_EQ(report["nodes_end"], points("even.obj").size());
  EXPECT_NEAR(double(report["length_end"]) / double(report["nodes_end"]), 0.5, 0.05);
  EXPECT_NE(run("convert trefoil.obj --spacing 0.5 -o again.obj").out.find("resampled: "),
            std::string::npos);
  EXPECT_EQ(run("convert trefoil.obj --spacing 0.5 --arcs -o even.csv").status, 0);
}

} // namespace test_command_line_convert

#endif // json.hpp
