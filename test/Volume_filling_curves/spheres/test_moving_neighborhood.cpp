// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/internal/spheres/Moving_neighborhood.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// The nodes that are looked at for medial spheres.
namespace test_moving_neighborhood {

using namespace flow_test;

// The center usually moves by less than the diameter, which also changes.
TEST(Moving_neighborhood, misses_no_node_on_its_way)
{
  Random random(1);
  const Vector_field x = random_field(2000, random);
  const internal::Node_neighborhoods all(x);
  internal::Moving_neighborhood neighborhood(all);
  Vector p = random_point(random);
  std::size_t expected = 0, handed_out = 0;
  for(int step = 0; step < 1000; ++step) {
    const double diameter = between(0.1, 0.15, random);
    p = 0.99 * (p + 0.3 * diameter * random_point(random));
    const Vector normal = random_point(random).normalized();
    const internal::Node_list& nodes = neighborhood(p, normal, diameter);
    std::vector<bool> is_listed(2000, false);
    for(std::size_t k = 0; k < nodes.size(); ++k) {
      is_listed[nodes.index(k)] = true;
      const Vector listed(nodes.x()[k], nodes.y()[k], nodes.z()[k]);
      EXPECT_EQ((listed - internal::row(x, nodes.index(k))).norm(), 0);
    }
    handed_out += nodes.size();
    for(std::size_t v = 0; v < is_listed.size(); ++v) {
      const Vector d = internal::row(x, v) - p;
      if(!(d.squaredNorm() <= diameter * (d - d.dot(normal) * normal).norm())) continue;
      ++expected;
      EXPECT_TRUE(is_listed[v]) << step << ' ' << v;
    }
  }
  EXPECT_GT(expected, 500u);
  EXPECT_LT(handed_out, expected + expected / 4);
}

} // namespace test_moving_neighborhood
