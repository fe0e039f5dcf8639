// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/bending/Wall_planes.h>
#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

// The pieces with which a curve gets its shape, on curves whose shapes are known.
namespace test_shape_projection {

using namespace fill_test;
namespace internal = VFC::internal;
using internal::Shape_check;
using internal::Shape_goal;
using internal::Shape_limits;
using internal::Strand_pairs;
using internal::Strand_paths;
using internal::Vector;
using internal::Wall_planes;

constexpr CGAL::Sequential_tag sequential{};

std::vector<Point> ring(std::size_t n, double radius, const Vector& center = Vector())
{
  std::vector<Point> points;
  for(std::size_t k = 0; k <= n; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k % n) / static_cast<double>(n);
    points.emplace_back(center.x() + radius * std::cos(angle),
                        center.y() + radius * std::sin(angle), center.z());
  }
  return points;
}

std::vector<Point> segment(std::size_t n, const Vector& a, const Vector& b)
{
  std::vector<Point> points;
  for(std::size_t k = 0; k <= n; ++k) {
    const Vector x = a + static_cast<double>(k) / static_cast<double>(n) * (b - a);
    points.emplace_back(x.x(), x.y(), x.z());
  }
  return points;
}

Curve curve_of(const std::vector<std::vector<Point>>& polylines)
{
  return Curve(polylines);
}

Shape_limits limits(const Curve& curve, double bend_radius, double strand_distance)
{
  Shape_goal goal;
  goal.bend_radius.length = bend_radius;
  goal.strand_distance.length = strand_distance;
  return Shape_limits(curve, goal, std::vector<double>(curve.number_of_nodes(), 1));
}

std::vector<Vector> positions(const Curve& curve)
{
  std::vector<Vector> x;
  for(const Point& p : curve.points()) x.push_back(internal::to_vector(p));
  return x;
}

// The curve after some sweeps, whatever is in its way.
Curve projected(const Curve& curve,
                double bend_radius,
                double strand_distance,
                int sweeps,
                bool is_tense,
                const Wall_planes& walls = Wall_planes())
{
  const Shape_limits shape = limits(curve, bend_radius, strand_distance);
  const Strand_pairs pairs(sequential, curve, shape, 1);
  std::vector<Vector> x = positions(curve);
  internal::Shape_projection(curve, shape, pairs, walls)(x, sweeps, is_tense);
  Curve result = curve;
  for(std::size_t v = 0; v < x.size(); ++v)
    internal::Network_editor<Curve>(result).move_node(v, Point(x[v].x(), x[v].y(), x[v].z()));
  return result;
}

Shape_check check(const Curve& curve, double bend_radius, double strand_distance)
{
  return Shape_check(sequential, curve, limits(curve, bend_radius, strand_distance));
}

TEST(Shape_check, finds_the_bend_radius_of_a_ring)
{
  const Curve curve = curve_of({ring(12, 2)});
  const double inscribed = 2 * std::cos(CGAL_PI / 12); // of the arcs that touch the edges' middles
  EXPECT_NEAR(check(curve, 1, 1).bend.value, inscribed, 1e-12);
  EXPECT_TRUE(check(curve, inscribed, 1).is_passed());
  EXPECT_FALSE(check(curve, 1.001 * inscribed, 1).is_passed());
}

TEST(Shape_check, finds_the_distance_of_strands)
{
  const Curve curve =
      curve_of({segment(9, {-1, 0, 0}, {1, 0, 0}), segment(7, {0, -1, 0.3}, {0, 1, 0.3})});
  const Shape_check result = check(curve, 0.1, 0.5);
  EXPECT_NEAR(result.strands.value, 0.3, 1e-12);
  EXPECT_NEAR(result.strands.share, 0.6, 1e-12);
  EXPECT_TRUE(check(curve, 0.1, 0.3).is_passed());
  EXPECT_FALSE(result.is_passed());
}

// Half of a turn is one strand, the legs of a hairpin are two.
TEST(Shape_check, leaves_out_the_other_side_of_a_bend)
{
  const std::vector<Point> turn = ring(24, 0.6);
  std::vector<Point> hairpin(turn.begin(), turn.begin() + 13);
  EXPECT_TRUE(check(curve_of({hairpin}), 0.5, 1.8).strands.is_kept());
  const std::vector<Point> left = segment(10, {-0.6, 0, 0}, {-0.6, -4, 0});
  const std::vector<Point> right = segment(10, {0.6, -4, 0}, {0.6, 0, 0});
  hairpin.insert(hairpin.begin(), right.begin(), right.end() - 1);
  hairpin.insert(hairpin.end(), left.begin() + 1, left.end());
  EXPECT_NEAR(check(curve_of({hairpin}), 0.5, 1.8).strands.value, 1.2, 1e-9);
}

TEST(Strand_pairs, are_those_nearer_than_the_mean_of_their_limits)
{
  std::vector<std::vector<Point>> strands;
  for(int k = 0; k < 12; ++k)
    strands.push_back(segment(6, Vector(0.3 * k * k, 0, 0), Vector(0.3 * k * k, 1, 0.2 * k)));
  const Curve curve = curve_of(strands);
  std::vector<double> thickness;
  for(const Point& p : curve.points()) thickness.push_back(0.02 + 0.5 * p.x());
  Shape_goal goal;
  goal.strand_distance.in_thickness = 1;
  const Strand_pairs pairs(sequential, curve, Shape_limits(curve, goal, thickness), 0);
  std::set<std::array<std::size_t, 2>> found;
  for(const auto& [e, f] : pairs.pairs()) found.insert({e, f});
  EXPECT_EQ(found.size(), pairs.pairs().size());
  std::size_t near = 0, far = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    for(std::size_t f = 0; f < e; ++f) {
      if(curve.component(curve.source(e)) == curve.component(curve.source(f))) continue;
      const auto end = [&](std::size_t k, int i) {
        return internal::to_vector(curve.point(i == 0 ? curve.source(k) : curve.target(k)));
      };
      const bool is_near =
          internal::squared_segment_distance(end(e, 0), end(e, 1), end(f, 0), end(f, 1)) <
          pairs.distance(e, f) * pairs.distance(e, f);
      ++(is_near ? near : far);
      if(is_near) {
        EXPECT_EQ(found.count({e, f}), 1u) << e << ' ' << f;
      }
    }
  EXPECT_GT(near, 100u);
  EXPECT_GT(far, 100u);
}

TEST(Strand_paths, go_once_along_every_edge)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, -1, 0}, {3, 0, 0}};
  const Curve theta(
      points, std::vector<std::array<std::size_t, 2>>{{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}});
  const Strand_paths paths(theta);
  std::size_t edges = 0;
  for(const auto& path : paths.paths()) edges += path.number_of_edges();
  EXPECT_EQ(edges, theta.number_of_edges());
  EXPECT_EQ(Strand_paths(curve_of({ring(7, 1)})).paths().front().size(), 7u);
}

TEST(Shape_projection, leaves_a_curve_within_its_limits)
{
  const Curve curve = curve_of({ring(30, 2)});
  const std::vector<Vector> before = positions(curve);
  const std::vector<Vector> after = positions(projected(curve, 1, 1, 20, true));
  for(std::size_t v = 0; v < before.size(); ++v) EXPECT_LT((after[v] - before[v]).norm(), 1e-12);
}

TEST(Shape_projection, ends_with_the_run)
{
  const Curve curve = curve_of({ring(40, 1)});
  const Shape_limits shape = limits(curve, 2, 1);
  const Strand_pairs pairs(sequential, curve, shape, 1);
  const Wall_planes walls;
  const internal::Shape_projection projection(curve, shape, pairs, walls);
  std::vector<Vector> x = positions(curve);
  internal::Run_watch watch(0);
  const internal::Watched_scope scope(&watch);
  EXPECT_THROW(projection(x, 1, false), internal::Run_stopped);
}

TEST(Shape_projection, widens_a_ring_that_is_too_small)
{
  const Curve curve = curve_of({ring(12, 0.1, {3, 1, 2})});
  const Curve wide = projected(curve, 1, 1, 400, false);
  EXPECT_GE(check(wide, 1, 1).bend.value, 1);
  EXPECT_LT(VFC::length(wide), 8);
}

TEST(Shape_projection, opens_a_corner)
{
  std::vector<Point> angle = segment(20, {0, 0, 0}, {3, 0, 0});
  const std::vector<Point> leg = segment(20, {3, 0, 0}, {3, 3, 0});
  angle.insert(angle.end(), leg.begin() + 1, leg.end());
  const Curve curve = curve_of({angle});
  EXPECT_LT(check(curve, 1, 0.1).bend.value, 0.2);
  EXPECT_TRUE(check(projected(curve, 1, 0.1, 400, false), 1, 0.1).bend.is_kept());
}

TEST(Shape_projection, pushes_strands_apart)
{
  const Curve curve =
      curve_of({segment(9, {-1, 0, 0}, {1, 0, 0}), segment(7, {0, -1, 0.1}, {0, 1, 0.1})});
  EXPECT_TRUE(check(projected(curve, 0.2, 0.5, 100, false), 0.2, 0.5).is_passed());
}

TEST(Shape_projection, leaves_pinned_nodes_and_coordinate_planes)
{
  Curve curve = curve_of({ring(12, 0.3), segment(8, {-2, 0.4, 0}, {2, 0.4, 0})});
  for(const std::size_t v : {0u, 5u}) curve.set_pinned(v);
  const std::vector<Vector> before = positions(curve);
  const std::vector<Vector> after = positions(projected(curve, 1, 1, 50, false));
  for(std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_EQ(after[v].z(), 0);
    if(curve.is_pinned(v)) {
      EXPECT_EQ(after[v], before[v]);
    }
  }
}

// Along its own strand and the one beside it, but not on a strand far away.
TEST(Nodes_near, are_on_the_same_strand_and_on_the_one_beside_it)
{
  const Curve curve =
      curve_of({segment(40, {0, 0, 0}, {4, 0, 0}), segment(40, {0, 0.2, 0}, {4, 0.2, 0}),
                segment(40, {0, 2, 0}, {4, 2, 0})});
  const Strand_pairs pairs(sequential, curve, limits(curve, 0.1, 0.25), 0);
  const std::vector<bool> near = internal::nodes_near(curve, pairs, {20});
  for(std::size_t v = 0; v <= 40; ++v) {
    EXPECT_EQ(near[v], v >= 12 && v <= 28) << v;
    if(v >= 12 && v <= 28) {
      EXPECT_TRUE(near[41 + v]) << v;
    }
    EXPECT_FALSE(near[82 + v]) << v;
  }
  EXPECT_FALSE(near[41]);
}

TEST(Shape_projection, moves_only_what_it_may)
{
  const Curve curve =
      curve_of({segment(10, {0, 0, 0}, {1, 0, 0}), segment(10, {0, 0.1, 0}, {1, 0.1, 0})});
  const Shape_limits shape = limits(curve, 0.1, 0.2);
  const Strand_pairs pairs(sequential, curve, shape, 1);
  const Wall_planes walls;
  internal::Shape_projection projection(curve, shape, pairs, walls);
  std::vector<bool> moving(curve.number_of_nodes(), false);
  for(std::size_t v = 11; v < 22; ++v) moving[v] = true;
  projection.move_only(moving);
  const std::vector<Vector> before = positions(curve);
  std::vector<Vector> x = before;
  projection(x, 20, true);
  for(std::size_t v = 0; v < x.size(); ++v)
    if(moving[v])
      EXPECT_GE(x[v].y(), 0.199) << v;
    else
      EXPECT_EQ(x[v], before[v]) << v;
}

TEST(Strand_pairs, edges_surely_apart_are_apart)
{
  internal::Random_source random(1);
  const auto point = [&] { return Vector(random.real(), random.real(), random.real()); };
  int apart = 0;
  for(int k = 0; k < 10000; ++k) {
    const Vector a = point(), b = point(), c = point() + 2 * point(), d = c + point() - point();
    const double distance = std::sqrt(internal::squared_segment_distance(a, b, c, d));
    EXPECT_FALSE(Strand_pairs::are_surely_apart(1.000001 * distance, a, b, c, d));
    apart += Strand_pairs::are_surely_apart(0.8 * distance, a, b, c, d);
  }
  EXPECT_GT(apart, 5000);
}

TEST(Strand_pairs, edges_are_surely_apart_or_not_at_any_scale)
{
  for(const double s : {1e-140, 1e-100, 1., 1e100, 1e140}) {
    const Vector a(-s, 0, 0), b(s, 0, 0), c(0, -s, 0.5 * s), d(0, s, 0.5 * s);
    EXPECT_FALSE(Strand_pairs::are_surely_apart(0.6 * s, a, b, c, d));
    EXPECT_TRUE(Strand_pairs::are_surely_apart(0.4 * s, a, b, c, d));
    EXPECT_FALSE(Strand_pairs::are_surely_apart(0.1 * s, a, b, {0, -s, 0}, {0, s, 0}));
  }
}

TEST(Strand_pairs, edges_one_behind_the_other_on_parallel_strands_are_surely_apart)
{
  const Vector a(0, 0, 0), b(1, 0, 0), c(3, 2, 0), d(4, 2, 0); // at a distance of 2.8
  EXPECT_TRUE(Strand_pairs::are_surely_apart(2.7, a, b, c, d));
}

TEST(Projected_nodes, ranges_have_all_indices_near_moving_nodes_and_no_others)
{
  const Curve curve = curve_of({ring(30, 1), segment(30, {0, 0, 5}, {3, 0, 5})});
  for(const std::vector<std::size_t>& moving :
      {std::vector<std::size_t>{}, {0}, {29}, {3, 12, 13, 31, 45, 60}, {28, 2, 30}}) {
    internal::Projected_nodes nodes(curve);
    std::vector<bool> marks(curve.number_of_nodes(), false);
    for(const std::size_t v : moving) marks[v] = true;
    nodes.move_only(marks);
    for(const auto& path : nodes.paths())
      for(const std::size_t reach : {0u, 1u, 2u, 4u, 8u}) {
        const std::size_t end = path.is_closed ? path.end : path.end - reach;
        std::vector<std::size_t> expected, found;
        for(std::size_t i = path.begin; i < end; ++i)
          for(std::size_t k = 0; k <= reach; ++k)
            if(!nodes.is_held(nodes.node(path, i + k))) {
              expected.push_back(i);
              break;
            }
        for(const auto& [first, last] : nodes.moving_ranges(path, end, reach))
          for(std::size_t i = first; i < last; ++i) found.push_back(i);
        EXPECT_EQ(found, expected) << reach;
      }
  }
}

TEST(Wall_planes, push_nodes_inside)
{
  const VFC::Box_domain_3<Kernel> box({0, 0, 0}, {4, 4, 4});
  const Curve curve = curve_of({segment(8, {0.01, 1, 2}, {0.02, 3, 2})});
  Wall_planes walls;
  walls.find(curve, internal::Boundary(box), std::vector<double>(curve.number_of_nodes(), 0.1));
  for(const Vector& x : positions(projected(curve, 0.1, 0.1, 1, false, walls)))
    EXPECT_NEAR(x.x(), 0.1, 1e-6);
}

// The ends of the edge keep their distance from the ball, its middle does not.
TEST(Wall_planes, push_edges_inside)
{
  const auto between_balls = [](const Point& p) {
    return std::abs(std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z()) - 2) - 1;
  };
  const VFC::Implicit_domain_3 domain(between_balls, CGAL::Bbox_3(-3, -3, -3, 3, 3, 3));
  const Curve curve = curve_of({{{-1, 1.01, 0}, {1, 1.01, 0}, {2, 0, 1}}});
  Wall_planes walls;
  walls.find(curve, internal::Boundary(domain), {0.1, 0.1, 0.1});
  std::vector<Vector> x = positions(curve);
  walls.push_inside(x, {1, 1, 1});
  EXPECT_NEAR(x[0].y(), 1.1, 1e-6);
  EXPECT_NEAR(x[1].y(), 1.1, 1e-6);
  EXPECT_EQ(x[2].y(), 0);
}

} // namespace test_shape_projection
