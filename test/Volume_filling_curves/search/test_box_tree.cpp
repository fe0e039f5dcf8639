// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

// All queries are compared with brute force.
namespace test_box_tree {

using CGAL::Bbox_3;
using CGAL::Volume_filling_curves::internal::Box_tree;
using CGAL::Volume_filling_curves::internal::Nearest_pair_descent;
using CGAL::Volume_filling_curves::internal::Overlapping_boxes;
using Boxes = std::vector<Bbox_3>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Part = Box_tree::Part;
using Random = std::mt19937;

double uniform(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Bbox_3 random_box(double reach, double size, Random& random)
{
  double low[3], high[3];
  for(int i = 0; i < 3; ++i) {
    low[i] = uniform(-reach, reach, random);
    high[i] = low[i] + uniform(0, size, random);
  }
  return {low[0], low[1], low[2], high[0], high[1], high[2]};
}

Bbox_3 rounded(const Bbox_3& b)
{
  return {std::round(b.xmin()), std::round(b.ymin()), std::round(b.zmin()),
          std::round(b.xmax()), std::round(b.ymax()), std::round(b.zmax())};
}

struct Setting
{
  const char* name;
  std::function<Bbox_3(Random&)> box;
};

const std::vector<Setting> settings = {
    {"alike", [](Random& r) { return random_box(5, 1, r); }},
    {"all sizes", [](Random& r) { return random_box(5, std::pow(10., uniform(-6, 6, r)), r); }},
    {"far off", [](Random& r) { return random_box(std::pow(10., uniform(0, 300, r)), 3, r); }},
    {"huge", [](Random& r) { return random_box(8e307, 1e307, r); }},
    {"points", [](Random& r) { return rounded(random_box(2, 0, r)); }},
    {"touching", [](Random& r) { return rounded(random_box(3, 2, r)); }},
    {"denormal", [](Random& r) { return random_box(1e-310, 1e-310, r); }},
};

void for_each_setting(const std::function<void(const Boxes&)>& check)
{
  Random random(1);
  for(const Setting& setting : settings) {
    SCOPED_TRACE(setting.name);
    for(std::size_t n : {0u, 1u, 2u, 4u, 5u, 8u, 9u, 12u, 13u, 17u, 30u, 300u}) {
      Boxes boxes;
      for(std::size_t k = 0; k < n; ++k) boxes.push_back(setting.box(random));
      check(boxes);
      if(testing::Test::HasFatalFailure()) return;
    }
  }
}

double distance(const Bbox_3& a, const Bbox_3& b)
{
  double largest = 0;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)({largest, a.min(i) - b.max(i), b.min(i) - a.max(i)});
  return largest;
}

struct Least_distance
{
  const Box_tree& tree;
  double least = std::numeric_limits<double>::infinity();
  std::size_t number_of_visits = 0;

  double bound() const { return least; }
  double entry(const Part& a, const Part& b) const { return distance(a.hull(), b.hull()); }
  void visit(const Part& a, const Part& b)
  {
    ++number_of_visits;
    tree.for_each_pair(a, b, [&](std::size_t i, std::size_t j) {
      least = (std::min)(least, distance(tree.box(i), tree.box(j)));
    });
  }
};

TEST(Box_tree, finds_all_overlapping_pairs_once)
{
  for_each_setting([](const Boxes& boxes) {
    Pairs expected;
    for(std::size_t i = 0; i < boxes.size(); ++i)
      for(std::size_t j = i + 1; j < boxes.size(); ++j)
        if(do_overlap(boxes[i], boxes[j])) expected.push_back({i, j});
    const Box_tree tree(boxes);
    for(std::size_t max_runs : {1u, 2u, 7u, 1000u}) {
      Pairs pairs;
      const Overlapping_boxes query(tree, [&](std::size_t i, std::size_t j) {
        pairs.push_back({i, j});
      });
      Nearest_pair_descent(tree, query, max_runs).run();
      std::sort(pairs.begin(), pairs.end());
      ASSERT_EQ(pairs, expected) << boxes.size() << " boxes";
    }
  });
}

TEST(Box_tree, finds_the_nearest_pair)
{
  for_each_setting([](const Boxes& boxes) {
    double expected = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < boxes.size(); ++i)
      for(std::size_t j = i + 1; j < boxes.size(); ++j)
        expected = (std::min)(expected, distance(boxes[i], boxes[j]));
    const Box_tree tree(boxes);
    Least_distance query{tree};
    Nearest_pair_descent(tree, query).run();
    ASSERT_EQ(query.least, expected) << boxes.size() << " boxes";
  });
}

// Boxes in spatial order, far apart except for one pair.
TEST(Box_tree, visits_few_pairs)
{
  Boxes boxes;
  for(int k = 0; k < 4096; ++k) boxes.push_back({10. * k, 0, 0, 10. * k + 1, 1, 1});
  boxes[100] = {42, 5, 0, 43, 6, 1};
  const Box_tree tree(boxes);
  Least_distance query{tree};
  Nearest_pair_descent(tree, query).run();
  EXPECT_EQ(query.least, 4);
  EXPECT_LT(query.number_of_visits, 4096u);
}

void expect_sound(const Box_tree& tree, const Part& part)
{
  for(std::size_t k = tree.first(part); k < tree.end(part); ++k)
    EXPECT_EQ(part.hull() + tree.box(k), part.hull());
  if(part.number_of_runs() == 1) return;
  const auto [left, right] = tree.children(part);
  EXPECT_EQ(tree.first(left), tree.first(part));
  EXPECT_EQ(tree.first(right), tree.end(left));
  EXPECT_EQ(tree.end(right), tree.end(part));
  EXPECT_EQ(left.number_of_runs() + right.number_of_runs(), part.number_of_runs());
  expect_sound(tree, left);
  expect_sound(tree, right);
}

TEST(Box_tree, has_parts_of_consecutive_boxes)
{
  for_each_setting([](const Boxes& boxes) {
    const Box_tree tree(boxes);
    ASSERT_EQ(tree.is_empty(), boxes.empty());
    if(boxes.empty()) return;
    EXPECT_EQ(tree.first(tree.root()), 0u);
    EXPECT_EQ(tree.end(tree.root()), boxes.size());
    expect_sound(tree, tree.root());
  });
}

} // namespace test_box_tree
