// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/shape_test_support.h"

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

// Which pairs of edges are of different strands, and near each other.
namespace test_strand_pairs {

using namespace shape_test;

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

// Half of the distance was required there, and a strand was pushed off a ray for ever.
TEST(Strand_pairs, have_no_limit_next_to_closing_rays)
{
  const Curve curve =
      curve_of({segment(9, {0, 0, 0}, {1, 0, 0}), segment(9, {0, 0.1, 0}, {1, 0.1, 0})});
  Shape_limits shape = limits(curve, 0, 0.5);
  for(const std::size_t v : curve.nodes())
    if(curve.point(v).y() > 0) shape.strand_distance[v] = 0; // as in a ray
  const Strand_pairs pairs(sequential, curve, shape, 0);
  EXPECT_TRUE(Shape_check(curve, shape, pairs).is_passed());
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

} // namespace test_strand_pairs
