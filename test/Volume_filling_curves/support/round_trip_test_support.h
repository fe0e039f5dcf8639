// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_ROUND_TRIP_TEST_SUPPORT_H
#define VFC_TEST_ROUND_TRIP_TEST_SUPPORT_H

#include "support/curve_io_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

// Curves to be written and read again, and whether they come back.
namespace round_trip_test {

using namespace curve_io_test;
using Point_3 = Network::Point_3;
using Edges = std::vector<std::array<std::size_t, 2>>;

inline void expect_same(const Network& a, const Network& b)
{
  ASSERT_EQ(a.number_of_nodes(), b.number_of_nodes());
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  ASSERT_EQ(a.number_of_components(), b.number_of_components());
  for(std::size_t v = 0; v < a.number_of_nodes(); ++v) {
    const std::array<double, 3> p{a.point(v).x(), a.point(v).y(), a.point(v).z()};
    const std::array<double, 3> q{b.point(v).x(), b.point(v).y(), b.point(v).z()};
    EXPECT_EQ(std::memcmp(p.data(), q.data(), sizeof(p)), 0) << "node " << v;
    EXPECT_EQ(a.component(v), b.component(v));
  }
  for(std::size_t e = 0; e < a.number_of_edges(); ++e) {
    EXPECT_EQ(a.source(e), b.source(e));
    EXPECT_EQ(a.target(e), b.target(e));
  }
  for(std::size_t c = 0; c < a.number_of_components(); ++c)
    EXPECT_EQ(a.is_closed(c), b.is_closed(c));
}

// Doubles of all magnitudes that a curve may have.
inline std::vector<Point_3> random_points(std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<Point_3> points;
  const auto coordinate = [&]() {
    for(;;) {
      const std::uint64_t bits = random();
      double x = 0;
      std::memcpy(&x, &bits, sizeof(x));
      if(std::abs(x) <= internal::max_coordinate) return x;
    }
  };
  while(points.size() < count) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

// An arc and a loop of random points with a pin each.
inline Network arc_and_loop()
{
  std::vector<Point_3> points = random_points(200, 1);
  points.emplace_back(std::numeric_limits<double>::denorm_min(), -0., 0.1);
  points.emplace_back(1e150, -1e150, std::numeric_limits<double>::min());
  Edges edges;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(v != 99) edges.push_back({v, v == 201 ? 100 : v + 1});
  Network network(points, edges);
  network.set_pinned(7);
  network.set_pinned(150);
  return network;
}

inline Network network_with_junctions(unsigned seed)
{
  std::mt19937 random(seed);
  const std::size_t n = 12;
  std::vector<Point_3> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = double(i + 1); // on the moment curve no two edges meet
    points.emplace_back(t, t * t, t * t * t);
  }
  Edges edges;
  for(std::size_t v = 0; v < n; ++v)
    for(std::size_t w = v + 1; w < n; ++w)
      if(random() % 5 == 0) edges.push_back({v, w});
  std::shuffle(edges.begin(), edges.end(), random);
  for(auto& edge : edges)
    if(random() % 2 == 0) std::swap(edge[0], edge[1]);
  return {points, edges};
}

} // namespace round_trip_test

#endif // VFC_TEST_ROUND_TRIP_TEST_SUPPORT_H
