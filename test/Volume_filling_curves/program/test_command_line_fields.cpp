// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Values at the vertices of meshes in a different order, in the program vfc.

#include <gtest/gtest.h>

#if __has_include(<nlohmann/json.hpp>) && !defined(_WIN32)

#include "support/program_test_support.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace test_command_line_fields {

using program_test::Finished;

class Command_line_fields : public program_test::Program_test
{
protected:
  using Faces = std::vector<std::array<std::size_t, 3>>;

  // a cube with sides of 4
  const std::vector<Point> corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                      {0, 0, 4}, {4, 0, 4}, {4, 4, 4}, {0, 4, 4}};
  const Faces faces = {{4, 5, 6}, {4, 6, 7}, {0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4},
                       {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

  static std::string text(const Point& p)
  {
    return std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]);
  }

  std::string stl() const
  {
    std::string solid = "solid box\n";
    for(const auto& f : faces) {
      solid += "facet normal 0 0 0\nouter loop\n";
      for(const std::size_t v : f) solid += "vertex " + text(corners[v]) + "\n";
      solid += "endloop\nendfacet\n";
    }
    return solid + "endsolid box\n";
  }

  // with a thickness and a direction at each vertex, from the `first` face on
  std::string ply(std::size_t first) const
  {
    const std::string is_double = "property double ";
    std::string result = "ply\nformat ascii 1.0\nelement vertex 8\n";
    for(const char* name :
        {"x", "y", "z", "thickness", "direction_x", "direction_y", "direction_z"})
      result += is_double + name + "\n";
    result += "element face " + std::to_string(faces.size() - first) +
              "\nproperty list uchar int vertex_indices\nend_header\n";
    for(const Point& p : corners) result += text(p) + ' ' + thickness_at(p) + " 0 0 1\n";
    for(std::size_t f = first; f < faces.size(); ++f)
      result += "3 " + std::to_string(faces[f][0]) + ' ' + std::to_string(faces[f][1]) + ' ' +
                std::to_string(faces[f][2]) + "\n";
    return result;
  }

  static std::string thickness_at(const Point& p) { return p[0] > 2 ? "0.8" : "0.4"; }
};

// Rounding, which depends on the order of faces, shows at 1e-6 after 20 iterations.
const std::string limit = " --max-iterations 10 --report r.json";

TEST_F(Command_line_fields, stl_files_have_the_order_that_convert_tells)
{
  write("box.stl", stl());
  ASSERT_EQ(run("convert box.stl box.obj").status, 0);
  std::string csv = "thickness\n";
  for(const Point& p : points("box.obj")) csv += thickness_at(p) + "\n";
  write("r.csv", csv);
  write("box.ply", ply(0));
  const Finished by_stl = run("fill box.stl --thickness-field r.csv -o stl.obj" + limit);
  EXPECT_EQ(by_stl.status, 2) << by_stl.err;
  const double thickness = json("r.json")["thickness"];
  EXPECT_GT(thickness, 0.4);
  EXPECT_LT(thickness, 0.8);
  run("fill box.ply --thickness-field box.ply -o ply.obj --force" + limit);
  EXPECT_NEAR(json("r.json")["thickness"], thickness, 1e-12);
}

TEST_F(Command_line_fields, go_with_repair_to_the_nearest_vertices)
{
  write("whole.ply", ply(0));
  write("open.ply", ply(2));
  const std::string field = " --thickness-field whole.ply --force";
  ASSERT_EQ(run("fill whole.ply -o whole.obj" + field + limit).status, 2);
  const double expected = json("r.json")["thickness"];
  const Finished mended = run("fill open.ply --repair -o open.obj" + field + limit);
  EXPECT_EQ(mended.status, 2) << mended.err;
  EXPECT_NE(mended.err.find("1 hole closed"), std::string::npos) << mended.err;
  EXPECT_NEAR(json("r.json")["thickness"], expected, 1e-6) << "whose faces have another order";
  EXPECT_EQ(run("check open.obj whole.ply").status, 0);
}

TEST_F(Command_line_fields, of_directions_go_with_repair)
{
  write("open.ply", ply(2));
  const std::string fill = "fill open.ply --repair --thickness 0.5 --force" + limit;
  for(const std::string direction : {"open.ply", "0,0,1"}) {
    ASSERT_EQ(run(fill + " -o a.obj --direction-field " + direction).status, 2) << direction;
    EXPECT_GT(json("r.json")["alignment"], 0.5) << direction;
  }
}

TEST_F(Command_line_fields, that_do_not_fit_the_file_are_refused_with_repair)
{
  write("open.ply", ply(2));
  write("r.csv", "0.4\n0.8\n");
  const Finished refused = run("fill open.ply --repair -o a.obj --thickness-field r.csv");
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("2 values for 8 vertices"), std::string::npos) << refused.err;
}

} // namespace test_command_line_fields

#endif
