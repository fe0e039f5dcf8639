// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/shape_test_support.h"

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/bending/Wall_planes.h>
#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// The pieces with which a curve gets its shape, on curves whose shapes are known.
namespace test_shape_projection {

using namespace shape_test;
using internal::Wall_planes;

// The curve after some sweeps, whatever is in its way.
Curve projected(const Curve& curve,
                double bend_radius,
                double strand_distance,
                int sweeps,
                bool is_tense,
                const Wall_planes& walls = Wall_planes(),
                double relaxation = 1)
{
  const Shape_limits shape = limits(curve, bend_radius, strand_distance);
  const Strand_pairs pairs(sequential, curve, shape, 1);
  std::vector<Vector> x = positions(curve);
  internal::Shape_projection(curve, shape, pairs, walls)(x, sweeps, is_tense, relaxation);
  Curve result = curve;
  for(std::size_t v = 0; v < x.size(); ++v)
    internal::Network_editor<Curve>(result).move_node(v, Point(x[v].x(), x[v].y(), x[v].z()));
  return result;
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
  for(const double relaxation : {1., 1.6}) {
    const Curve opened = projected(curve, 1, 0.1, 400, false, Wall_planes(), relaxation);
    EXPECT_TRUE(check(opened, 1, 0.1).bend.is_kept()) << relaxation;
  }
}

TEST(Shape_projection, pushes_strands_apart)
{
  const Curve curve =
      curve_of({segment(9, {-1, 0, 0}, {1, 0, 0}), segment(7, {0, -1, 0.1}, {0, 1, 0.1})});
  EXPECT_TRUE(check(projected(curve, 0.2, 0.5, 100, false), 0.2, 0.5).is_passed());
}

// Strands that were relaxed like corners would crumple.
TEST(Shape_projection, pushes_a_stack_apart_if_over_relaxed)
{
  std::vector<std::vector<Point>> stack;
  for(int k = 0; k < 12; ++k) stack.push_back(segment(5, {0, 0, 0.3 * k}, {2, 0, 0.3 * k}));
  const Curve pushed = projected(curve_of(stack), 0.2, 0.5, 150, true, Wall_planes(), 1.6);
  EXPECT_TRUE(check(pushed, 0.2, 0.5).is_passed());
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
