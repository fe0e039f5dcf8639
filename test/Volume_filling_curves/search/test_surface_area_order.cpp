// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/search/Nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/search/Surface_area_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace test_surface_area_order {

using CGAL::Bbox_3;
using CGAL::Volume_filling_curves::internal::Box_tree;
using CGAL::Volume_filling_curves::internal::Nearest_first_descent;
using CGAL::Volume_filling_curves::internal::squared_distance_to_box;
using CGAL::Volume_filling_curves::internal::Surface_area_order;
using CGAL::Volume_filling_curves::internal::Vector;
using Boxes = std::vector<Bbox_3>;
using Random = std::mt19937;

double uniform(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector random_point(double reach, Random& random)
{
  const double x = uniform(-reach, reach, random), y = uniform(-reach, reach, random);
  return {x, y, uniform(-reach, reach, random)};
}

Vector rounded(const Vector& p)
{
  return {std::round(p.x()), std::round(p.y()), std::round(p.z())};
}

Bbox_3 box_between(const Vector& p, const Vector& q)
{
  const Vector low = p.cwiseMin(q), high = p.cwiseMax(q);
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

// Boxes of all sizes about places of all kinds: spread, in lattice points, on a line, in one point,
// beyond the range of squares.
std::vector<Boxes> box_sets()
{
  Random random(1);
  std::vector<Boxes> sets;
  for(const std::size_t n : {0u, 1u, 2u, 3u, 4u, 5u, 17u, 300u})
    for(const double reach : {5., 1e-310, 8e307})
      for(const double shrinkage : {0., 1., 30.}) {
        Boxes spread, lattice, line, point;
        for(std::size_t i = 0; i < n; ++i) {
          const double size = reach * std::exp(-uniform(0, shrinkage, random)) / 4;
          const Vector p = random_point(reach / 2, random), q = p + random_point(size, random);
          spread.push_back(box_between(p, q));
          lattice.push_back(box_between(rounded(p), rounded(p)));
          line.push_back(box_between({p.x(), 0, 0}, {q.x(), 0, 0}));
          point.push_back(box_between({1, 2, 3}, {1, 2, 3}));
        }
        sets.insert(sets.end(), {spread, lattice, line, point});
      }
  return sets;
}

Box_tree tree_of(const Boxes& boxes)
{
  const Surface_area_order order(boxes);
  return {order.sorted(boxes), order.run_ends()};
}

struct Nearest_box
{
  const Box_tree& tree;
  Vector p;
  double least = std::numeric_limits<double>::infinity();
  mutable std::size_t number_of_entries = 0;

  double bound() const { return least; }

  double entry(const Bbox_3& box) const
  {
    ++number_of_entries;
    return squared_distance_to_box(p, box);
  }

  void visit(std::size_t i) { least = (std::min)(least, entry(tree.box(i))); }
};

TEST(Surface_area_order, holds_every_box_once)
{
  for(const Boxes& boxes : box_sets()) {
    const Surface_area_order order(boxes);
    auto numbers = order.numbers();
    std::sort(numbers.begin(), numbers.end());
    ASSERT_EQ(numbers.size(), boxes.size());
    for(std::size_t i = 0; i < boxes.size(); ++i) ASSERT_EQ(numbers[i], i);
  }
}

TEST(Surface_area_order, divides_the_order_into_short_runs)
{
  for(const Boxes& boxes : box_sets()) {
    const auto ends = Surface_area_order(boxes).run_ends();
    std::size_t first = 0;
    for(const std::size_t end : ends) {
      ASSERT_GE(end, first);
      EXPECT_LE(end - first, 16u);
      first = end;
    }
    EXPECT_EQ(first, boxes.size());
    EXPECT_LE(ends.size(), (boxes.size() + 3) / 4);
  }
}

TEST(Surface_area_order, finds_the_nearest_box)
{
  Random random(2);
  for(const Boxes& boxes : box_sets()) {
    const Box_tree tree = tree_of(boxes);
    ASSERT_EQ(tree.is_empty(), boxes.empty());
    for(int k = 0; k < 20; ++k) {
      Nearest_box query{tree, random_point(5, random)};
      Nearest_first_descent<Nearest_box>(tree, query).run();
      double expected = std::numeric_limits<double>::infinity();
      for(const Bbox_3& box : boxes)
        expected = (std::min)(expected, squared_distance_to_box(query.p, box));
      ASSERT_EQ(query.least, expected);
    }
  }
}

// Long strips above and below a plate, and the short ones of its walls, of which there are twice as
// many. Divided at the median the long and the short ones stay together.
TEST(Surface_area_order, sets_boxes_of_different_shapes_apart)
{
  Boxes boxes;
  const double width = .01;
  for(int i = 0; i < 1000; ++i) {
    const double y = i * width;
    for(const double z : {0., 4.}) boxes.push_back({-13, y, z, 13, y + width, z});
    for(const double x : {-13., 13.})
      for(int k = 0; k < 2; ++k) boxes.push_back({x, y, 0, x + width, y + width, 4});
  }
  const Box_tree tree = tree_of(boxes);
  Random random(3);
  std::size_t number_of_entries = 0;
  const int n = 1000;
  for(int k = 0; k < n; ++k) {
    Nearest_box query{tree,
                      {uniform(-13, 13, random), uniform(0, 10, random), uniform(0, 4, random)}};
    Nearest_first_descent<Nearest_box>(tree, query).run();
    number_of_entries += query.number_of_entries;
  }
  EXPECT_LT(number_of_entries / n, 60);
}

} // namespace test_surface_area_order
