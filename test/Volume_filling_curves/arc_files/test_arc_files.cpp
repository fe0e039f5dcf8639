// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Files of arc splines hold the arcs: CSV and SVG read back by their grammar, STEP by OpenCASCADE.

#include "arc_files/arc_writers.h"

#include <CGAL/Volume_filling_curves/generators.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace test_arc_files {

using namespace CGAL::Volume_filling_curves;
using vfc::Arcs;
using vfc::Curve;
using vfc::Length_unit;
using vfc::to_csv;
using vfc::to_step;
using vfc::to_svg;
using Point_3 = Curve::Point_3;
using Points = std::vector<Point_3>;

Arcs knot()
{
  return arc_spline(make_torus_knot(2, 3, 60, 1));
}

std::size_t count(const std::string& text, const std::string& word)
{
  std::size_t number = 0;
  for(std::size_t k = text.find(word); k != std::string::npos; k = text.find(word, k + 1)) ++number;
  return number;
}

// The numbers that OpenCASCADE finds in a STEP file.
struct Step_content
{
  int circles = 0, lines = 0;
  double length = 0, min_radius = 0, max_gap = 0;
};

class Step_reading : public testing::Test
{
protected:
  void SetUp() override
  {
    if(!std::filesystem::exists(VFC_READ_STEP))
      GTEST_SKIP() << "STEP files are not read back: OpenCASCADE is not installed";
  }

  static Step_content read_back(const std::string& text)
  {
    const auto file =
        std::filesystem::temp_directory_path() / ("vfc_arcs_" + std::to_string(getpid()) + ".step");
    std::ofstream(file) << text;
    const std::string command = std::string("'") + VFC_READ_STEP + "' '" + file.string() + "'";
    Step_content content;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string line;
    for(int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get()))
      line = c == '\n' ? line + ' ' : line + static_cast<char>(c);
    std::filesystem::remove(file);
    const std::regex numbers(R"((\d+) (\d+) (\S+) (\S+) (\S+) $)"); // the reader chats before
    std::smatch found;
    EXPECT_TRUE(std::regex_search(line, found, numbers)) << line;
    if(found.empty()) return content;
    return {std::stoi(found[1]), std::stoi(found[2]), std::stod(found[3]), std::stod(found[4]),
            std::stod(found[5])};
  }
};

TEST_F(Step_reading, finds_the_circles_and_lines_of_a_knot)
{
  const Arcs arcs = knot();
  const Step_content content = read_back(to_step(arcs, Length_unit::NONE));
  EXPECT_EQ(content.circles, static_cast<int>(arcs.number_of_arcs));
  EXPECT_EQ(content.lines, static_cast<int>(arcs.number_of_segments));
  EXPECT_NEAR(content.length, arcs.length, 1e-6);
  EXPECT_NEAR(content.min_radius, arcs.min_radius, 1e-6);
  EXPECT_LE(content.max_gap, 2e-7);
}

TEST_F(Step_reading, finds_the_unit)
{
  const Arcs arcs = knot();
  for(const auto& [unit, millimeters] :
      {std::pair(Length_unit::MILLIMETER, 1.), std::pair(Length_unit::CENTIMETER, 10.),
       std::pair(Length_unit::METER, 1000.), std::pair(Length_unit::INCH, 25.4)})
    EXPECT_NEAR(read_back(to_step(arcs, unit)).length / (millimeters * arcs.length), 1, 1e-6);
}

// The corner of 2e-8 has an arc and segments that the reader would drop, and leave a gap.
TEST_F(Step_reading, finds_no_gap_where_pieces_are_shorter_than_its_tolerance)
{
  const Curve curve(std::vector<Points>{
      {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1 + 2e-8, 2e-8, 0), Point_3(1, 1, 0)}});
  const Arcs arcs = arc_spline(curve);
  const Step_content content = read_back(to_step(arcs, Length_unit::NONE));
  EXPECT_LT(content.circles + content.lines,
            static_cast<int>(arcs.number_of_arcs + arcs.number_of_segments));
  EXPECT_NEAR(content.length, arcs.length, 1e-6);
  EXPECT_LE(content.max_gap, 2e-7);
}

TEST(Step_file, has_a_point_in_every_real_and_defines_what_it_uses)
{
  const Curve curve(
      std::vector<Points>{{Point_3(0, 0, 0), Point_3(1e-5, 0, 3), Point_3(1e20, 7, 0)}});
  const std::string text = to_step(arc_spline(curve), Length_unit::INCH);
  const std::regex real(R"([(,](-?\d[\d.]*(E[-+]?\d+)?)(?=[,)]))");
  std::size_t number_of_reals = 0;
  const std::string data = text.substr(text.find("DATA;"));
  for(std::sregex_iterator it(data.begin(), data.end(), real), end; it != end; ++it) {
    const std::string number = (*it)[1];
    if(number == "2000" || number == "3") continue; // a year, and a number of dimensions
    EXPECT_NE(number.find('.'), std::string::npos) << number;
    ++number_of_reals;
  }
  EXPECT_GT(number_of_reals, 20u);
  EXPECT_EQ(std::regex_search(data, std::regex(R"([.\d]e[-+\d])")), false);
  std::set<std::string> defined;
  std::istringstream lines(data);
  for(std::string line; std::getline(lines, line);) {
    const std::size_t equal = line.find('=');
    if(equal == std::string::npos) continue;
    const std::string used = line.substr(equal);
    const std::regex name("#\\d+");
    for(std::sregex_iterator it(used.begin(), used.end(), name), end; it != end; ++it)
      EXPECT_EQ(defined.count(it->str()), 1u) << line;
    EXPECT_TRUE(defined.insert(line.substr(0, equal)).second);
  }
}

// It was left out, without a word.
TEST(Step_file, refuses_a_component_that_readers_take_for_a_point)
{
  const Curve curve(
      std::vector<Points>{{Point_3(1, 0, 0), Point_3(2, 0, 0), Point_3(2, 1, 0)},
                          {Point_3(0, 0, 0), Point_3(1e-9, 0, 0), Point_3(0, 1e-9, 0)}});
  try {
    to_step(arc_spline(curve), Length_unit::METER);
    FAIL();
  } catch(const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 31), "component 2 is shorter than 1e-");
  }
}

TEST(Arc_files, are_not_of_empty_curves)
{
  EXPECT_THROW(to_step(Arcs(), Length_unit::NONE), std::invalid_argument);
  EXPECT_THROW(to_svg(Arcs(), Length_unit::NONE), std::invalid_argument);
}

TEST(Arc_csv, has_a_line_per_piece)
{
  const Arcs arcs = knot();
  const std::string text = to_csv(arcs);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 23), "component,path,start_x,");
  for(const auto& piece : arcs.paths[0].pieces) {
    ASSERT_TRUE(std::getline(lines, line));
    std::vector<std::string> cells;
    std::istringstream words(line + ' ');
    for(std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 12u);
    EXPECT_EQ(std::stod(cells[2]), piece.start.x());
    EXPECT_EQ(std::stod(cells[7]), piece.middle.z());
    EXPECT_EQ(std::stod(cells[9]), piece.end.y());
    if(piece.is_arc())
      EXPECT_EQ(std::stod(cells[11]), piece.radius);
    else
      EXPECT_EQ(cells[11], " ") << "a segment has no radius";
  }
  EXPECT_FALSE(std::getline(lines, line));
}

// A square of side 2, whose arcs have the radius 1: a circle.
Curve square(double z = 0)
{
  return Curve(std::vector<Points>{{Point_3(1, 1, z), Point_3(-1, 1, z), Point_3(-1, -1, z),
                                    Point_3(1, -1, 0), Point_3(1, 1, z)}});
}

TEST(Arc_svg, draws_arcs_of_planar_curves)
{
  const std::string text = to_svg(arc_spline(square()), Length_unit::INCH);
  EXPECT_EQ(count(text, "\nA1 1 0 0 0 "), 4u) << "counterclockwise, with y up";
  EXPECT_EQ(count(text, "L"), 0u);
  EXPECT_NE(text.find("M0 -1"), std::string::npos) << text;
  EXPECT_NE(text.find("width=\"2.08in\""), std::string::npos) << text;
  EXPECT_NE(to_svg(arc_spline(square()), Length_unit::METER).find("width=\"2080mm\""),
            std::string::npos);
}

TEST(Arc_svg, refuses_a_curve_in_space)
{
  EXPECT_THROW(to_svg(arc_spline(square(0.1)), Length_unit::NONE), std::invalid_argument);
}

} // namespace test_arc_files
