// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Pictures and films that the program vfc draws.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <filesystem>
#include <string>

namespace test_command_line_draw {

namespace fs = std::filesystem;
using program_test::Finished;

class Command_line_draw : public program_test::Program_test
{
protected:
  // A film of four frames, the last one at the end of the run, and a library that is none.
  void make_film() const
  {
    make_trefoil();
    ASSERT_EQ(run("untangle trefoil.obj --frames film --every 3 --max-iterations 7").status, 2);
    fs::create_directories(path("share/javascript/three"));
    write("share/javascript/three/three.min.js", "exports.REVISION = 'none';");
  }

  Finished draw_film(const std::string& arguments) const
  {
    return run_after("export XDG_DATA_DIRS=none:share", "draw " + arguments);
  }
};

TEST_F(Command_line_draw, options_of_pictures_show)
{
  make_trefoil();
  const auto svg = [&](const std::string& options) {
    EXPECT_EQ(run("draw trefoil.obj --force -o a.svg " + options).status, 0) << options;
    return read("a.svg");
  };
  const std::string plain = svg("");
  EXPECT_EQ(svg("--color component --size 800"), plain);
  EXPECT_NE(svg("--size 300").find("width=\"300\""), std::string::npos);
  EXPECT_NE(svg("--size 1600x900").find("width=\"1600\" height=\"900\""), std::string::npos);
  EXPECT_NE(svg("--tube 0.05"), svg("--tube 0.1"));
  EXPECT_NE(svg("--color curvature").find(">curvature<"), std::string::npos);
  EXPECT_NE(svg("--labels").find("<text"), std::string::npos);
  EXPECT_EQ(svg("--view 0,90"), svg("--view 0,1,0"));
  EXPECT_NE(svg("--view 0,90"), plain);
  EXPECT_LT(svg("--view -30,20 --cut z=0").size(), svg("--view -30,20").size());
}

TEST_F(Command_line_draw, wrong_values_are_refused)
{
  make_trefoil();
  for(const std::string option :
      {"--color blue", "--view 1", "--view 0,0,0", "--view 10,100", "--size 0", "--size 1000000",
       "--size 1.5", "--size 800x", "--size 800x90", "--size 8x800x8", "--cut w=1", "--cut 1,2,3",
       "--cut 0,0,0,1", "--tube 0"}) {
    const Finished wrong = run("draw trefoil.obj -o a.svg " + option);
    EXPECT_EQ(wrong.status, 1) << option;
    EXPECT_NE(wrong.err.find(option.substr(0, option.find(' '))), std::string::npos) << wrong.err;
    EXPECT_FALSE(exists("a.svg"));
  }
  EXPECT_EQ(run("draw -o a.svg").status, 1) << "no curve";
  EXPECT_EQ(run("draw trefoil.obj -o a.html").status, 1) << "no film";
}

TEST_F(Command_line_draw, films_are_one_file)
{
  make_film();
  ASSERT_EQ(draw_film("--film film -o a.html --tube 0.25 --report report.json").status, 0);
  EXPECT_EQ(json("report.json")["input"], "film");
  const std::string page = read("a.html");
  EXPECT_NE(page.find("exports.REVISION = 'none';"), std::string::npos);
  EXPECT_NE(page.find("\"tube\":"), std::string::npos);
  for(const std::string iteration : {"0", "3", "6", "7"})
    EXPECT_NE(page.find("{\"iteration\":" + iteration + ','), std::string::npos) << iteration;
}

TEST_F(Command_line_draw, films_end_with_the_result)
{
  make_trefoil();
  ASSERT_EQ(run("untangle trefoil.obj -o o.obj --keep-length --frames film --every 3 "
                "--max-iterations 7")
                .status,
            2);
  EXPECT_EQ(read("film/frame_000007.obj"), read("o.obj"));
}

TEST_F(Command_line_draw, films_come_in_order_and_with_a_surface)
{
  make_film();
  fs::rename(path("film/frame_000003.obj"), path("film/frame_1000000.obj"));
  write("film/notes.txt", "no frame");
  write("tetrahedron.off", "OFF\n4 4 0\n-99 -99 -99\n99 0 0\n0 99 0\n0 0 99\n"
                           "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  ASSERT_EQ(draw_film("--film film tetrahedron.off -o a.html").status, 0);
  const std::string page = read("a.html");
  EXPECT_LT(page.find("{\"iteration\":6,"), page.find("{\"iteration\":1000000,"));
  EXPECT_NE(page.find("\"surface\":{"), std::string::npos);
}

TEST_F(Command_line_draw, films_say_what_they_lack)
{
  make_film();
  const Finished without = run_after("export XDG_DATA_DIRS=none", "draw --film film -o a.html");
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("libjs-three"), std::string::npos) << without.err;
  fs::create_directories(path("node_modules/three/build"));
  write("node_modules/three/build/three.min.js", "// of npm");
  EXPECT_EQ(run_after("export XDG_DATA_DIRS=none", "draw --film film -o npm.html").status, 0);
  EXPECT_NE(read("npm.html").find("// of npm"), std::string::npos);
  fs::create_directory(path("empty"));
  for(const std::string folder : {"empty", "missing", "trefoil.obj"}) {
    const Finished wrong = draw_film("-o a.html --film " + folder);
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.err.find(folder), std::string::npos) << wrong.err;
  }
  write("film/frame_000003.obj", "v 0 0 0\nl 1 7\n");
  const Finished broken = draw_film("--film film -o a.html");
  EXPECT_EQ(broken.status, 4);
  EXPECT_NE(broken.err.find("frame_000003.obj:2"), std::string::npos) << broken.err;
  EXPECT_FALSE(exists("a.html"));
}

TEST_F(Command_line_draw, films_take_no_options_of_pictures)
{
  make_film();
  for(const std::string option :
      {"--color radius", "--view 0,0", "--size 100", "--cut x=0", "--labels", "a.off b.off"})
    EXPECT_EQ(draw_film("--film film -o a.html " + option).status, 1) << option;
  EXPECT_EQ(draw_film("--film film -o a.svg").status, 1);
  EXPECT_EQ(draw_film("--film film -o film/frame_000003.obj --force").status, 1);
  EXPECT_FALSE(exists("a.html"));
}

} // namespace test_command_line_draw

#endif // json.hpp
