// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/Box_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace {

using CGAL::Volume_filling_curves::internal::Box;
using CGAL::Volume_filling_curves::internal::Box_grid;
using CGAL::Volume_filling_curves::internal::Vector;
using Random = std::mt19937;

double uniform(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Box random_box(double reach, double size, Random& random)
{
  Box box = Box::of(Vector(uniform(-reach, reach, random), uniform(-reach, reach, random),
                           uniform(-reach, reach, random)));
  box += box.min +
         Vector(uniform(0, size, random), uniform(0, size, random), uniform(0, size, random));
  return box;
}

Box_grid filled_grid(const std::vector<Box>& boxes, const Vector& origin, double cell_size)
{
  Box_grid grid(origin, cell_size, boxes.size() / 2); // more boxes come than expected
  for(std::size_t k = 0; k < boxes.size(); ++k) grid.insert(k, boxes[k]);
  return grid;
}

// Every pair of overlapping boxes is found once, and every box near a box at least once.
void expect_complete(const std::vector<Box>& boxes, const Vector& origin, double cell_size)
{
  const Box_grid grid = filled_grid(boxes, origin, cell_size);
  EXPECT_EQ(grid.is_empty(), boxes.empty());
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    std::vector<std::size_t> expected, actual;
    std::set<std::size_t> near;
    for(std::size_t j = 0; j < i; ++j)
      if(do_overlap(boxes[i], boxes[j])) expected.push_back(j);
    grid.for_each_overlap_below(i, boxes, [&](std::size_t j) { actual.push_back(j); });
    std::sort(actual.begin(), actual.end());
    ASSERT_EQ(actual, expected) << "box " << i;
    grid.for_each_near(boxes[i], [&](std::size_t j) { near.insert(j); });
    for(std::size_t j = 0; j < boxes.size(); ++j)
      ASSERT_TRUE(near.count(j) == 1 || !do_overlap(boxes[i], boxes[j])) << i << ", " << j;
  }
}

struct Setting
{
  const char* name;
  std::function<Box(Random&)> box;
  double cell_size;
};

const std::vector<Setting> settings = {
    {"alike", [](Random& r) { return random_box(5, 1, r); }, 1},
    {"small cells", [](Random& r) { return random_box(5, 1, r); }, 0.2},
    {"tiny cells", [](Random& r) { return random_box(5, 1, r); }, 1e-9},
    {"huge cells", [](Random& r) { return random_box(5, 1, r); }, 1e9},
    {"least cells", [](Random& r) { return random_box(5, 1, r); }, 0},
    {"infinite cells", [](Random& r) { return random_box(8e307, 1e307, r); },
     std::numeric_limits<double>::infinity()},
    {"all sizes", [](Random& r) { return random_box(5, std::pow(10., uniform(-6, 6, r)), r); },
     0.5},
    {"far off", [](Random& r) { return random_box(std::pow(10., uniform(0, 300, r)), 3, r); }, 1},
    {"points", [](Random& r) { return Box::of(random_box(2, 0, r).min.array().round().matrix()); },
     1},
    {"on cell boundaries",
     [](Random& r) {
       Box box = random_box(3, 2, r);
       return Box{box.min.array().round().matrix(), box.max.array().round().matrix()};
     },
     1},
    {"denormal", [](Random& r) { return random_box(1e-310, 1e-310, r); }, 1e-310},
};

TEST(Box_grid, finds_all_overlapping_pairs_once)
{
  Random random(1);
  for(const Setting& setting : settings) {
    SCOPED_TRACE(setting.name);
    for(std::size_t n : {1u, 2u, 30u, 300u})
      for(const Vector& origin : {Vector(0, 0, 0), Vector(1e3, -7, 0.3)}) {
        std::vector<Box> boxes;
        for(std::size_t k = 0; k < n; ++k) boxes.push_back(setting.box(random));
        expect_complete(boxes, origin, setting.cell_size);
        if(HasFatalFailure()) return;
      }
  }
}

TEST(Box_grid, knows_boxes_by_their_last_and_former_places)
{
  Box_grid grid(Vector(0, 0, 0), 1, 1);
  grid.insert(7, Box::of(Vector(0, 0, 0)));
  grid.insert(7, Box::of(Vector(10, 10, 10)));
  for(double x : {0., 10.}) {
    std::set<std::size_t> near;
    grid.for_each_near(Box::of(Vector(x, x, x)), [&](std::size_t j) { near.insert(j); });
    EXPECT_EQ(near, std::set<std::size_t>{7});
  }
}

TEST(Box_grid, may_be_empty)
{
  const Box_grid grid;
  EXPECT_TRUE(grid.is_empty());
  bool is_found = false;
  grid.for_each_near(Box::of(Vector(0, 0, 0)), [&](std::size_t) { is_found = true; });
  grid.for_each_near(Box::of(Vector(0, 0, 0)).inflated(1e300),
                     [&](std::size_t) { is_found = true; });
  EXPECT_FALSE(is_found);
}

} // namespace
