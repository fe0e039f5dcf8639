// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>

#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Regions that a filling has left empty.
namespace test_unfilled_space {

using namespace CGAL::Volume_filling_curves;
using Traits = Curve_flow_traits_3<>;
using Network = Curve_network_3<>;
using Point = Network::Point_3;
using Domain = Box_domain_3<>;
using Samples = Domain_samples_3<Traits, Domain>;

constexpr double r = 0.1;
double thickness(const Point&)
{
  return r;
}

// A circle about the origin, in a stick along the x-axis that is so thin that no ball fits in which
// would make a region empty.
struct Thin_stick
{
  Domain domain{Point(-0.2, -0.04, -0.2), Point(3, 0.04, 0.2)};
  Samples samples{domain, 2000, 1};
  internal::Boundary_distances<Domain> boundary_distances{domain, samples.points()};
  Network circle{std::vector<Point>{Point(0.1, 0, 0), Point(0, 0, 0.1), Point(-0.1, 0, 0),
                                    Point(0, 0, -0.1), Point(0.1, 0, 0)}};

  internal::Unfilled_space<Network, Samples> unfilled(Wall wall) const
  {
    return {samples, boundary_distances, wall};
  }
};

TEST(Unfilled_space, is_pushed_into_where_it_is_far_though_no_region)
{
  const Thin_stick stick;
  const auto unfilled = stick.unfilled(Wall::COVER);
  const std::vector<double> distances = unfilled.distances(stick.circle);
  EXPECT_TRUE(unfilled.regions(stick.circle, distances, thickness).empty());
  const std::vector<Point> points = unfilled.unreached_points(stick.circle, thickness);
  ASSERT_FALSE(points.empty());
  EXPECT_GT(points.front().x(), 2.9); // the farthest first
  for(std::size_t k = 0; k < distances.size(); ++k) {
    double nearest = distances[k]; // of the points and the curve
    for(const Point& p : points)
      nearest =
          (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, stick.samples.points()[k])));
    EXPECT_LE(nearest, 3 * r);
  }
}

TEST(Unfilled_space, is_none_near_a_boundary_that_is_to_be_kept_clear_of)
{
  // all of the box but its outermost 2 r is within 2 r of the middle
  const Domain domain(Point(-0.3, -0.3, -0.3), Point(0.3, 0.3, 0.3));
  const Samples samples(domain, 2000, 1);
  const internal::Boundary_distances<Domain> boundary_distances(domain, samples.points());
  const Network dot(std::vector<Point>{Point(0, 0, 0), Point(0.01, 0, 0)});
  const std::vector<double> distances = sample_distances(dot, samples);
  const auto fraction = [&](Wall wall) {
    return internal::Unfilled_space<Network, Samples>(samples, boundary_distances, wall)
        .fraction(distances, thickness);
  };
  EXPECT_LT(fraction(Wall::KEEP_CLEAR), 0.05);
  EXPECT_GT(fraction(Wall::COVER), 0.5);
}

// All of the stick is within 2 r of its boundary.
TEST(Unfilled_space, counts_where_nothing_can_keep_clear_of_the_boundary)
{
  const Thin_stick stick;
  const auto unfilled = stick.unfilled(Wall::KEEP_CLEAR);
  EXPECT_GT(unfilled.fraction(unfilled.distances(stick.circle), thickness), 0.25);
  EXPECT_FALSE(unfilled.unreached_points(stick.circle, thickness).empty());
}

} // namespace test_unfilled_space
