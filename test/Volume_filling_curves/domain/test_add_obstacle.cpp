// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Obstacles in the domain of a mesh.

#include <CGAL/Volume_filling_curves/add_obstacle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace test_add_obstacle {

namespace vfc = CGAL::Volume_filling_curves;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// a cube with the lower corner (a, a, a)
Mesh cube(double a, double size)
{
  const double b = a + size;
  Mesh mesh;
  CGAL::make_hexahedron(Point(a, a, a), Point(b, a, a), Point(b, b, a), Point(a, b, a),
                        Point(a, b, b), Point(a, a, b), Point(b, a, b), Point(b, b, b), mesh);
  PMP::triangulate_faces(mesh);
  PMP::orient_to_bound_a_volume(mesh);
  return mesh;
}

std::string complaint(Mesh mesh, const Mesh& obstacle)
{
  const std::size_t faces = mesh.number_of_faces();
  try {
    vfc::add_obstacle(mesh, obstacle);
  } catch(const std::invalid_argument& error) {
    EXPECT_EQ(mesh.number_of_faces(), faces);
    return error.what();
  }
  return "";
}

TEST(Add_obstacle, bounds_a_cavity_whatever_the_orientations)
{
  for(const double sign : {1., -1.}) {
    Mesh mesh = cube(0, 4), obstacle = cube(1, 1), second = cube(2.5, 1);
    PMP::reverse_face_orientations(sign > 0 ? obstacle : mesh);
    vfc::add_obstacle(mesh, obstacle);
    vfc::add_obstacle(mesh, second);
    EXPECT_NEAR(sign * PMP::volume(mesh), 62, 1e-9);
    EXPECT_EQ(mesh.point(Mesh::Vertex_index(0)), cube(0, 4).point(Mesh::Vertex_index(0)));
    const vfc::Triangle_mesh_domain_3 domain(mesh);
    EXPECT_TRUE(domain.is_inside(Point(0.5, 0.5, 0.5)));
    EXPECT_FALSE(domain.is_inside(Point(1.5, 1.5, 1.5)));
    EXPECT_FALSE(domain.is_inside(Point(3, 3, 3)));
  }
}

TEST(Add_obstacle, refuses_what_is_no_obstacle)
{
  const std::string crossing = "the obstacle touches or crosses the mesh or another obstacle";
  const std::string outside = "the obstacle is not inside of the mesh, or within another obstacle";
  const Mesh wall = cube(0, 4);
  EXPECT_EQ(complaint(wall, cube(3, 2)), crossing);
  EXPECT_EQ(complaint(wall, cube(0, 1)), crossing) << "it touches the wall";
  EXPECT_EQ(complaint(wall, cube(5, 1)), outside);
  EXPECT_EQ(complaint(wall, cube(-1, 6)), outside);
  EXPECT_EQ(complaint(wall, Mesh()),
            "the obstacle bounds no domain: no geometry: there are no faces");
  Mesh open = cube(1, 1);
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  const std::string hole = complaint(wall, open);
  EXPECT_EQ(hole.rfind("the obstacle bounds no domain: open boundary: ", 0), 0u) << hole;
  Mesh of_quads;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(4, 0, 0), Point(4, 4, 0), Point(0, 4, 0),
                        Point(0, 4, 4), Point(0, 0, 4), Point(4, 0, 4), Point(4, 4, 4), of_quads);
  EXPECT_EQ(complaint(of_quads, cube(1, 1)),
            "the mesh bounds no domain: a face is not a triangle; "
            "Polygon_mesh_processing::triangulate_faces() cuts it");

  Mesh with_obstacle = wall;
  vfc::add_obstacle(with_obstacle, cube(1, 2));
  EXPECT_EQ(complaint(with_obstacle, cube(2.5, 1)), crossing);
  EXPECT_EQ(complaint(with_obstacle, cube(1.5, 1)), outside);
  EXPECT_EQ(complaint(with_obstacle, cube(0.5, 3)), "the obstacle lies around another obstacle");
}

// These ran into preconditions of CGAL, or crashed.
TEST(Add_obstacle, refuses_faces_that_bound_no_domain)
{
  const auto expect_refusal = [](const Mesh& faces, const std::string& fault) {
    for(const bool is_obstacle : {false, true}) {
      const std::string text =
          is_obstacle ? complaint(cube(0, 4), faces) : complaint(faces, cube(1, 1));
      const std::string name = is_obstacle ? "the obstacle" : "the mesh";
      EXPECT_EQ(text.rfind(name + " bounds no domain: " + fault, 0), 0u) << text;
    }
  };
  Mesh faces = cube(1, 1);
  faces.point(Mesh::Vertex_index(0)) = Point(std::numeric_limits<double>::quiet_NaN(), 1, 1);
  expect_refusal(faces, "non-finite coordinate: a coordinate is not finite (vertex 0)");
  faces.point(Mesh::Vertex_index(0)) = Point(2, 1, 1);
  expect_refusal(faces, "degenerate face: the corners of a face lie on a line near (2, 1, 1)");
  for(const auto v : faces.vertices()) faces.point(v) = Point(1, 1, 1);
  expect_refusal(faces, "size too small");
  Mesh overlapping = cube(1, 1);
  CGAL::copy_face_graph(cube(1.5, 1), overlapping);
  expect_refusal(overlapping, "self-intersection: two faces intersect near (1, 1, 2)");
}

// Such vertices beside all faces crashed the search for the orientation.
TEST(Add_obstacle, ignores_vertices_without_faces)
{
  Mesh mesh = cube(0, 4), obstacle = cube(1, 1);
  for(const double a : {-9., 1.5, 9.}) {
    mesh.add_vertex(Point(a, a, a));
    obstacle.add_vertex(Point(a, a, a));
  }
  vfc::add_obstacle(mesh, obstacle);
  EXPECT_NEAR(PMP::volume(mesh), 63, 1e-9);
  EXPECT_EQ(mesh.number_of_vertices(), 8 + 3 + 8);
}

// The cavity of a hollow obstacle is a part of the domain.
TEST(Add_obstacle, orients_the_shells_of_an_obstacle)
{
  Mesh mesh = cube(0, 4), obstacle = cube(1, 2);
  CGAL::copy_face_graph(cube(1.5, 1), obstacle);
  vfc::add_obstacle(mesh, obstacle);
  EXPECT_NEAR(PMP::volume(mesh), 64 - 8 + 1, 1e-9);
}

} // namespace test_add_obstacle
