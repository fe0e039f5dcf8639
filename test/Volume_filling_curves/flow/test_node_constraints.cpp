// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/untangle.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Nodes that slide on lines, on planes and along boundaries, against shapes known in closed form.
namespace test_node_constraints {

namespace VFC = CGAL::Volume_filling_curves;
using namespace flow_test;
using VFC::Node_constraint;
using Point = Network::Point_3;
using Vector_3 = Network::Traits::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr double rounding = 1e-14; // of coordinates up to 10

Vector position(const Network& curve, std::size_t v)
{
  return internal::to_vector(curve.point(v));
}

// An arc that waves from a to b.
Network wave(const Vector& a, const Vector& b)
{
  constexpr int n = 60;
  std::vector<Vector> points;
  const Vector across = (b - a).unitOrthogonal();
  for(int k = 0; k <= n; ++k) {
    const double t = static_cast<double>(k) / n;
    points.push_back(a + t * (b - a) + 0.3 * std::sin(4 * CGAL_PI * t) * across);
  }
  return path(points);
}

void set_all(Network& curve, const Node_constraint& constraint)
{
  for(const std::size_t v : curve.nodes()) curve.set_constraint(v, constraint);
}

double largest_radius_error(const Network& curve, double radius)
{
  double largest = 0;
  for(const std::size_t v : curve.nodes())
    largest = (std::max)(largest, std::abs(position(curve, v).norm() - radius));
  return largest;
}

TEST(Node_constraint, lets_an_arc_slide_on_two_plates_until_it_is_orthogonal)
{
  constexpr double height = 3;
  const Vector normal = Vector(1, 2, 2) / 3, along = normal.unitOrthogonal();
  Network arc = wave(along, height * normal - along);
  for(const std::size_t v : {std::size_t(0), arc.number_of_nodes() - 1})
    arc.set_constraint(v, Node_constraint::on_plane(arc.point(v), Vector_3(1, 2, 2)));
  const VFC::Untangling_result result =
      VFC::untangle(arc, VFC::parameters::thickness(0.3).tolerance(1e-3));
  EXPECT_EQ(result.status, VFC::Untangling_status::CONVERGED);
  const Vector first = position(arc, 0), last = position(arc, arc.number_of_nodes() - 1);
  EXPECT_NEAR(internal::total_length(arc), height, 1e-5);
  EXPECT_LT((last - first).cross(normal).norm(), 0.01); // 2 at the start
  EXPECT_NEAR(normal.dot(first), 0, rounding);
  EXPECT_NEAR(normal.dot(last), height, rounding);
}

// However near: tension that faded with the length left it more than twice as long as the gap.
TEST(Node_constraint, straightens_an_arc_between_near_plates)
{
  constexpr double r = 0.5;
  for(const double gap : {r, 2 * r, 4 * r, 8 * r}) {
    Network arc = wave({0, 0, 0}, {gap, 0, gap});
    for(const std::size_t v : {std::size_t(0), arc.number_of_nodes() - 1})
      arc.set_constraint(v, Node_constraint::on_plane(arc.point(v), Vector_3(0, 0, 1)));
    const VFC::Untangling_result result =
        VFC::untangle(arc, VFC::parameters::thickness(r).tolerance(1e-3));
    EXPECT_EQ(result.status, VFC::Untangling_status::CONVERGED);
    EXPECT_NEAR(internal::total_length(arc) / gap, 1, 1e-4);
  }
}

TEST(Node_constraint, lets_an_arc_slide_on_two_lines_to_their_common_perpendicular)
{
  Network arc = wave({2, 0, 0}, {0, -1, 1});
  const std::size_t end = arc.number_of_nodes() - 1;
  arc.set_constraint(0, Node_constraint::on_line(Point(5, 0, 0), Vector_3(1, 0, 0)));
  arc.set_constraint(end, Node_constraint::on_line(Point(0, 0, 1), Vector_3(0, -3, 0)));
  VFC::untangle(arc, VFC::parameters::thickness(0.1).tolerance(1e-3));
  const Vector first = position(arc, 0), last = position(arc, arc.number_of_nodes() - 1);
  EXPECT_NEAR(first.x(), 0, 0.01);
  EXPECT_NEAR(last.y(), 0, 0.01);
  EXPECT_EQ(first, Vector(first.x(), 0, 0));
  EXPECT_EQ(last, Vector(0, last.y(), 1));
}

TEST(Node_constraint, lets_a_ring_slide_over_a_sphere_to_its_pole)
{
  constexpr double radius = 2, depth = 0.1, r = 0.25;
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), radius);
  Network ring = internal::closed_network({circle(80, 1.85, {0, 0, 0.5})});
  set_all(ring, Node_constraint::on_boundary(depth));
  VFC::Isotopy_guard_3 guard(ring, ball);
  VFC::Curve_flow_parameters parameters;
  parameters.thickness = r;
  VFC::Curve_flow_3 flow(guard, parameters);
  for(double former = flow.length(); flow.length() > 4 * r; former = flow.length()) {
    ASSERT_TRUE(flow.step());
    ASSERT_LT(flow.length(), former);
    ASSERT_LT(largest_radius_error(ring, radius - depth), 1e-9 * r);
  }
  Vector mean;
  for(const std::size_t v : ring.nodes()) mean += position(ring, v);
  mean /= static_cast<double>(ring.number_of_nodes());
  EXPECT_LT(std::hypot(mean.x(), mean.y()), 0.1 * r);
  EXPECT_GT(mean.z(), 1.85);
}

TEST(Node_constraint, makes_an_arc_on_a_sphere_a_great_circle)
{
  constexpr double radius = 2, depth = 0.1, angle = 2;
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), radius);
  std::vector<Vector> points; // a detour over the north
  for(int k = 0; k <= 60; ++k) {
    const double t = k / 60., longitude = angle * t, latitude = std::sin(CGAL_PI * t);
    points.push_back((radius - depth) * Vector(std::cos(longitude) * std::cos(latitude),
                                               std::sin(longitude) * std::cos(latitude),
                                               std::sin(latitude)));
  }
  Network arc = path(points);
  set_all(arc, Node_constraint::on_boundary(depth));
  arc.pin_ends();
  const auto result = VFC::untangle(arc, ball, VFC::parameters::thickness(0.3).tolerance(1e-3));
  EXPECT_EQ(result.status, VFC::Untangling_status::CONVERGED);
  EXPECT_LT(largest_radius_error(arc, radius - depth), 1e-9);
  for(const std::size_t v : arc.nodes()) EXPECT_NEAR(position(arc, v).z(), 0, 0.03);
  // of chords, up to 0.6 r long
  EXPECT_NEAR(internal::total_length(arc), angle * (radius - depth), 1e-3);
}

// the distance from p to the curve
double distance(const Network& curve, const Vector& p)
{
  double least = std::numeric_limits<double>::infinity();
  for(const std::size_t e : curve.edges())
    least =
        (std::min)(least, internal::squared_distance_to_segment(p, position(curve, curve.source(e)),
                                                                position(curve, curve.target(e))));
  return std::sqrt(least);
}

TEST(Long_node_constraint, lets_a_curve_fill_the_shell_of_a_torus)
{
  Mesh mesh;
  ASSERT_TRUE(CGAL::IO::read_OFF(std::string(VFC_DATA_DIR) + "/torus.off", mesh));
  const VFC::Triangle_mesh_domain_3<> torus(mesh);
  constexpr double r = 0.15, depth = r / 2;
  Polygon ring;
  for(const Vector& p : circle(12, 0.1)) ring.push_back({1.28, p.x(), p.y()});
  Network curve = internal::closed_network({ring});
  set_all(curve, Node_constraint::on_boundary(depth));
  VFC::Isotopy_guard_3 guard(curve, torus);
  VFC::Curve_flow_parameters parameters; // those of the growth of fill()
  parameters.thickness = r;
  parameters.max_radius = 6;
  parameters.screening *= 30;
  parameters.max_displacement = 0.5;
  parameters.spacing = 0.3;
  parameters.number_of_directions = 8;
  VFC::Curve_flow_3 flow(guard, parameters);
  for(int k = 0; k < 80; ++k) ASSERT_TRUE(flow.step());
  for(int k = 0; k < 40; ++k) {
    flow.set_max_displacement(0.5 * std::pow(0.9, k));
    ASSERT_TRUE(flow.step());
  }
  double error = 0, farthest = 0;
  for(const std::size_t v : curve.nodes()) {
    EXPECT_TRUE(torus.is_inside(curve.point(v)));
    error = (std::max)(error, std::abs(torus.distance(curve.point(v)) - depth));
  }
  std::size_t covered = 0;
  for(const auto v : mesh.vertices()) {
    const double d = distance(curve, internal::to_vector(mesh.point(v)));
    farthest = (std::max)(farthest, d);
    covered += d < r ? 1 : 0;
  }
  EXPECT_LT(error, 1e-3 * r);
  EXPECT_LT(farthest, 1.4 * r);
  EXPECT_GT(static_cast<double>(covered), 0.9 * static_cast<double>(mesh.number_of_vertices()));
}

void expect_filling_between_walls(bool is_round)
{
  const VFC::Box_domain_3<> box(Point(0, 0, 0), Point(2, 2, 2));
  Network arc = path({{0.5, 0.5, 0.1}, {0.5, 0.5, 1}, {0.5, 0.5, 1.9}});
  arc.set_constraint(0, Node_constraint::on_plane(arc.point(0), Vector_3(0, 0, 1)));
  arc.set_constraint(2, Node_constraint::on_boundary(0.1));
  const auto result = VFC::fill(arc, box, VFC::parameters::thickness(0.3).round_bends(is_round));
  EXPECT_LT(result.unfilled_fraction, 0.01);
  EXPECT_EQ(result.status, VFC::Filling_status::CONVERGED);
  const Vector first = position(arc, 0);
  EXPECT_NE(first, Vector(0.5, 0.5, 0.1));
  EXPECT_EQ(first.z(), 0.1);
  EXPECT_NEAR(box.distance(arc.point(arc.number_of_nodes() - 1)), 0.1, 1e-9);
  if(is_round) {
    EXPECT_GE(VFC::min_bend_radius(arc), 0.85 * 0.3 * (1 - 1e-9));
  }
}

TEST(Node_constraint, lets_the_ends_of_a_filling_slide_on_two_walls)
{
  expect_filling_between_walls(false);
  expect_filling_between_walls(true);
}

// A ring in the shell of a ball, beside an arc with free nodes.
Network arc_beside_sliding_ring(double radius)
{
  Network curves(std::vector<std::vector<Point>>{
      {{-0.1, 0, 0}, {0, 0.1, 0}, {0.1, 0, 0}},
      {{0, 0, radius}, {0.1, 0, radius}, {0, 0.1, radius}, {0, 0, radius}}});
  for(std::size_t v = curves.first_node(1); v < curves.number_of_nodes(); ++v)
    curves.set_constraint(v, Node_constraint::on_boundary(0.1));
  return curves;
}

TEST(Node_constraint, of_all_nodes_of_a_component_lets_no_fingers_grow)
{
  const VFC::Ball_domain_3<> ball(Point(0, 0, 0), 1);
  const auto asked_for = VFC::parameters::thickness(0.3);
  for(const bool has_pin : {false, true}) {
    Network curves = arc_beside_sliding_ring(0.9);
    if(has_pin) curves.set_pinned(3);
    try {
      VFC::fill(curves, ball, asked_for);
      FAIL();
    } catch(const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(),
                   "all nodes of component 1, from node 3 on, slide or are pinned: fingers would "
                   "leave the sets on which they slide; Filling_start::CIRCLE grows without "
                   "fingers");
    }
    EXPECT_EQ(curves.number_of_nodes(), 6u);
  }
}

TEST(Node_constraint, takes_all_finite_points)
{
  const Point far(1e308, 1e308, 1e308);
  EXPECT_EQ(Node_constraint::on_plane(far, Vector_3(0, 0, 1)).point()[2], 1e308);
}

TEST(Node_constraint, passes_to_nodes_inserted_between_nodes_that_slide_together)
{
  const Node_constraint none, pin = Node_constraint::fixed();
  const auto plane = Node_constraint::on_plane(Point(0, 0, 0), Vector_3(0, 0, 2));
  const auto line = Node_constraint::on_line(Point(0, 0, 0), Vector_3(1, 0, 0));
  struct Case
  {
    Node_constraint first, second, between;
  };
  for(const Case& c : {Case{plane, plane, plane}, Case{plane, pin, plane}, Case{pin, plane, plane},
                       Case{plane, none, none}, Case{plane, line, none}, Case{pin, pin, none}}) {
    Network arc = path({{0, 0, 0}, {2, 0, 0}});
    arc.set_constraint(0, c.first);
    arc.set_constraint(1, c.second);
    VFC::Isotopy_guard_3 guard(arc);
    ASSERT_TRUE(guard.insert_node(0, Point(1, 0, 0)));
    EXPECT_EQ(arc.constraint(2), c.between);
    guard.set_constraint(2, plane);
    EXPECT_EQ(guard.remove_node(2), c.between == plane);
    guard.set_constraint(2, none);
    EXPECT_EQ(guard.remove_node(2), c.between != plane);
  }
}

TEST(Node_constraint, is_kept_in_the_state_of_a_run)
{
  Network arc = path({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}});
  arc.set_constraint(0, Node_constraint::on_plane(Point(0, 0, 0), Vector_3(1, 2, 3)));
  arc.set_constraint(1, Node_constraint::on_boundary(0.1));
  arc.set_pinned(3);
  internal::Byte_archive written;
  internal::copy_curve(written, arc);
  Network copy = path({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}});
  internal::Byte_archive read(written.bytes());
  internal::copy_curve(read, copy);
  for(const std::size_t v : arc.nodes()) EXPECT_EQ(copy.constraint(v), arc.constraint(v));
}

TEST(Node_constraint, is_scaled_with_a_curve)
{
  Network arc = path({{0, 0, 0}, {1, 0, 0}});
  arc.set_constraint(0, Node_constraint::on_line(Point(1, 2, 3), Vector_3(0, 1, 0)));
  arc.set_constraint(1, Node_constraint::on_boundary(0.5));
  const Network larger = internal::scaled(arc, 4);
  EXPECT_EQ(larger.constraint(0), Node_constraint::on_line(Point(4, 8, 12), Vector_3(0, 1, 0)));
  EXPECT_EQ(larger.constraint(1), Node_constraint::on_boundary(2));
}

TEST(Node_constraint, refuses_what_is_no_set)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Point origin(0, 0, 0);
  EXPECT_THROW(Node_constraint::on_plane(origin, Vector_3(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(Node_constraint::on_line(origin, Vector_3(0, infinity, 0)), std::invalid_argument);
  EXPECT_THROW(Node_constraint::on_line(Point(0, 0, infinity), Vector_3(0, 1, 0)),
               std::invalid_argument);
  for(const double distance : {0., -1., infinity, std::nan("")})
    EXPECT_THROW(Node_constraint::on_boundary(distance), std::invalid_argument);
}

TEST(Node_constraint, to_a_boundary_needs_a_domain)
{
  Network arc = path({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  arc.set_constraint(1, Node_constraint::on_boundary(0.5));
  try {
    VFC::untangle(arc);
    FAIL();
  } catch(const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "node 1 slides along the boundary, but there is no domain");
  }
  VFC::Isotopy_guard_3 guard(arc);
  EXPECT_THROW(VFC::Curve_flow_3 flow(guard), std::invalid_argument);
  EXPECT_EQ(arc.number_of_nodes(), 3u);
}

} // namespace test_node_constraints
