// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Tubes are closed, oriented to the outside and free of self-intersections, by the judgement of
// CGAL's Polygon_mesh_processing.

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/tube_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_tube_mesh {

using namespace CGAL::Volume_filling_curves;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Curve = Curve_network_3<>;
using Mesh = CGAL::Surface_mesh<Point_3>;

// in units of the polygonal thickness
constexpr double nearly_touching = 0.999;

template <typename Radius>
Mesh tube(const Curve& curve, const Radius& radius, std::size_t number_of_sides = 16)
{
  Mesh mesh;
  tube_mesh(curve, radius, mesh, parameters::number_of_sides(number_of_sides));
  return mesh;
}

template <typename TriangleMesh>
void expect_solid(const TriangleMesh& mesh)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  ASSERT_TRUE(CGAL::is_closed(mesh));
  ASSERT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_FALSE(PMP::does_self_intersect(mesh));
  EXPECT_TRUE(PMP::is_outward_oriented(mesh));
  EXPECT_TRUE(PMP::does_bound_a_volume(mesh));
}

double area_of_polygon(std::size_t n, double radius)
{
  const auto sides = static_cast<double>(n);
  return sides / 2 * std::sin(2 * CGAL_PI / sides) * radius * radius;
}

// At a corner that turns by 0.3 the tube is thinner by a hundredth.
void expect_volume(const Mesh& mesh, const Curve& curve, double radius)
{
  const double volume = length(curve) * area_of_polygon(16, radius);
  EXPECT_NEAR(PMP::volume(mesh), volume, 0.015 * volume);
}

std::vector<Curve> ten_knots()
{
  std::vector<Curve> knots;
  for(const auto& [p, q] : {std::array<int, 2>{2, 3}, {2, 5}, {2, -7}, {3, 4}, {3, 5}})
    knots.push_back(make_torus_knot(p, q, 400, 1));
  for(const char* word :
      {"1 -2 1 -2", "1 1 1 -2 1 -2", "1 1 -2 1 -2 -2", "1 1 2 -1 -3 2 -3", "1 -2 1 -2 3 -2 3"})
    knots.push_back(make_closed_braid(parse_braid_word(word), 600, 1));
  return knots;
}

TEST(Tube_mesh, of_ten_knots_is_solid_up_to_the_thickness)
{
  for(const Curve& knot : ten_knots()) {
    ASSERT_EQ(knot.number_of_components(), 1u);
    const double radius = nearly_touching * polygonal_thickness(knot);
    const Mesh mesh = tube(knot, radius);
    EXPECT_EQ(mesh.number_of_vertices(), 16 * knot.number_of_nodes());
    EXPECT_EQ(mesh.number_of_faces(), 32 * knot.number_of_nodes());
    expect_solid(mesh);
    expect_volume(mesh, knot, radius);
  }
}

TEST(Tube_mesh, of_a_filling_is_solid)
{
  Curve curve;
  fill(curve, Ball_domain_3(Point_3(0, 0, 0), 1),
       parameters::thickness(0.25).number_of_iterations(60).round_bends(false));
  const double radius = nearly_touching * polygonal_thickness(curve);
  ASSERT_GT(radius, 0);
  const Mesh mesh = tube(curve, radius);
  expect_solid(mesh);
  expect_volume(mesh, curve, radius);
}

// Right angles everywhere, and corners that point at one another, two radii apart.
TEST(Tube_mesh, of_lattice_polygons_is_solid_up_to_the_thickness)
{
  for(std::size_t seed = 0; seed < 30; ++seed) {
    const Curve polygon = make_lattice_polygon(120, seed);
    const double thickness = polygonal_thickness(polygon);
    ASSERT_GT(thickness, 0.4);
    for(const std::size_t sides : {3u, 4u, 7u, 16u})
      expect_solid(tube(polygon, nearly_touching * thickness, sides));
  }
}

TEST(Tube_mesh, of_random_polygons_is_solid_up_to_the_thickness)
{
  for(std::size_t seed = 0; seed < 100; ++seed) {
    const Curve polygon = make_random_polygon(4 + seed % 40, seed);
    const double radius = nearly_touching * polygonal_thickness(polygon);
    expect_solid(tube(polygon, radius, 3 + seed % 7));
  }
}

// Polygons of a few nodes whose corners are as sharp as the radius allows, in all directions.
TEST(Tube_mesh, of_sharp_arcs_is_solid_up_to_the_thickness)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for(int repetition = 0; repetition < 300; ++repetition) {
    std::vector<Point_3> points;
    for(int i = 0; i < 6; ++i) {
      const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
      points.emplace_back(x, y, z);
    }
    const Curve arc(points);
    const double radius = nearly_touching * polygonal_thickness(arc);
    expect_solid(tube(arc, radius, 3 + static_cast<std::size_t>(repetition) % 6));
  }
}

TEST(Tube_mesh, closes_with_less_than_half_a_side_of_twist)
{
  for(const Curve& knot : {make_torus_knot(2, 3, 3000, 1), make_torus_knot(3, 4, 3000, 2)}) {
    for(const std::size_t sides : {3u, 5u, 12u}) {
      std::vector<internal::Vector> nodes;
      for(const auto& p : knot.points()) nodes.push_back(internal::to_vector(p));
      const internal::Tube_sections sections(nodes, true, sides);
      // the first corner follows the curve, turning about it evenly
      const std::size_t n = sections.size();
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for(std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const auto step = sections.center(next) - sections.center(i);
        const auto across = [&](std::size_t at, std::size_t corner) {
          const auto arm = sections.arm(at, corner);
          return (arm - arm.dot(step) / step.squaredNorm() * step).normalized();
        };
        const auto a = across(i, 0), b = across(next, next == 0 ? sections.shift() : 0);
        const double twist = a.cross(b).dot(step.normalized()) / step.norm();
        least = std::min(least, twist);
        most = std::max(most, twist);
      }
      const double half_a_side = CGAL_PI / static_cast<double>(sides) / length(knot);
      EXPECT_LT(most, 1.05 * half_a_side);
      EXPECT_GT(least, -1.05 * half_a_side);
      EXPECT_LT(most - least, 0.1 * half_a_side) << "even";
    }
  }
}

TEST(Tube_mesh, has_a_radius_per_node)
{
  const Curve arc(std::vector<Point_3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  const std::vector<double> radii = {0.1, 0.2, 0.4};
  const Mesh from_function = tube(arc, [&](std::size_t v) { return radii[v]; });
  const Mesh from_map = tube(arc, CGAL::make_property_map(radii));
  expect_solid(from_function);
  double volume = 0; // of two frustums
  for(int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    volume += (area_of_polygon(16, radii[k]) + area_of_polygon(16, radii[k + 1]) +
               area_of_polygon(16, std::sqrt(radii[k] * radii[k + 1]))) /
              3;
  }
  EXPECT_NEAR(PMP::volume(from_function), volume, 1e-12);
  for(const auto v : from_function.vertices()) EXPECT_EQ(from_function.point(v), from_map.point(v));
}

TEST(Tube_mesh, around_an_arc_has_flat_ends)
{
  const Curve arc(std::vector<Point_3>{{0, 0, 0}, {0, 0, 2}});
  const Mesh mesh = tube(arc, 0.5, 4);
  EXPECT_EQ(mesh.number_of_vertices(), 10u);
  EXPECT_EQ(mesh.number_of_faces(), 16u);
  expect_solid(mesh);
  EXPECT_NEAR(PMP::volume(mesh), 1, 1e-12);
}

TEST(Tube_mesh, around_a_link_has_a_surface_per_component)
{
  const Curve link = make_torus_knot(2, 4, 300);
  ASSERT_EQ(link.number_of_components(), 2u);
  const double radius = 0.5 * polygonal_thickness(link);
  Mesh mesh = tube(link, radius);
  expect_solid(mesh);
  expect_volume(mesh, link, radius);
  const std::size_t number_of_faces = mesh.number_of_faces();
  tube_mesh(make_regular_polygon(50, 100), radius, mesh); // adds to what is there
  EXPECT_EQ(mesh.number_of_faces(), number_of_faces + 1600);
}

TEST(Tube_mesh, is_any_mutable_face_graph)
{
  CGAL::Polyhedron_3<Kernel> polyhedron;
  tube_mesh(make_regular_polygon(30), 0.2, polyhedron);
  expect_solid(polyhedron);
  using Other_point = CGAL::Simple_cartesian<float>::Point_3;
  Mesh mesh;
  const auto points = mesh.add_property_map<Mesh::Vertex_index, Other_point>("v:other").first;
  tube_mesh(make_regular_polygon(30), 0.2, mesh, parameters::vertex_point_map(points));
  EXPECT_EQ(mesh.number_of_vertices(), 480u);
  EXPECT_NEAR(points[Mesh::Vertex_index(0)].z(), 0.2, 0.3);
}

TEST(Tube_mesh, is_the_same_in_every_unit)
{
  for(const double unit : {std::ldexp(1., -600), std::ldexp(1., -400), std::ldexp(1., 400)}) {
    const Curve knot = make_torus_knot(2, 3, 60);
    std::vector<Point_3> points;
    for(const auto& p : knot.points())
      points.emplace_back(unit * p.x(), unit * p.y(), unit * p.z());
    const Mesh mesh = tube(knot, 0.1);
    const Mesh scaled = tube(Curve(points, parameters::closure(Closure::CLOSED)), 0.1 * unit);
    for(const auto v : mesh.vertices()) EXPECT_EQ(scaled.point(v).x() / unit, mesh.point(v).x());
  }
}

TEST(Tube_mesh, refuses_junctions_and_wrong_parameters)
{
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Curve star(points, std::vector<std::array<std::size_t, 2>>{{0, 1}, {0, 2}, {0, 3}});
  const Curve circle = make_regular_polygon(30);
  Mesh mesh;
  EXPECT_THROW(tube_mesh(star, 0.1, mesh), std::invalid_argument);
  for(const double radius : {0., -1., std::nan(""), HUGE_VAL, 1e-15})
    EXPECT_THROW(tube_mesh(circle, radius, mesh), std::invalid_argument);
  EXPECT_THROW(tube_mesh(circle, 0.1, mesh, parameters::number_of_sides(2)), std::invalid_argument);
  EXPECT_EQ(mesh.number_of_vertices(), 0u);
  tube_mesh(Curve(), 0.1, mesh);
  EXPECT_EQ(mesh.number_of_vertices(), 0u);
}

} // namespace test_tube_mesh
