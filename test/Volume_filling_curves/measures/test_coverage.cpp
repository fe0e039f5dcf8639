// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_domain.h"
#include "support/mesh_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/measures/Linked_samples.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Unbounded_domain_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_coverage {

using namespace CGAL::Volume_filling_curves;
using meshes::Point;
using Traits = Curve_flow_traits_3<>;
using Network = Curve_network_3<>;
using Box = Box_domain_3<>;
using Ball = Ball_domain_3<>;
using Mesh_domain = Triangle_mesh_domain_3<>;

Network polyline(const std::vector<Point>& points)
{
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t i = 1; i < points.size(); ++i) edges.push_back({i - 1, i});
  return Network(points, edges);
}

Network helix(double radius, double height, std::size_t nodes)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < nodes; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(nodes - 1);
    points.emplace_back(radius * std::cos(40 * t), radius * std::sin(40 * t), (t - .5) * height);
  }
  return polyline(points);
}

double distance(const Network& curve, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    least =
        (std::min)(least, std::sqrt(CGAL::squared_distance(
                              p, CGAL::Segment_3<meshes::Kernel>(curve.point(curve.source(e)),
                                                                 curve.point(curve.target(e))))));
  return least;
}

TEST(Domain_samples, are_uniform_and_reproducible)
{
  const Ball ball(Point(1, 2, 3), 2);
  const Domain_samples_3<Traits, Ball> samples(ball, 20000, 5), same(ball, 20000, 5);
  const Domain_samples_3<Traits, Ball> other(ball, 20000, 6);
  EXPECT_EQ(samples.points(), same.points());
  EXPECT_NE(samples.points(), other.points());
  const double pi = 3.14159265358979;
  EXPECT_NEAR(samples.volume() / (32 * pi / 3), 1, .02);
  const auto share_within = [&](double radius) {
    return static_cast<double>(std::count_if(samples.points().begin(), samples.points().end(),
                                             [&](const Point& p) {
                                               return CGAL::squared_distance(p, Point(1, 2, 3)) <
                                                      radius * radius;
                                             })) /
           20000;
  };
  EXPECT_EQ(share_within(2), 1);
  EXPECT_NEAR(share_within(1), 1. / 8, .01);
  EXPECT_NEAR(share_within(1.5), 27. / 64, .02);
}

TEST(Domain_samples, need_a_bounded_domain_with_an_inside)
{
  using Unbounded = Unbounded_domain_3<>;
  using Samples = Domain_samples_3<Traits, Unbounded>;
  const Unbounded unbounded;
  EXPECT_EQ(refusal_of([&] { Samples(unbounded, 10); }), "the domain is unbounded");
  struct Nothing : Box
  {
    using Box::Box;
    bool is_inside(const Point&) const { return false; }
  };
  const Nothing nothing(Point(0, 0, 0), Point(1, 1, 1));
  using Samples_of_nothing = Domain_samples_3<Traits, Nothing>;
  EXPECT_THROW(Samples_of_nothing(nothing, 10), std::invalid_argument);
}

// A volume of infinity or 0 would leave regions without a size, and grids without a cell.
TEST(Domain_samples, need_a_volume_that_a_double_holds)
{
  using Samples = Domain_samples_3<Traits, Box>;
  for(const double side : {1e-110, 1e103, 1e140}) {
    const Box box(Point(0, 0, 0), Point(side, side, side));
    const std::string refusal = refusal_of([&] { Samples(box, 10); });
    EXPECT_EQ(refusal.find("a double cannot hold the volume of the domain's box"), 0u) << refusal;
  }
  EXPECT_GT(Samples(Box(Point(0, 0, 0), Point(1e-102, 1e-102, 1e-102)), 10).volume(), 0);
  EXPECT_LT(Samples(Box(Point(0, 0, 0), Point(1e102, 1e102, 1e102)), 10).volume(), 2e306);
}

// With a probability of 1/7, none of 10,000 points of the box is inside.
TEST(Domain_samples, are_found_one_by_one_where_they_are_rare)
{
  struct Sliver : Box
  {
    using Box::Box;
    bool is_inside(const Point& p) const { return p.x() < 2e-4; }
  };
  const Sliver sliver(Point(0, 0, 0), Point(1, 1, 1));
  for(std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_EQ((Domain_samples_3<Traits, Sliver>(sliver, 1, seed).points().size()), 1u);
}

TEST(Domain_samples, are_fewer_if_they_are_stopped)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Domain_samples_3<Traits, Box> all(box, 5000, 3);
  const Domain_samples_3<Traits, Box> few(box, 5000, 3, Traits(), [] { return false; });
  ASSERT_EQ(few.points().size(), 1024u);
  EXPECT_TRUE(std::equal(few.points().begin(), few.points().end(), all.points().begin()));
  EXPECT_NEAR(few.volume(), 1, 1e-12);
}

TEST(Coverage, knows_the_share_beyond_twice_the_thickness)
{
  const Box box(Point(0, -2, -2), Point(1, 2, 2));
  const Network line = polyline({Point(1e-9, 0, 0), Point(1 - 1e-9, 0, 0)});
  const Domain_samples_3<Traits, Box> samples(box, 20000, 1);
  const auto distances = sample_distances(line, samples);
  const double pi = 3.14159265358979;
  for(const double r : {0.2, 0.5, 1.})
    EXPECT_NEAR(unfilled_fraction(samples, distances, r), 1 - pi * r * r / 4, 0.01);
  const auto varying = [](const Point& p) { return p.y() > 0 ? 0.2 : 5; };
  EXPECT_NEAR(unfilled_fraction(samples, distances, varying), (1 - pi * 0.01) / 2, 0.01);
}

TEST(Coverage, agrees_with_brute_force)
{
  const Ball ball(Point(0, 0, 0), 1);
  const Domain_samples_3<Traits, Ball> samples(ball, 2000);
  const Network curve = helix(.5, 1.2, 300);
  const std::vector<double> distances = sample_distances(curve, samples);
  std::vector<double> expected;
  for(const Point& p : samples.points()) expected.push_back(distance(curve, p));
  for(std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(distances[i], expected[i], 1e-14);
  const double r = .2;
  const Coverage result = coverage(samples, distances, r);
  std::sort(expected.begin(), expected.end());
  double sum = 0, within = 0;
  for(const double d : expected) {
    sum += d / r;
    within += d <= r;
  }
  EXPECT_EQ(result.samples, 2000u);
  EXPECT_NEAR(result.mean, sum / 2000, 1e-12);
  EXPECT_NEAR(result.p50, expected[999] / r, 1e-12);
  EXPECT_NEAR(result.p95, expected[1899] / r, 1e-12);
  EXPECT_NEAR(result.p99, expected[1979] / r, 1e-12);
  EXPECT_NEAR(result.max, expected[1999] / r, 1e-12);
  EXPECT_NEAR(result.fraction_within_r, within / 2000, 1e-12);
}

TEST(Coverage, of_a_straight_line_in_a_box_has_a_closed_form)
{
  const Box box(Point(-1, -1, 0), Point(1, 1, 1));
  const Domain_samples_3<Traits, Box> samples(box);
  const Network curve = polyline({Point(0, 0, 0), Point(0, 0, .2), Point(0, 0, 1)});
  const Coverage result = coverage(samples, sample_distances(curve, samples), .5);
  EXPECT_EQ(result.samples, 20000u);
  EXPECT_NEAR(result.fraction_within_r, 3.14159 / 16, .01);
  EXPECT_NEAR(result.mean, 2 * .765196, .01) << "the mean distance from the center of a square";
  EXPECT_LE(result.max, 2 * std::sqrt(2.));
}

TEST(Coverage, takes_a_thickness_that_varies)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Domain_samples_3<Traits, Box> samples(box, 1000);
  const Network curve = polyline({Point(.5, .5, .1), Point(.5, .5, .9)});
  const std::vector<double> distances = sample_distances(curve, samples);
  const auto field = [](const Point& p) { return p.x() < .5 ? .1 : .2; };
  const Coverage result = coverage(samples, distances, field);
  double within = 0;
  for(std::size_t i = 0; i < distances.size(); ++i)
    within += distances[i] <= field(samples.points()[i]);
  EXPECT_EQ(result.fraction_within_r, within / 1000);
  EXPECT_EQ(coverage(samples, distances, [](const Point&) { return .25; }).p99,
            coverage(samples, distances, .25).p99);
}

TEST(Coverage, does_not_depend_on_a_single_edge_or_on_no_edge)
{
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  const Domain_samples_3<Traits, Box> samples(box, 100);
  const Network nothing = polyline({});
  for(const double d : sample_distances(nothing, samples))
    EXPECT_EQ(d, std::numeric_limits<double>::infinity());
  const Network edge = polyline({Point(.5, .5, .1), Point(.5, .5, .9)});
  const std::vector<double> distances = sample_distances(edge, samples);
  for(std::size_t i = 0; i < 100; ++i)
    EXPECT_NEAR(distances[i], distance(edge, samples.points()[i]), 1e-15);
  const Domain_samples_3<Traits, Box> none(box, 0);
  EXPECT_EQ(coverage(none, {}, 1.).samples, 0u);
  EXPECT_TRUE(std::isnan(coverage(none, {}, 1.).fraction_within_r)) << "it is unknown";
}

// whether the ball of a region is inside and farther than 2 r from the curve
template <typename Domain>
void expect_empty_ball(const Empty_region_3<Point>& region,
                       const Network& curve,
                       const Domain& domain,
                       double r)
{
  EXPECT_GE(region.radius, r / 2);
  EXPECT_TRUE(domain.is_inside(region.point));
  EXPECT_GE(domain.distance(region.point), region.radius * (1 - 1e-12));
  EXPECT_GE(distance(curve, region.point), (2 * r + region.radius) * (1 - 1e-12));
}

TEST(Empty_regions, are_the_two_ends_of_a_bar)
{
  const Box box(Point(0, 0, 0), Point(8, 1, 1));
  const double r = .5;
  const Network curve = polyline({Point(3, .5, .5), Point(4, .6, .5), Point(6, .5, .5)});
  for(const std::size_t n : {300u, 3000u, 20000u}) {
    const Domain_samples_3<Traits, Box> samples(box, n);
    const auto regions = empty_regions(curve, samples, sample_distances(curve, samples), r);
    ASSERT_EQ(regions.size(), 2u) << n;
    EXPECT_LT(regions[0].point.x(), 2) << "the larger end";
    EXPECT_GT(regions[1].point.x(), 7);
    const double noise = n == 300 ? .4 : .1;
    EXPECT_NEAR(regions[0].volume, 2.09, noise);
    EXPECT_NEAR(regions[1].volume, 1.09, noise) << "2 without the mean height of the sphere";
    EXPECT_NEAR(regions[0].radius, .5, .05) << "the largest ball that fits";
    for(const auto& region : regions) expect_empty_ball(region, curve, box, r);
  }
}

TEST(Empty_regions, are_found_by_few_samples)
{
  const Network nothing = polyline({});
  const Box box(Point(0, 0, 0), Point(1, 1, 1));
  for(const std::size_t n : {1u, 2u, 3u}) {
    const Domain_samples_3<Traits, Box> samples(box, n);
    const auto regions = empty_regions(nothing, samples, sample_distances(nothing, samples), 0.1);
    double volume = 0;
    for(const auto& region : regions) volume += region.volume;
    EXPECT_NEAR(volume, samples.volume(), 1e-12) << n;
  }
}

// Their cells are beyond the range of integers.
TEST(Linked_samples, are_linked_far_from_the_origin)
{
  const Box box(Point(0, 0, 0), Point(2e20, 1, 1));
  const std::vector<Point> samples = {Point(1e20, 0.1, 0.5), Point(1e20, 0.2, 0.5)};
  CGAL::Volume_filling_curves::internal::Linked_samples<Box> linked(box, samples, 0.1);
  EXPECT_EQ(linked.sets().find(0), linked.sets().find(1));
}

// Accepts edges that do not cross the planes x = 0 and y = 0.
struct Quadrants
{
  using Point_3 = Point;

  bool is_triangle_inside(const Point& p, const Point& q, const Point&) const
  {
    return (p.x() < 0) == (q.x() < 0) && (p.y() < 0) == (q.y() < 0);
  }
};

TEST(Linked_samples, are_linked_as_by_brute_force)
{
  internal::Random_source random(1);
  const Quadrants quadrants;
  for(const std::size_t n : {2u, 100u, 500u}) {
    std::vector<Point> samples;
    for(std::size_t k = 0; k < n; ++k)
      samples.emplace_back(random.real() - 0.5, random.real() - 0.5, random.real() - 0.5);
    internal::Linked_samples<Quadrants> linked(quadrants, samples, 0.5 / std::cbrt(n));
    internal::Disjoint_sets sets(n);
    for(std::size_t j = 0; j < n; ++j)
      for(std::size_t k = 0; k < j; ++k)
        if(std::sqrt(CGAL::squared_distance(samples[j], samples[k])) <= linked.link() &&
           quadrants.is_triangle_inside(samples[j], samples[k], samples[k]))
          sets.unite(j, k);
    for(std::size_t k = 0; k < n; ++k) EXPECT_EQ(linked.sets().find(k), sets.find(k));
  }
}

TEST(Empty_regions, end_at_walls)
{
  // two cubes 0.02 apart, in neither of which is a curve
  meshes::Soup cubes = meshes::cube(), second = meshes::cube();
  for(Point& p : second.points) p = Point(p.x() + 1.02, p.y(), p.z());
  const Mesh_domain domain(meshes::to_mesh(cubes + second));
  const Domain_samples_3<Traits, Mesh_domain> samples(domain, 3000);
  const Network far = polyline({Point(0, 0, 50), Point(0, 1, 50)});
  const auto regions = empty_regions(far, samples, sample_distances(far, samples), .2);
  ASSERT_EQ(regions.size(), 2u);
  for(const auto& region : regions) {
    EXPECT_NEAR(region.radius, .5, .02);
    EXPECT_NEAR(region.volume, 1, .05);
  }
}

TEST(Empty_regions, are_none_where_there_is_no_room)
{
  const Network curve = helix(.5, 1.2, 300);
  const Ball ball(Point(0, 0, 0), 1);
  const Domain_samples_3<Traits, Ball> samples(ball, 5000);
  const std::vector<double> distances = sample_distances(curve, samples);
  const double farthest = coverage(samples, distances, 1.).max;
  EXPECT_TRUE(empty_regions(curve, samples, distances, farthest / 2.4).empty());
  const auto regions = empty_regions(curve, samples, distances, .1);
  ASSERT_FALSE(regions.empty());
  for(const auto& region : regions) expect_empty_ball(region, curve, ball, .1);
  const auto varying = empty_regions(curve, samples, distances, [](const Point&) { return .1; });
  ASSERT_EQ(varying.size(), regions.size());
  EXPECT_EQ(varying[0].point, regions[0].point);
}

TEST(Empty_regions, search_ends_with_distances_of_another_curve)
{
  const Ball ball(Point(0, 0, 0), 1);
  const Domain_samples_3<Traits, Ball> samples(ball, 1000);
  const std::vector<double> far_away(samples.points().size(), 2);
  EXPECT_TRUE(empty_regions(helix(.5, 1.2, 300), samples, far_away, .6).empty());
}

TEST(Coverage, refuses_a_thickness_that_is_none)
{
  const Ball ball(Point(0, 0, 0), 1);
  const Domain_samples_3<Traits, Ball> samples(ball, 1000);
  const std::vector<double> distances(samples.points().size(), 0.1);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto partly = [](const Point& p) { return p.x() > 0 ? nan : 0.1; };
  EXPECT_THROW(static_cast<void>(coverage(samples, distances, partly)), std::invalid_argument);
  for(const double r : {-1., 0., nan}) {
    EXPECT_THROW(static_cast<void>(coverage(samples, distances, r)), std::invalid_argument) << r;
  }
}

TEST(Containment, counts_what_touches_or_crosses_the_boundary)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 4)));
  const auto counts = [&](const std::vector<Point>& points) {
    const Containment result = containment(polyline(points), domain);
    return std::array<std::size_t, 2>{result.outside_nodes.size(), result.outside_edges.size()};
  };
  using Counts = std::array<std::size_t, 2>;
  EXPECT_EQ(counts({{1, 1, 1}, {1, 1, 2}, {3, 3, 3}}), (Counts{0, 0}));
  EXPECT_EQ(counts({{1, 1, 1}, {1, 1, 4}, {3, 3, 3}}), (Counts{1, 2})) << "a node on the surface";
  EXPECT_EQ(counts({{7, 3, 1}, {3, 7, 1}}), (Counts{0, 1})) << "around the corner";
  EXPECT_EQ(counts({{6, 2, 1}, {2, 6, 1}}), (Counts{0, 1})) << "touches the edge inside";
  EXPECT_EQ(counts({{6, 2, 1}, {2, 5.99, 1}}), (Counts{0, 0})) << "passes just below it";
  EXPECT_EQ(counts({{9, 9, 9}, {8, 9, 9}, {9, 8, 9}}), (Counts{3, 2}));
  EXPECT_EQ(counts({}), (Counts{0, 0}));
}

TEST(Containment, asks_no_more_than_the_concept)
{
  const archetypes::Domain<Point> half_space(0);
  const Containment result =
      containment(polyline({Point(0, 0, 1), Point(0, 0, -1), Point(1, 0, 1)}), half_space);
  EXPECT_EQ(result.outside_nodes, std::vector<std::size_t>{1});
  EXPECT_EQ(result.outside_edges, (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(result.is_inside());
}

} // namespace test_coverage
