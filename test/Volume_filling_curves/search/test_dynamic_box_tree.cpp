// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/search/Dynamic_box_tree.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace test_dynamic_box_tree {

using CGAL::Volume_filling_curves::internal::Box;
using CGAL::Volume_filling_curves::internal::Dynamic_box_tree;
using CGAL::Volume_filling_curves::internal::Vector;
using Random = std::mt19937;

double uniform(double low, double high, Random& random)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector random_point(double reach, Random& random)
{
  return {uniform(-reach, reach, random), uniform(-reach, reach, random),
          uniform(-reach, reach, random)};
}

Box random_box(double reach, double size, Random& random)
{
  const Vector corner = random_point(reach, random);
  return Box(corner).extend(corner + random_point(size, random));
}

std::set<std::size_t> found(const Dynamic_box_tree& blocks, const Box& box)
{
  std::set<std::size_t> result;
  EXPECT_TRUE(blocks.holds_near(box, [&](std::size_t k) {
    EXPECT_TRUE(result.insert(k).second) << "found twice";
    return true;
  }));
  return result;
}

// All that overlap are found, and of a thousand others hardly any.
void expect_complete(const Dynamic_box_tree& blocks, const std::vector<Box>& boxes, double reach)
{
  Random random(2);
  std::size_t in_vain = 0, queries = 100;
  for(std::size_t q = 0; q < queries; ++q) {
    const Box query = random_box(reach, 0.3 * reach, random);
    const std::set<std::size_t> result = found(blocks, query);
    for(std::size_t k = 0; k < boxes.size(); ++k) {
      if(query.intersects(boxes[k]))
        EXPECT_EQ(result.count(k), 1u);
      else
        in_vain += result.count(k);
    }
  }
  EXPECT_LE(in_vain, queries * boxes.size() / 1000);
}

TEST(Dynamic_box_tree, finds_all_boxes_that_overlap)
{
  Random random(1);
  for(const std::size_t n : {1u, 32u, 33u, 1024u, 1025u, 3000u})
    for(double reach : {1., 1e-200, 1e150}) {
      Dynamic_box_tree blocks(Box{Vector::constant(-reach), Vector::constant(reach)});
      std::vector<Box> boxes;
      for(std::size_t k = 0; k < n; ++k) {
        boxes.push_back(random_box(reach, 0.1 * reach, random));
        blocks.set(k, boxes.back());
      }
      expect_complete(blocks, boxes, reach);
    }
}

TEST(Dynamic_box_tree, finds_the_same_boxes_if_it_is_given_all_at_once)
{
  Random random(4);
  for(const std::size_t n : {0u, 1u, 32u, 33u, 1024u, 1025u, 3000u}) {
    const Box frame{Vector::constant(-1), Vector::constant(1)};
    std::vector<Box> boxes(n);
    for(Box& box : boxes) box = random_box(1, 0.1, random);
    const auto box_of = [&](std::size_t k) { return boxes[k]; };
    Dynamic_box_tree at_once(frame, n, box_of), one_by_one(frame);
    for(std::size_t k = 0; k < n; ++k) one_by_one.set(k, boxes[k]);
    for(std::size_t k : {n, 2 * n + 7}) { // more of them
      at_once.set(k, random_box(1, 0.1, random));
      one_by_one.set(k, Box());
    }
    expect_complete(at_once, boxes, 1);
  }
}

TEST(Dynamic_box_tree, follows_boxes_that_move_and_vanish)
{
  Random random(3);
  Dynamic_box_tree blocks(Box{Vector::constant(-1), Vector::constant(1)});
  std::vector<Box> boxes;
  for(std::size_t k = 0; k < 500; ++k) {
    boxes.push_back(random_box(1, 0.1, random));
    blocks.set(k, boxes.back());
  }
  for(int step = 0; step < 2000; ++step) {
    const std::size_t k = random() % boxes.size();
    boxes[k] = random_box(1, 0.1, random);
    blocks.set(k, boxes[k]);
  }
  expect_complete(blocks, boxes, 1);
  for(std::size_t k = 0; k < boxes.size(); k += 2) blocks.clear(k);
  for(const std::size_t k : found(blocks, Box{Vector::constant(-1), Vector::constant(1)}))
    EXPECT_EQ(k % 2, 1u);
}

TEST(Dynamic_box_tree, finds_boxes_outside_the_frame)
{
  Dynamic_box_tree blocks(Box{Vector(), Vector::constant(1)});
  const Box far{Vector::constant(1e9), Vector::constant(2e9)};
  blocks.set(40, far); // those below were never set
  EXPECT_EQ(found(blocks, far), std::set<std::size_t>{40});
  EXPECT_TRUE(found(blocks, Box{Vector(), Vector::constant(0.5)}).empty());
}

TEST(Dynamic_box_tree, finds_touching_boxes_and_manages_a_frame_without_extent)
{
  for(double side : {0., 1.}) {
    Dynamic_box_tree blocks(Box{Vector(), Vector::constant(side)});
    blocks.set(0, Box{Vector(), Vector::constant(0.1)});
    EXPECT_EQ(found(blocks, Box{Vector::constant(0.1), Vector::constant(0.2)}).size(), 1u);
  }
}

TEST(Dynamic_box_tree, stops_when_told)
{
  Dynamic_box_tree blocks(Box{Vector(), Vector::constant(1)});
  for(std::size_t k = 0; k < 100; ++k) blocks.set(k, Box{Vector(), Vector::constant(1)});
  std::size_t calls = 0;
  EXPECT_FALSE(blocks.holds_near(Box{Vector(), Vector::constant(1)},
                                 [&](std::size_t) { return ++calls < 40; }));
  EXPECT_EQ(calls, 40u);
}

TEST(Dynamic_box_tree, may_be_empty)
{
  EXPECT_TRUE(found(Dynamic_box_tree(), Box{Vector(), Vector::constant(1)}).empty());
}

} // namespace test_dynamic_box_tree
