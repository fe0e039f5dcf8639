// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Well_spaced_points.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace test_well_spaced_points {

using namespace CGAL::Volume_filling_curves;
using internal::Vector;
using Traits = Curve_flow_traits_3<>;
using Point = Traits::Point_3;
using Distance = std::function<double(const Point&)>;

template <typename Domain>
std::vector<Vector> spaced(const Domain& domain,
                           const Distance& distance,
                           double room,
                           const std::vector<Vector>& there = {},
                           std::size_t seed = 1)
{
  internal::Run_watch watch;
  return internal::Well_spaced_points<Domain, Traits, Distance>(domain, distance, room, Traits(),
                                                                watch)(there, seed);
}

double nearest(const Vector& x, const std::vector<Vector>& points)
{
  double least = std::numeric_limits<double>::infinity();
  for(const Vector& p : points)
    if(p != x) least = (std::min)(least, (p - x).norm());
  return least;
}

TEST(Well_spaced_points, keep_their_distance_and_leave_no_room)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 1);
  const double distance = 0.2;
  const std::vector<Vector> there{{1, 2, 3}};
  const auto points = spaced(
      ball, [&](const Point&) { return distance; }, 0.5, there);
  for(const Vector& p : points) {
    EXPECT_GE(nearest(p, points), distance);
    EXPECT_GE((p - there[0]).norm(), distance);
    EXPECT_LE((p - there[0]).norm(), 1 - distance / 8);
  }
  internal::Random_source random(2);
  for(int k = 0; k < 2000; ++k) {
    const Vector x = there[0] + 0.9 * random.real() * random.direction();
    auto all = points;
    all.push_back(there[0]);
    EXPECT_LT(nearest(x, all), 1.6 * distance); // a cell of the grid has a diagonal of 0.58 of it
  }
}

// Outside, the distances of a box are 0. The cube around this one has 1.7 million candidates.
TEST(Well_spaced_points, are_not_sought_outside_of_a_thin_box)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(100, 1, 100));
  std::size_t number_of_queries = 0;
  const auto distance = [&](const Point&) {
    ++number_of_queries;
    return 2.5;
  };
  EXPECT_GT(spaced(box, distance, 0.1).size(), 900u);
  EXPECT_LT(number_of_queries, 300000u);
}

TEST(Well_spaced_points, follow_a_distance_that_varies)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(1, 1, 1));
  const Distance distance = [](const Point& p) { return p.x() < 0.5 ? 0.05 : 0.2; };
  const auto points = spaced(box, distance, 0);
  const auto fine =
      std::count_if(points.begin(), points.end(), [](const Vector& p) { return p.x() < 0.5; });
  const auto coarse = static_cast<std::ptrdiff_t>(points.size()) - fine;
  EXPECT_GT(fine, 30 * coarse); // 64 times as dense
  EXPECT_GT(coarse, 20);
}

TEST(Well_spaced_points, depend_on_the_seed_only)
{
  const Ball_domain_3<> ball(Point(0, 0, 0), 1);
  const Distance distance = [](const Point&) { return 0.3; };
  EXPECT_EQ(spaced(ball, distance, 0.2), spaced(ball, distance, 0.2));
  EXPECT_NE(spaced(ball, distance, 0.2), spaced(ball, distance, 0.2, {}, 2));
}

} // namespace test_well_spaced_points
