// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace test_grow_fingers {

using namespace CGAL::Volume_filling_curves;
namespace np = CGAL::Volume_filling_curves::parameters;
using Network = Curve_network_3<>;
using Point = Network::Point_3;
using Ball = Ball_domain_3<>;
using Box = Box_domain_3<>;

Network triangle(const Point& p, double size)
{
  return {{p, Point(p.x() + size, p.y(), p.z()), Point(p.x(), p.y() + size, p.z())},
          {{0, 1}, {1, 2}, {2, 0}}};
}

template <typename Domain, typename Parameters>
Finger_growth grow(Network& curve, const Domain& domain, const Parameters& parameters)
{
  Isotopy_guard_3 guard(curve, domain);
  return grow_fingers(guard, parameters);
}

TEST(Grow_fingers, reaches_all_over_a_ball_by_isotopy)
{
  const Ball ball(Point(0, 0, 0), 1);
  const Network start = triangle(Point(0, 0, 0), 0.1);
  Network curve = start;
  Isotopy_guard_3 guard(curve, ball);
  guard.start_recording();
  const Finger_growth growth = grow_fingers(guard, np::thickness(0.1));
  EXPECT_GT(growth.number_of_points, 100u);
  EXPECT_GE(growth.number_of_fingers, growth.number_of_points * 99 / 100);
  EXPECT_GE(curve.number_of_nodes(), 3 + 3 * growth.number_of_fingers);
  EXPECT_FALSE(curve.has_garbage());
  EXPECT_TRUE(is_embedded(curve));
  EXPECT_TRUE(verify_certificate(guard.certificate(), start, curve, ball).is_valid);
  const Domain_samples_3 samples(ball, 5000);
  for(const double d : sample_distances(curve, samples)) EXPECT_LT(d, 5 * 0.1);
}

TEST(Grow_fingers, reaches_around_a_wall_of_a_mesh)
{
  const Triangle_mesh_domain_3<> legs(meshes::to_mesh(exact_surface::two_legs(0.1)));
  Network curve = triangle(Point(0.4, 2.5, 0.5), 0.1);
  const Finger_growth growth = grow(curve, legs, np::thickness(0.1));
  EXPECT_GE(growth.number_of_fingers, growth.number_of_points * 95 / 100);
  double deepest = 0; // in the other leg
  for(const Point& p : curve.points())
    if(p.x() > 1.1) deepest = (std::max)(deepest, p.y());
  EXPECT_GT(deepest, 2.5);
  const exact_surface::Surface surface(exact_surface::two_legs(0.1));
  EXPECT_EQ(surface.count_outside(curve), (std::array<std::size_t, 2>{0, 0}));
}

// Edges between two sliding nodes carry no fingers, even if no node is free.
TEST(Grow_fingers, leaves_sliding_nodes_on_their_plane)
{
  const auto plane = Node_constraint::on_plane(Point(0, 0, 0), Point(0, 0, 1));
  const Ball ball(Point(0, 0, 0), 1);
  for(const bool has_pinned_edge : {false, true}) {
    Network curve = triangle(Point(0, 0, 0), 0.1);
    for(const std::size_t v : curve.nodes()) curve.set_constraint(v, plane);
    curve.set_pinned(0);
    if(!has_pinned_edge) {
      EXPECT_THROW(grow(curve, ball, np::thickness(0.1)), std::invalid_argument);
      EXPECT_EQ(curve.number_of_nodes(), 3u);
      continue;
    }
    curve.set_pinned(1);
    EXPECT_GT(grow(curve, ball, np::thickness(0.1)).number_of_fingers, 100u);
    for(const std::size_t v : curve.nodes())
      if(!curve.is_free(v)) {
        EXPECT_EQ(curve.point(v).z(), 0);
      }
  }
}

// The neck is as wide as the thickness. Straight fingers reach 7 of 13 targets.
TEST(Grow_fingers, gets_through_a_neck_by_isotopy)
{
  const auto mesh = meshes::to_mesh(exact_surface::two_chambers());
  const Triangle_mesh_domain_3<> chambers(mesh);
  for(const std::size_t seed : {0u, 1u, 2u, 3u, 4u}) {
    const Network start = triangle(Point(2.4, 0.3, 0.6), 0.1);
    Network curve = start;
    Isotopy_guard_3 guard(curve, chambers);
    guard.start_recording();
    const Finger_growth growth = grow_fingers(guard, np::thickness(0.2).random_seed(seed));
    EXPECT_GT(growth.number_of_points, 8u);
    EXPECT_EQ(growth.number_of_fingers, growth.number_of_points) << seed;
    EXPECT_TRUE(is_embedded(curve));
    EXPECT_TRUE(verify_certificate(guard.certificate(), start, curve, mesh).is_valid);
  }
}

// Each component gets as many nodes, hence about as much of the box, as the other.
TEST(Grow_fingers, shares_the_volume_between_components)
{
  const Box box(Point(0, 0, 0), Point(2, 1, 1));
  Network curve({Point(0.2, 0.4, 0.4), Point(0.3, 0.4, 0.4), Point(0.2, 0.5, 0.4),
                 Point(0.4, 0.6, 0.6), Point(0.5, 0.6, 0.6), Point(0.4, 0.7, 0.6)},
                {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
  grow(curve, box, np::thickness(0.07));
  std::array<double, 2> nodes{0, 0};
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) ++nodes[curve.component(v)];
  EXPECT_GT(nodes[0] + nodes[1], 300);
  EXPECT_NEAR(nodes[0] / nodes[1], 1, 0.15);
}

TEST(Grow_fingers, keeps_pinned_ends_and_grows_from_a_single_long_edge)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Point a(0.01, 0.5, 0.5), b(0.99, 0.5, 0.5);
  Network curve({a, b}, {{0, 1}});
  curve.pin_ends();
  const Finger_growth growth = grow(curve, box, np::thickness(0.08));
  EXPECT_GE(growth.number_of_fingers, growth.number_of_points * 95 / 100);
  EXPECT_EQ(curve.point(0), a);
  EXPECT_EQ(curve.point(curve.number_of_nodes() - 1), b);
}

TEST(Grow_fingers, takes_a_thickness_that_varies)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  Network curve = triangle(Point(0.5, 0.5, 0.5), 0.03);
  grow(curve, box, np::thickness([](const Point& p) { return 0.03 + 0.07 * p.x(); }));
  std::array<int, 2> nodes{0, 0};
  for(const Point& p : curve.points()) ++nodes[p.x() > 0.5];
  EXPECT_GT(nodes[0], 2 * nodes[1]);
  EXPECT_GT(nodes[1], 30);
}

// The cube around the box, which is divided, is larger.
TEST(Grow_fingers, asks_for_the_thickness_in_the_box_only)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  Network curve = triangle(Point(0.5, 0.5, 0.5), 0.03);
  const auto growth =
      grow(curve, box, np::thickness([](const Point& p) { return 0.1 - 0.09 * p.x(); }));
  EXPECT_GT(growth.number_of_fingers, 100u);
}

TEST(Grow_fingers, leaves_no_garbage_when_it_is_stopped)
{
  const Ball ball(Point(0, 0, 0), 1);
  Network curve = triangle(Point(0, 0, 0), 0.1);
  const auto progress = [](const Run_progress& p) -> bool {
    if(p.fraction > 0.25) throw std::runtime_error("stop");
    return true;
  };
  EXPECT_THROW(grow(curve, ball, np::thickness(0.03).progress(progress)), std::runtime_error);
  EXPECT_FALSE(curve.has_garbage());
}

TEST(Grow_fingers, scales_and_depends_on_the_seed)
{
  Network small = triangle(Point(0, 0, 0), 0.125), large = triangle(Point(0, 0, 0), 0.5);
  Network other = small;
  grow(small, Ball(Point(0, 0, 0), 1), np::thickness(0.2));
  grow(large, Ball(Point(0, 0, 0), 4), np::thickness(0.8));
  grow(other, Ball(Point(0, 0, 0), 1), np::thickness(0.2).random_seed(1));
  ASSERT_EQ(small.number_of_nodes(), large.number_of_nodes());
  for(std::size_t v = 0; v < small.number_of_nodes(); ++v) {
    const Point& p = small.point(v);
    EXPECT_EQ(Point(4 * p.x(), 4 * p.y(), 4 * p.z()), large.point(v));
  }
  EXPECT_NE(other.number_of_nodes(), 0u);
  EXPECT_NE(other.point(1), small.point(1));
}

TEST(Grow_fingers, refuses_what_it_cannot_use_and_ends_in_time)
{
  const Ball ball(Point(0, 0, 0), 1);
  Network curve = triangle(Point(0, 0, 0), 0.1);
  EXPECT_THROW(grow(curve, ball, np::default_values()), std::invalid_argument);
  EXPECT_THROW(grow(curve, ball, np::thickness(-1.)), std::invalid_argument);
  EXPECT_THROW(grow(curve, ball, np::thickness(1e-9)), std::invalid_argument);
  EXPECT_THROW(grow(curve, ball, np::thickness([](const Point&) { return 1e-9; })),
               std::invalid_argument);
  for(const double r : {0.1, 1e-4}) // with the second one edges are long
    EXPECT_EQ(grow(curve, ball, np::thickness(r).time_limit(0)).number_of_fingers, 0u);
  EXPECT_EQ(curve.number_of_nodes(), 3u);
}

} // namespace test_grow_fingers
