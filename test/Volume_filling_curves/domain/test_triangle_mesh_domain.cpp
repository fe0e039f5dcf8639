// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/domain_test_support.h"
#include "support/exact_brute_force.h"
#include "support/exact_surface.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/bounding_box.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace test_triangle_mesh_domain {

using namespace domain_test;
using meshes::Kernel;
using Rational = CGAL::Exact_rational;

template <typename NT>
std::vector<brute_force::Vec<NT>> to_hull(const std::vector<Point>& points)
{
  std::vector<brute_force::Vec<NT>> hull;
  for(const Point& p : points) hull.push_back({NT(p.x()), NT(p.y()), NT(p.z())});
  return hull;
}

template <typename NT>
bool does_miss_surface(const Soup& soup, const std::array<Point, 3>& t)
{
  const auto triangle = to_hull<NT>({t.begin(), t.end()});
  const CGAL::Bbox_3 box = CGAL::bbox_3(t.begin(), t.end());
  return std::none_of(soup.faces.begin(), soup.faces.end(), [&](const meshes::Face& f) {
    if(!CGAL::do_overlap(box, soup.points[f[0]].bbox() + soup.points[f[1]].bbox() +
                                  soup.points[f[2]].bbox()))
      return false;
    return brute_force::do_hulls_meet(
        triangle, to_hull<NT>({soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]}));
  });
}

// An L of four cubes of side 4 and a separate one; lattice points are on faces, edges and vertices.
Soup lattice_solid()
{
  return meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 4);
}

// A cavity within the first of these cubes.
Soup lattice_cavity()
{
  Soup soup = meshes::cube(2).inverted();
  for(Point& p : soup.points) p = Point(p.x() + 1, p.y() + 1, p.z() + 1);
  return soup;
}

TEST(Triangle_mesh_domain, takes_other_meshes_kernels_and_maps)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const Soup soup = meshes::cube();
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(meshes::to_mesh(soup), polyhedron);
  EXPECT_TRUE(Mesh_domain(polyhedron).is_inside(Point(.5, .5, .5)));

  CGAL::Surface_mesh<Exact_kernel::Point_3> exact;
  std::vector<Exact_kernel::Point_3> points;
  for(const Point& p : soup.points) points.emplace_back(p.x(), p.y(), p.z());
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.faces, exact);
  for(Exact_kernel::Point_3& p : exact.points()) p = Exact_kernel::Point_3(p.x() / 3, p.y(), p.z());
  const Triangle_mesh_domain_3<Exact_kernel> domain(exact);
  EXPECT_TRUE(domain.is_inside({.3, .5, .5}));
  EXPECT_TRUE(domain.is_inside({1. / 3, .5, .5})) << "the double is less than a third";
  EXPECT_FALSE(domain.is_inside({std::nextafter(1. / 3, 1), .5, .5}));

  Mesh mesh = meshes::to_mesh(soup);
  auto shifted = mesh.add_property_map<Mesh::Vertex_index, Point>("v:shifted").first;
  for(const auto v : mesh.vertices()) shifted[v] = mesh.point(v) + Kernel::Vector_3(5, 0, 0);
  const Mesh_domain moved(mesh, CGAL::parameters::vertex_point_map(shifted));
  EXPECT_FALSE(moved.is_inside(Point(.5, .5, .5)));
  EXPECT_TRUE(moved.is_inside(Point(5.5, .5, .5)));
}

TEST(Triangle_mesh_domain, can_be_moved_and_outlives_its_mesh)
{
  std::vector<Mesh_domain> domains;
  for(int i = 0; i < 3; ++i) domains.emplace_back(meshes::to_mesh(meshes::cube()));
  EXPECT_TRUE(domains[0].is_inside(Point(.5, .5, .5)));
  EXPECT_FALSE(domains[0].is_triangle_inside({.5, .5, .5}, {.5, .5, 1}, {.5, .5, .5}));
  EXPECT_EQ(domains[1].distance(Point(.5, .5, .25)), .25);
}

TEST(Triangle_mesh_domain, refuses_what_bounds_nothing)
{
  Soup open = meshes::cube(), flat = meshes::cube(), infinite = meshes::cube();
  open.faces.pop_back();
  EXPECT_THROW(Mesh_domain(meshes::to_mesh(open)), std::invalid_argument);
  EXPECT_THROW(Mesh_domain{Mesh()}, std::invalid_argument);
  for(Point& p : flat.points) p = Point(p.x(), p.y(), 0);
  EXPECT_THROW(Mesh_domain(meshes::to_mesh(flat)), std::invalid_argument);
  Mesh mesh = meshes::to_mesh(infinite);
  mesh.points()[Mesh::Vertex_index(3)] = Point(infinity, 0, 0);
  EXPECT_THROW(Mesh_domain{mesh}, std::invalid_argument);
  Mesh quads;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), quads);
  EXPECT_THROW(Mesh_domain{quads}, std::invalid_argument);
}

TEST(Triangle_mesh_domain, decides_exactly_on_a_lattice)
{
  // Triangles that touch a face, lie in its plane, end on an edge or a vertex; many are segments or
  // points.
  const Soup solid = lattice_solid();
  const Mesh_domain domain(meshes::to_mesh(solid));
  Random random(3);
  int inside = 0;
  for(int i = 0; i < 4000; ++i) {
    const Point p = lattice_point(random, 9);
    const std::size_t n = i % 2 == 0 ? 9 : 3; // large triangles, and small ones next to p
    const auto shift = n == 9 ? Kernel::Vector_3(0, 0, 0) : p - Point(1, 1, 1);
    const std::array<Point, 3> t = {p, lattice_point(random, n) + shift,
                                    lattice_point(random, n) + shift};
    const bool is_free = does_miss_surface<long>(solid, t);
    ASSERT_EQ(domain.is_triangle_inside(t[0], t[1], t[2]), is_free)
        << t[0] << ", " << t[1] << ", " << t[2];
    inside += domain.is_inside(t[0]) && is_free;
  }
  EXPECT_GT(inside, 100);
}

TEST(Triangle_mesh_domain, decides_exactly_for_segments_points_and_slivers)
{
  const Soup solid = lattice_solid();
  const Mesh_domain domain(meshes::to_mesh(solid));
  Random random(4);
  const double tiny = 0x1p-50;
  for(int i = 0; i < 60; ++i) {
    const Point p = lattice_point(random, 9), q = lattice_point(random, 9);
    const Point near_q(q.x() + tiny * (random.real() - .5), q.y(), q.z() - tiny * random.real());
    const Point near_p(p.x(), p.y() + tiny * (random.real() - .5), p.z());
    for(const std::array<Point, 3>& t :
        {std::array<Point, 3>{p, p, p}, {p, q, p}, {p, q, near_q}, {near_p, q, near_q}})
      ASSERT_EQ(domain.is_triangle_inside(t[0], t[1], t[2]), does_miss_surface<Rational>(solid, t))
          << t[0] << ", " << t[1] << ", " << t[2];
  }
}

TEST(Triangle_mesh_domain, decides_exactly_next_to_a_slanted_face)
{
  // The corner opposite lies within rounding of the plane of the face.
  const Soup solid = meshes::sphere(1, 1);
  const Mesh_domain domain(meshes::to_mesh(solid));
  Random random(5);
  int free = 0, n = 0;
  for(const meshes::Face& f : solid.faces) {
    const Point &a = solid.points[f[0]], &b = solid.points[f[1]], &c = solid.points[f[2]];
    for(int i = 0; i < 3; ++i, ++n) {
      const double s = random.real() / 2, t = random.real() / 2;
      const Point on = a + s * (b - a) + t * (c - a);
      const std::array<Point, 3> triangle = {Point(0, 0, 0), on,
                                             CGAL::midpoint(Point(0, 0, 0), on)};
      const bool is_free = does_miss_surface<Rational>(solid, triangle);
      ASSERT_EQ(domain.is_triangle_inside(triangle[0], triangle[1], triangle[2]), is_free);
      ASSERT_EQ(domain.is_inside(on), is_free) << "the segment from the center ends there";
      free += is_free;
    }
  }
  EXPECT_GT(free, n / 10);
  EXPECT_LT(free, 9 * n / 10);
}

TEST(Triangle_mesh_domain, knows_the_inside_of_a_solid_with_right_angles)
{
  const Mesh_domain domain(meshes::to_mesh(lattice_solid()));
  const auto is_in_cube = [](const Point& p, double x, double y, double z) {
    return x <= p.x() && p.x() <= x + 4 && y <= p.y() && p.y() <= y + 4 && z <= p.z() &&
           p.z() <= z + 4;
  };
  for(int i = 0; i < 1000; ++i) {
    const Point p(i % 10, i / 10 % 10, i / 100);
    // strictly inside iff all eight points around lie in one of the cubes
    bool is_inside = true;
    for(const double dx : {-.5, .5})
      for(const double dy : {-.5, .5})
        for(const double dz : {-.5, .5}) {
          const Point q(p.x() + dx, p.y() + dy, p.z() + dz);
          is_inside = is_inside && (is_in_cube(q, 0, 0, 0) || is_in_cube(q, 4, 0, 0) ||
                                    is_in_cube(q, 0, 4, 0) || is_in_cube(q, 0, 0, 4));
        }
    ASSERT_EQ(domain.is_inside(p), is_inside) << p;
  }
}

// Rays from lattice points meet edges and vertices. Shears keep that so, but not the right angles.
TEST(Triangle_mesh_domain, knows_the_inside_of_lattice_solids_at_every_scale)
{
  Random random(7);
  for(const int exponent : {-60, 0, 52, 100, 300})
    for(const int shear : {0, 1, 2}) {
      const auto place = [&](double x, double y, double z) {
        const double scale = std::ldexp(1., exponent);
        return Point(scale * (x + shear * y), scale * (y + shear * z),
                     scale * (z + (shear > 1) * x));
      };
      Soup soup = lattice_solid() + lattice_cavity();
      for(Point& p : soup.points) p = place(p.x(), p.y(), p.z());
      const Mesh_domain domain(meshes::to_mesh(soup));
      const exact_surface::Surface surface(soup);
      for(int k = 0; k < 200; ++k) {
        const auto coordinate = [&] { return static_cast<double>(random.index(21)) / 2 - 1; };
        const Point p = place(coordinate(), coordinate(), coordinate());
        ASSERT_EQ(domain.is_inside(p), surface.is_inside(p)) << p;
      }
    }
}

// Beside large coordinates the ends of random rays are rounded: CGAL's Side_of_triangle_mesh errs
// here.
TEST(Triangle_mesh_domain, knows_the_inside_far_from_the_origin)
{
  Soup soup = lattice_solid();
  const double far = std::ldexp(1., 52);
  for(Point& p : soup.points) p = Point(p.x() + far, p.y() - far, p.z() + far);
  const Mesh_domain domain(meshes::to_mesh(soup));
  EXPECT_TRUE(domain.is_inside(Point(far + 1, 1 - far, far + 1)));
  EXPECT_TRUE(domain.is_inside(Point(far + 4, 1 - far, far + 1)));
  EXPECT_FALSE(domain.is_inside(Point(far + 4, 4 - far, far + 1)));
  EXPECT_FALSE(domain.is_inside(Point(far - 1, 1 - far, far + 1)));
  EXPECT_FALSE(domain.is_inside(Point(far, 1 - far, far + 1)));
}

TEST(Triangle_mesh_domain, leaves_out_cavities_whatever_their_orientation)
{
  const Soup outer = meshes::sphere(2, 2), inner = meshes::sphere(1, 2);
  const Soup island = meshes::sphere(.25, 1);
  for(const Soup& soup : {outer + inner.inverted() + island, outer + inner + island}) {
    const Mesh_domain domain(meshes::to_mesh(soup), parameters::check_mesh(false));
    EXPECT_TRUE(domain.is_inside(Point(1.5, 0, 0)));
    EXPECT_FALSE(domain.is_inside(Point(.5, 0, 0)));
    EXPECT_TRUE(domain.is_inside(Point(.1, 0, 0)));
    EXPECT_FALSE(domain.is_inside(Point(2.5, 0, 0)));
    EXPECT_FALSE(domain.is_triangle_inside({1.5, 0, 0}, {-1.5, 0, 0}, {0, 0, 0}));
    EXPECT_TRUE(domain.is_triangle_inside({1.5, 0, 0}, {0, 1.5, 0}, {1.5, 0, 0}));
    EXPECT_EQ(domain.distance(Point(1.25, 0, 0)), .25);
    EXPECT_EQ(domain.distance_along(Point(1.25, 0, 0), {-1, 0, 0}, 5), .25);
    EXPECT_NEAR(domain.distance_along(Point(1.25, 0, 0), {1, 0, 0}, 5), .75, 1e-15);
    EXPECT_EQ(domain.distance_along(Point(1.25, 0, 0), {1, 0, 0}, .5), .5);
  }
}

TEST(Triangle_mesh_domain, measures_distances_like_all_faces_together)
{
  const Soup soup = meshes::sphere(1, 2) + meshes::sphere(.4, 2).inverted();
  const Mesh_domain domain(meshes::to_mesh(soup));
  Random random(6);
  for(int i = 0; i < 300; ++i) {
    const Point p = random_point(random, domain.bbox());
    const internal::Vector u = random.direction();
    double squared_distance = infinity, along = infinity;
    const CGAL::Segment_3<Kernel> ray(p, p + 9 * Kernel::Vector_3(u.x(), u.y(), u.z()));
    for(const meshes::Face& f : soup.faces) {
      const Kernel::Triangle_3 t(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
      squared_distance = (std::min)(squared_distance, CGAL::squared_distance(p, t));
      const Kernel::Plane_3 plane = t.supporting_plane();
      if(!CGAL::do_intersect(t, ray)) continue;
      const double rise = plane.orthogonal_vector() * Kernel::Vector_3(u.x(), u.y(), u.z());
      along = (std::min)(along, plane.orthogonal_vector() * (t[0] - p) / rise);
    }
    ASSERT_NEAR(domain.distance(p), std::sqrt(squared_distance), 1e-14);
    const double found = domain.distance_along(p, {u.x(), u.y(), u.z()}, 9);
    ASSERT_NEAR(found, (std::min)(along, 9.), 1e-12);
  }
}

TEST(Triangle_mesh_domain, ends_the_search_for_a_distance_at_a_limit)
{
  const Mesh_domain domain(meshes::to_mesh(lattice_solid()));
  Random random(8);
  for(int k = 0; k < 300; ++k) {
    const Point p = random_point(random, domain.bbox());
    const double distance = domain.distance(p);
    for(const double limit : {0., 0.5 * distance, distance, 2 * distance, 100.})
      EXPECT_EQ(domain.distance_up_to(p, limit), (std::min)(distance, limit));
  }
}

TEST(Triangle_mesh_domain, sees_through_no_edge_and_no_vertex)
{
  // rays along the axes through the middle of a cube whose faces have a vertex there
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}})));
  const Mesh_domain ball(meshes::to_mesh(meshes::sphere(1, 3)));
  for(int axis = 0; axis < 3; ++axis) {
    for(const double sign : {-1., 1.}) {
      internal::Vector u;
      u[axis] = sign;
      EXPECT_EQ(domain.distance_along({1, 1, 1}, {u.x(), u.y(), u.z()}, 9), 1);
      EXPECT_EQ(domain.distance_along({.5, .5, .5}, {u.x(), u.y(), u.z()}, 9), sign < 0 ? .5 : 1.5);
      EXPECT_EQ(ball.distance_along({0, 0, 0}, {u.x(), u.y(), u.z()}, 9), 1);
    }
  }
  const Soup soup = meshes::sphere(1, 3);
  Random random(7);
  for(const meshes::Face& f : soup.faces) {
    const Point &a = soup.points[f[0]], &b = soup.points[f[1]];
    for(const Point& q : {a, a + random.real() * (b - a)}) {
      const double length = std::sqrt(CGAL::squared_distance(q, Point(0, 0, 0)));
      ASSERT_NEAR(
          ball.distance_along({0, 0, 0}, {q.x() / length, q.y() / length, q.z() / length}, 9),
          length, 1e-14);
    }
  }
}

} // namespace test_triangle_mesh_domain
