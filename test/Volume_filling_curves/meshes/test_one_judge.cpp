// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The library refuses the meshes that the program refuses, in the same words.

#include "support/mesh_file_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_one_judge {

using namespace mesh_file_test;
namespace curves = CGAL::Volume_filling_curves;
namespace np = curves::parameters;

Soup with_point(Soup soup, std::size_t v, const Point& p)
{
  soup.points[v] = p;
  return soup;
}

Soup without_faces(Soup soup, std::vector<std::size_t> last_to_first)
{
  for(const std::size_t f : last_to_first)
    soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
  return soup;
}

Soup shifted_cube(double x, double side)
{
  Soup soup = meshes::cube(side);
  for(Point& p : soup.points) p = Point(p.x() + x, p.y() + .5, p.z() + .5);
  return soup;
}

// A tetrahedron with a vertex on an edge, and with a face between both.
Soup with_flat_face()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.5, 0, 0}},
          {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {1, 2, 3}, {0, 3, 2}}};
}

Soup flattened(Soup soup)
{
  for(Point& p : soup.points) p = Point(p.x(), p.y(), 0);
  return soup;
}

std::vector<std::pair<std::string, Soup>> refused_meshes()
{
  const Soup outer = meshes::sphere(2, 2), inner = meshes::sphere(1, 2);
  const Soup island = meshes::sphere(.5, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {{"self-intersection", inner + meshes::sphere(1, 2, Point(.7, .1, .2))},
          {"self-intersection", meshes::cube(2) + shifted_cube(2, 1)},
          {"self-intersection", with_point(meshes::sphere(1, 1), 4, Point(.01, .02, -2))},
          {"ambiguous shells", outer + inner + island},
          {"ambiguous shells", outer + inner.inverted() + island.inverted()},
          {"open boundary", without_faces(meshes::cube(), {11})},
          {"open boundary", without_faces(inner, {100, 0})},
          {"degenerate face", with_flat_face()},
          {"zero volume", flattened(meshes::cube())},
          {"non-finite coordinate", with_point(meshes::cube(), 3, Point(nan, 0, 0))},
          {"coordinate too large", meshes::cube(1e101)},
          {"size too small", meshes::cube(1e-101)}};
}

std::string list(const char* one, const char* many, const Numbers& numbers)
{
  if(numbers.empty()) return "";
  std::string text = std::string(" (") + (numbers.size() == 1 ? one : many);
  for(const std::size_t number : numbers) text += ' ' + std::to_string(number - 1);
  return text + ')';
}

// Where several vertices are named their order is another one: the library copies a mesh.
bool has_words_and_places(const std::string& text, const std::string& kind, const vfc::Defect& d)
{
  const std::string places = (d.nodes.size() > 1 ? "" : list("vertex", "vertices", d.nodes)) +
                             list("face", "faces", d.faces);
  return text.rfind(kind + ": " + d.message, 0) == 0 && text.size() > places.size() &&
         text.substr(text.size() - places.size()) == places;
}

using One_judge = Mesh_file;

TEST_F(One_judge, refuses_a_mesh_in_program_and_library_with_the_same_words)
{
  for(const auto& [name, soup] : refused_meshes()) {
    const std::string kind = name; // clang 14 captures no structured binding
    EXPECT_FALSE(read(soup));
    ASSERT_NE(find(kind), nullptr) << kind;
    const meshes::Mesh faces = meshes::to_mesh(soup);
    const std::string text = refusal_of([&] { curves::Triangle_mesh_domain_3<> domain(faces); });
    EXPECT_TRUE(std::any_of(
        defects.begin(), defects.end(),
        [&](const vfc::Defect& defect) { return has_words_and_places(text, kind, defect); }))
        << text << '\n'
        << find(kind)->text;
    curves::Curve_network_3<> curve;
    EXPECT_EQ(refusal_of([&] { curves::fill(curve, faces); }), text);
    EXPECT_EQ(refusal_of([&] { curves::fill(curve, faces, curves::Filling_parameters<>()); }),
              text);
  }
}

TEST_F(One_judge, counts_the_faults_of_a_kind)
{
  const Soup soup = without_faces(meshes::sphere(1, 2), {100, 0});
  const std::string text =
      refusal_of([&] { curves::Triangle_mesh_domain_3<> domain(meshes::to_mesh(soup)); });
  EXPECT_NE(text.find(", the first of 2; Polygon_mesh_processing::triangulate_hole()"),
            std::string::npos)
      << text;
}

TEST_F(One_judge, lets_pass_in_the_library_what_is_not_to_be_checked)
{
  const meshes::Mesh nested = meshes::to_mesh(meshes::sphere(2, 2) + meshes::sphere(1, 2));
  const curves::Triangle_mesh_domain_3 domain(nested, np::check_mesh(false));
  EXPECT_FALSE(domain.is_inside(Point(.5, 0, 0))) << "the inner shell bounds a cavity";
  curves::Curve_network_3<> curve;
  curves::fill(curve, nested, np::thickness(.5).number_of_iterations(2).check_mesh(false));
  EXPECT_GT(curve.number_of_nodes(), 3u);
  std::vector<Point> polyline;
  curves::fill(polyline, nested, np::check_mesh(false).thickness(.5).number_of_iterations(2));
  EXPECT_EQ(polyline.size(), curve.number_of_nodes() + 1);
}

TEST_F(One_judge, takes_shells_that_touch_and_nests_turned_inside_out)
{
  const Soup outer = meshes::sphere(2, 2), inner = meshes::sphere(1, 2);
  for(const Soup& soup : {meshes::voxels({{0, 0, 0}, {1, 1, 1}}), outer + inner.inverted(),
                          outer.inverted() + inner}) {
    EXPECT_TRUE(read(soup));
    EXPECT_EQ(refusal_of([&] { curves::Triangle_mesh_domain_3<> domain(mesh); }), "");
  }
  const meshes::Mesh nest = meshes::to_mesh(outer.inverted() + inner);
  EXPECT_EQ(refusal_of([&] { curves::Triangle_mesh_domain_3<> domain(nest); }), "");
}

} // namespace test_one_judge
