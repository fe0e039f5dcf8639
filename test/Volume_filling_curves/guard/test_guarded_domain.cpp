// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/guard_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// The guard with a domain: what would go through a wall, however thin, or touch it is refused.
namespace test_guarded_domain {

using namespace guard_test;
using namespace CGAL::Volume_filling_curves;
using exact_surface::Point;
using exact_surface::Soup;
using exact_surface::Surface;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Network = Curve_network_3<>;
using Guard = Isotopy_guard_3<Curve_flow_traits_3<>, Mesh_domain>;
using Count = std::array<std::size_t, 2>;

Network path(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 1; v < points.size(); ++v) edges.push_back({v - 1, v});
  return {points, edges};
}

// A path from one leg through the bottom to the other one, around a wall of that thickness.
struct Around_a_wall
{
  explicit Around_a_wall(double wall) : domain(meshes::to_mesh(exact_surface::two_legs(wall))) {}

  Mesh_domain domain;
  Network network = path({{0.5, 2.5, 0.5}, {0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {1.5, 2.5, 0.5}});
  Guard guard{network, domain};
};

TEST(Guarded_domain, nothing_goes_through_a_thin_wall)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const auto& [wall, distance] :
      {std::pair{1e-1, 0.}, {1e-6, 0.}, {1e-12, 0.}, {0.1, -10.}, {0.1, nan}}) {
    Around_a_wall u(wall);
    u.guard.set_wall_distance(distance);
    EXPECT_FALSE(u.guard.remove_node(1));
    EXPECT_FALSE(u.guard.remove_node(2));
    EXPECT_FALSE(u.guard.insert_node(0, {1.5, 2, 0.5})); // into the other leg
    EXPECT_FALSE(u.guard.insert_node(0, {1 + wall / 2, 2, 0.5}));
    EXPECT_FALSE(u.guard.insert_node(1, {1 + wall / 2, 2, 0.5}));
    EXPECT_FALSE(u.guard.move_node(0, {1.5, 2.5, 0.5}));
    EXPECT_FALSE(u.guard.move_node(0, {1.5, 1.5, 0.25}));
    EXPECT_FALSE(u.guard.move_node(1, {1.5, 2, 0.5}));
    EXPECT_TRUE(u.guard.insert_node(0, {0.75, 2, 0.5}));
    EXPECT_TRUE(u.guard.insert_node(1, {1 + wall / 2, 0.75, 0.5}));
    EXPECT_TRUE(u.guard.move_node(0, {0.25, 2.75, 0.25}));
  }
}

TEST(Guarded_domain, no_step_goes_through_a_thin_wall)
{
  for(const double wall : {1e-1, 1e-6, 1e-12}) {
    Around_a_wall u(wall);
    Targets targets = internal::coordinates(u.network);
    targets.row(0) << 1.75, 2.5, 0.5; // both ends change legs
    targets.row(3) << 0.25, 2.5, 0.5;
    EXPECT_EQ(u.guard.move_nodes(targets), 0);
    const double fraction = u.guard.move_nodes(targets, 1. / 64);
    EXPECT_GT(fraction, 0.1); // up to the wall
    EXPECT_LT(fraction, 0.5);
    const Surface surface(exact_surface::two_legs(wall));
    EXPECT_EQ(surface.count_outside(u.network), Count());
  }
}

TEST(Guarded_domain, nothing_is_swept_across_a_pillar)
{
  std::vector<std::array<int, 3>> ring;
  for(int x = 0; x < 3; ++x)
    for(int y = 0; y < 3; ++y)
      if(x != 1 || y != 1) ring.push_back({x, y, 0});
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels(ring)));
  Network network = path({{0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}, {2.5, 2.5, 0.5}});
  Guard guard(network, domain);
  EXPECT_FALSE(guard.move_node(0, {2.5, 2.25, 0.5}));
  EXPECT_FALSE(guard.move_node(1, {0.5, 2.5, 0.5})); // its edges would be inside again
  EXPECT_FALSE(guard.remove_node(1));
  EXPECT_TRUE(guard.move_node(1, {2.75, 0.25, 0.5}));
}

// Neither edges nor nodes meet the cavity: it pierces the triangle.
TEST(Guarded_domain, nothing_is_swept_across_a_small_cavity)
{
  Soup needle = exact_surface::stretched(meshes::cube(), 0, {4.5, 4.5 + 1e-3});
  needle = exact_surface::stretched(needle, 1, {4.5, 4.5 + 1e-3});
  needle = exact_surface::stretched(needle, 2, {1, 7});
  const Mesh_domain domain(meshes::to_mesh(meshes::cube(8) + needle.inverted()));
  const Network start = path({{2, 4, 4}, {7, 3, 4}});
  Network network = start;
  Guard guard(network, domain);
  EXPECT_FALSE(guard.move_node(1, {7, 7, 4}));
  EXPECT_FALSE(guard.insert_node(0, {5, 6, 4}));
  EXPECT_EQ(contents(network), contents(start));
  EXPECT_TRUE(guard.insert_node(0, {4, 3.5, 4}));
  EXPECT_TRUE(guard.move_node(0, {2, 7, 4})); // not as far as the cavity
}

TEST(Guarded_domain, a_touch_is_refused)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::cube()));
  Network network = path({{0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}});
  Guard guard(network, domain);
  for(const Point& target : {Point(0.5, 0.5, 1), Point(0.5, 0.5, 0), Point(0.25, 0.25, 0),
                             Point(1, 1, 1), Point(0.5, 0, 1), Point(0.5, 0.5, 1.5)}) {
    EXPECT_FALSE(guard.move_node(0, target));
    EXPECT_FALSE(guard.insert_node(0, target));
    Targets targets = internal::coordinates(network);
    targets.row(0) << target.x(), target.y(), target.z();
    EXPECT_EQ(guard.move_nodes(targets), 0);
  }
  EXPECT_TRUE(guard.move_node(0, {0.5, 0.5, std::nextafter(1., 0.)}));
  EXPECT_TRUE(guard.move_node(0, {0.5, 0.5, 1e-300}));
}

TEST(Guarded_domain, a_touch_of_the_edge_of_a_corner_is_refused)
{
  const Mesh_domain domain(meshes::to_mesh(exact_surface::corner_piece()));
  const double below = std::nextafter(0.5, 0.);
  Network network = path({{0.5, 1.5, 0.5}, {0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}});
  {
    Guard guard(network, domain);
    EXPECT_FALSE(guard.remove_node(1)); // the new edge would touch the corner
    EXPECT_FALSE(guard.move_node(1, {1, 1, 0.5}));
    EXPECT_TRUE(guard.move_node(2, {1.5, below, 0.5}));
    EXPECT_TRUE(guard.remove_node(1)); // now it just misses it
  }
  EXPECT_EQ(Surface(exact_surface::corner_piece()).count_outside(network), Count());
}

TEST(Guarded_domain, a_curve_moves_within_a_thin_plate)
{
  for(const double thickness : {1e-3, 1e-9}) {
    const Mesh_domain domain(
        meshes::to_mesh(exact_surface::stretched(meshes::cube(), 2, {0, thickness})));
    const double middle = thickness / 2;
    Network network = path({{0.1, 0.1, middle}, {0.5, 0.1, middle}, {0.9, 0.1, middle}});
    Guard guard(network, domain);
    EXPECT_TRUE(guard.move_node(1, {0.5, 0.9, middle / 2}));
    EXPECT_FALSE(guard.move_node(1, {0.5, 0.9, 2 * middle}));
    EXPECT_FALSE(guard.move_node(1, {0.5, 0.9, -middle}));
    EXPECT_FALSE(guard.insert_node(0, {0.2, 0.2, 3 * middle}));
    EXPECT_TRUE(guard.insert_node(0, {0.2, 0.2, 1.5 * middle}));
  }
}

// Strands that travel together farther than their distance, in whatever order, need several rounds.
TEST(Guarded_domain, a_step_in_several_rounds_stays_inside)
{
  const Mesh_domain domain(
      meshes::to_mesh(exact_surface::scaled(exact_surface::corner_piece(), 4)));
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t k = 0; k < 10; ++k) {
    const double x = 4 + 0.25 * static_cast<double>(3 * k % 10); // up to 6.25
    points.emplace_back(x, 0.5, 1);
    points.emplace_back(x, 0.5, 3);
    edges.push_back({2 * k, 2 * k + 1});
  }
  const Network start(points, edges);
  for(const double way : {0.125, 0.5, 1.5, 1.75 - 1e-12, 1.75, 1.9}) {
    Network network = start;
    Guard guard(network, domain);
    Targets targets = internal::coordinates(network);
    targets.col(0).array() += way;
    EXPECT_EQ(guard.move_nodes(targets, 0.5), way < 1.75 ? 1 : 0.5);
  }
}

TEST(Guarded_domain, an_unbounded_domain_is_none)
{
  const Unbounded_domain_3<> everywhere;
  Network network = path({{0, 0, 0}, {1, 0, 0}});
  Isotopy_guard_3<> guard(network, everywhere);
  EXPECT_TRUE(guard.move_node(0, {-1e150, 0, 0}));
}

// Beyond 1e51, or below 1e-53, the sixth powers of lengths overflow or underflow.
TEST(Guarded_domain, nothing_leaves_a_mesh_of_any_size)
{
  for(const int exponent : {-300, -200, 200, 300}) {
    const double s = std::ldexp(1., exponent);
    Soup soup = exact_surface::two_legs(0.1);
    for(Point& p : soup.points) p = {s * p.x(), s * p.y(), s * p.z()};
    const Mesh_domain domain(meshes::to_mesh(soup));
    const Point p(0.5 * s, 0.5 * s, 0.5 * s);
    EXPECT_NEAR(domain.distance(p) / s, 0.5, 1e-12);
    Network network = path({p, {0.6 * s, 0.5 * s, 0.5 * s}});
    Guard guard(network, domain);
    EXPECT_FALSE(guard.move_node(0, {5 * s, 0.5 * s, 0.5 * s}));
    EXPECT_TRUE(guard.move_node(0, {0.4 * s, 0.5 * s, 0.5 * s}));
  }
}

TEST(Guarded_domain, a_domain_too_small_for_squares_of_its_size_is_refused)
{
  constexpr double size = 1e-165;
  const Box_domain_3<> box(Point(0, 0, 0), Point(size, size, size));
  Network network =
      path({{0.4 * size, 0.5 * size, 0.5 * size}, {0.6 * size, 0.5 * size, 0.5 * size}});
  using Box_guard = Isotopy_guard_3<Curve_flow_traits_3<>, Box_domain_3<>>;
  EXPECT_THROW(Box_guard(network, box), std::invalid_argument);
}

TEST(Guarded_domain, the_brute_force_notices_what_is_outside)
{
  const Surface surface(exact_surface::two_legs(1e-3));
  EXPECT_EQ(surface.count_outside(path({{0.5, 2, 0.5}, {1.5, 2, 0.5}})), (Count{0, 1}));
  EXPECT_EQ(surface.count_outside(path({{0.5, 2, 0.5}, {1, 2, 0.5}})), (Count{1, 1}));
  EXPECT_EQ(surface.count_outside(path({{5, 2, 0.5}, {6, 2, 0.5}})), (Count{2, 1}));
}

} // namespace test_guarded_domain
