// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/spheres/Moving_neighborhood.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

// The nodes that the spheres of a circle can touch.
namespace test_node_prefilter {

using namespace flow_test;

// Nodes a little inside of all spheres together, and a little outside, wherever the ball is and
// however large.
TEST(Node_prefilter, keeps_what_spheres_touch_and_little_else)
{
  Random random(2);
  for(double unit : {1., 1e-100, 1e100}) {
    const Vector center = 1000 * unit * random_point(random);
    internal::Node_list nodes;
    const Vector normal = random_point(random).normalized();
    const double diameter = 0.8 * unit;
    const Vector p = center + 0.1 * unit * random_point(random).normalized();
    for(internal::Node_list::Index k = 0; k < 4000; ++k) {
      const double size = k % 2 == 0 ? 1 - 1e-9 : 1.01;
      Vector d;
      while(d.norm() < 0.2 * unit) {
        const Vector direction = random_point(random).normalized();
        d = diameter * direction.cross(normal).norm() * direction;
      }
      nodes.push_back(k, p + size * d);
    }
    internal::Node_prefilter prefilter(nodes);
    prefilter.start(center, unit);
    prefilter.add(0, 1000);
    prefilter.add(1000, nodes.size());
    internal::Node_list passed;
    prefilter(p, normal, diameter, passed);
    std::set<std::size_t> kept;
    for(std::size_t k = 0; k < passed.size(); ++k) kept.insert(passed.index(k));
    for(std::size_t k = 0; k < nodes.size(); k += 2) EXPECT_EQ(kept.count(k), 1u) << k;
    EXPECT_LT(kept.size(), 2100u);
  }
}

TEST(Node_prefilter, leaves_nodes_out_that_are_not_in_the_ball)
{
  internal::Node_list nodes, passed;
  nodes.push_back(0, Vector(0.5, 0, 0));
  nodes.push_back(1, Vector(1.5, 0, 0));
  internal::Node_prefilter prefilter(nodes);
  prefilter.start(Vector(), 1);
  prefilter.add(0, 2);
  prefilter(Vector(), Vector(0, 0, 1), 1, passed);
  ASSERT_EQ(passed.size(), 1u);
  EXPECT_EQ(passed.index(0), 0u);
  prefilter.start(Vector(1.2, 0, 0), 0.5);
  prefilter.add(0, 2);
  prefilter(Vector(1.2, 0, 0), Vector(0, 0, 1), 0.5, passed);
  ASSERT_EQ(passed.size(), 1u);
  EXPECT_EQ(passed.index(0), 1u);
}

} // namespace test_node_prefilter
