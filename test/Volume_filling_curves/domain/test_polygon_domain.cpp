// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/domain_test_support.h"
#include "support/polygon_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/planar_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace test_polygon_domain {

using namespace domain_test;
using Point_2 = internal::Planar_point;
using internal::Vector;
using polygons::disk;
using polygons::Polygon;
using polygons::polygon;
using polygons::rectangle;
using polygons::Ring;
using Domain = Polygon_domain_3<>;
using Polygons = std::vector<Polygon>;

// A simple polygon whose corners have few different coordinates, with a hole.
Polygon comb()
{
  const std::vector<polygons::Corner> outer = {{0, 0}, {8, 0}, {8, 6}, {6, 6}, {6, 2}, {4, 2},
                                               {4, 7}, {2, 7}, {2, 4}, {1, 4}, {1, 7}, {0, 7}};
  return polygon(polygons::ring(outer), {polygons::ring({{1, 1}, {3, 1}, {2, 2}})});
}

bool is_inside(const Polygon& polygon, const Point_2& p)
{
  if(!polygon.outer_boundary().has_on_bounded_side(p)) return false;
  return std::all_of(polygon.holes_begin(), polygon.holes_end(),
                     [&](const Ring& hole) { return hole.has_on_unbounded_side(p); });
}

Point_2 in_plane(const Point& p)
{
  return {p.x(), p.y()};
}
Point flat(double x, double y)
{
  return {x, y, 0};
}

// half of a lattice point, on edges and corners in many cases
Point half_lattice_point(Random& random)
{
  const Point p = lattice_point(random, 18);
  return flat(p.x() / 2, p.y() / 2);
}

TEST(Polygon_domain, is_planar_and_knows_its_boundary)
{
  static_assert(internal::Space_of<Domain>::is_plane);
  static_assert(internal::Is_domain<Domain>::value && internal::Is_scalable<Domain>::value);
  static_assert(internal::Has_surface<Domain>::value);
  static_assert(!internal::Space_of<Mesh_domain>::is_plane);
  const CGAL::Bbox_3 box = Domain(comb()).bbox();
  EXPECT_EQ(box, CGAL::Bbox_3(0, 0, 0, 8, 7, 0));
}

TEST(Polygon_domain, decides_like_the_polygon_for_points_on_edges_and_corners)
{
  const Domain domain(comb());
  Random random(1);
  int inside = 0;
  for(int k = 0; k < 5000; ++k) {
    const Point p = half_lattice_point(random);
    EXPECT_EQ(domain.is_inside(p), is_inside(comb(), in_plane(p))) << p;
    inside += domain.is_inside(p);
  }
  EXPECT_GT(inside, 1000);
}

TEST(Polygon_domain, has_everything_off_the_plane_outside)
{
  const Domain domain(comb());
  const double least = std::numeric_limits<double>::denorm_min();
  const Point p = flat(.5, .5), above(.5, .5, least), below(.5, .5, -least);
  EXPECT_TRUE(domain.is_inside(p));
  EXPECT_TRUE(domain.is_inside(Point(.5, .5, -0.)));
  EXPECT_FALSE(domain.is_inside(above));
  EXPECT_FALSE(domain.is_inside(below));
  EXPECT_TRUE(domain.is_triangle_inside(p, p, p));
  EXPECT_FALSE(domain.is_triangle_inside(p, above, p));
  EXPECT_FALSE(domain.is_triangle_inside(p, p, below));
  EXPECT_EQ(domain.distance_along(p, {0, 0, 1}, 1), 0);
}

// The same decided with exact constructions: the sides miss the boundary, and no corner of that is
// in the triangle.
bool is_triangle_inside(const Polygon& polygon, const std::array<Point_2, 3>& t)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const Point_2& p) { return Exact::Point_2(p.x(), p.y()); };
  const auto meets = [&](const Ring& ring) {
    for(auto edge = ring.edges_begin(); edge != ring.edges_end(); ++edge)
      for(std::size_t i = 0; i < 3; ++i) {
        const Exact::Segment_2 s(exact(edge->source()), exact(edge->target()));
        const Point_2 &a = t[i], &b = t[(i + 1) % 3];
        if(a == b ? s.has_on(exact(a))
                  : CGAL::do_intersect(s, Exact::Segment_2(exact(a), exact(b))))
          return true;
      }
    return CGAL::orientation(t[0], t[1], t[2]) != CGAL::COLLINEAR &&
           !CGAL::Triangle_2<polygons::Kernel>(t[0], t[1], t[2])
                .has_on_unbounded_side(ring.vertex(0));
  };
  return !meets(polygon.outer_boundary()) &&
         std::none_of(polygon.holes_begin(), polygon.holes_end(), meets);
}

TEST(Polygon_domain, decides_exactly_whether_triangles_flat_ones_among_them_are_inside)
{
  const Domain domain(comb());
  Random random(2);
  int inside = 0, outside = 0;
  while(inside + outside < 4000) {
    const Point p = half_lattice_point(random), q = half_lattice_point(random);
    const Point r =
        random.index(3) == 0 ? (random.index(2) == 0 ? p : q) : half_lattice_point(random);
    if(!domain.is_inside(p)) continue;
    const bool expected = is_triangle_inside(comb(), {in_plane(p), in_plane(q), in_plane(r)});
    EXPECT_EQ(domain.is_triangle_inside(p, q, r), expected) << p << ", " << q << ", " << r;
    ++(expected ? inside : outside);
  }
  EXPECT_GT(inside, 100);
}

TEST(Planar_predicates, find_segments_that_meet_and_points_that_they_hold)
{
  const Point_2 a(0, 0), b(4, 0), c(2, 0), d(2, 3), e(6, 0), f(5, 0), g(2, 1);
  EXPECT_TRUE(internal::do_segments_meet(a, b, c, d)); // touches
  EXPECT_FALSE(internal::do_segments_meet(a, b, g, d));
  EXPECT_TRUE(internal::do_segments_meet(a, b, c, e)); // overlap on a line
  EXPECT_FALSE(internal::do_segments_meet(a, b, f, e));
  EXPECT_TRUE(internal::do_segments_meet(a, b, c, c)); // degenerate
  EXPECT_FALSE(internal::do_segments_meet(a, b, g, g));
  EXPECT_TRUE(internal::do_segments_meet(c, c, c, c));
  EXPECT_FALSE(internal::do_segments_meet(c, c, f, f));
  EXPECT_TRUE(internal::does_segment_hold(a, b, c));
  EXPECT_FALSE(internal::does_segment_hold(a, b, e));
}

// The distance to the nearest edge, by looking at all of them.
double distance_to(const Ring& ring, const Point& p)
{
  double least = infinity;
  for(auto e = ring.edges_begin(); e != ring.edges_end(); ++e)
    least = (std::min)(least, internal::squared_distance_to_segment(
                                  internal::to_vector(p), {e->source().x(), e->source().y(), 0},
                                  {e->target().x(), e->target().y(), 0}));
  return std::sqrt(least);
}

TEST(Polygon_domain, measures_distances_to_its_edges)
{
  const Polygon plate = polygons::plate();
  const Domain domain(plate);
  Random random(3);
  for(int k = 0; k < 1000; ++k) {
    const Point p = random_point(random, {-2, -2, 0, 2, 2, 0});
    double expected = distance_to(plate.outer_boundary(), p);
    for(const Ring& hole : plate.holes()) expected = (std::min)(expected, distance_to(hole, p));
    EXPECT_NEAR(domain.distance(p), expected, 1e-12);
    EXPECT_EQ(domain.distance_up_to(p, .1), (std::min)(domain.distance(p), .1));
  }
}

// The nearest points of segments that pass a corner are inside them.
TEST(Polygon_domain, measures_distances_of_segments_to_its_edges)
{
  const Polygon polygon = comb();
  const Domain domain(polygon);
  Random random(5);
  int number_inside = 0;
  for(int k = 0; k < 2000; ++k) {
    const Point p = half_lattice_point(random), q = half_lattice_point(random);
    if(!domain.is_inside(p) || !domain.is_triangle_inside(p, q, q)) continue;
    const auto [distance, position] = domain.distance_of_segment(p, q);
    double least = infinity;
    const auto compare = [&](const Ring& ring) {
      for(auto e = ring.edges_begin(); e != ring.edges_end(); ++e)
        least = (std::min)(least, std::sqrt(CGAL::squared_distance(
                                      *e, polygons::Kernel::Segment_2(in_plane(p), in_plane(q)))));
    };
    compare(polygon.outer_boundary());
    for(const Ring& hole : polygon.holes()) compare(hole);
    EXPECT_NEAR(distance, least, 1e-12) << p << ", " << q;
    EXPECT_NEAR(domain.distance(p + position * (q - p)), distance, 1e-12) << p << ", " << q;
    number_inside += 0 < position && position < 1;
  }
  EXPECT_GT(number_inside, 20);
}

TEST(Polygon_domain, ends_rays_at_the_boundary)
{
  const Domain domain(polygons::plate());
  Random random(4);
  int ended = 0;
  for(int k = 0; k < 1000; ++k) {
    const Point p = random_point(random, domain.bbox());
    const double angle = 7 * random.real(), limit = 1;
    const Vector u(std::cos(angle), std::sin(angle), 0);
    if(!domain.is_inside(p)) continue;
    const double t = domain.distance_along(p, {u.x(), u.y(), u.z()}, limit);
    const auto at = [&](double s) { return flat(p.x() + s * u.x(), p.y() + s * u.y()); };
    EXPECT_TRUE(domain.is_triangle_inside(p, at((1 - 1e-9) * t), p));
    if(t == limit) continue;
    EXPECT_FALSE(domain.is_triangle_inside(p, at((1 + 1e-9) * t), p));
    ++ended;
  }
  EXPECT_GT(ended, 200);
}

TEST(Polygon_domain, does_not_depend_on_orientations_or_repeated_corners)
{
  Polygon turned = comb();
  turned.outer_boundary().reverse_orientation();
  turned.outer_boundary().push_back(turned.outer_boundary().vertex(0)); // as in WKT
  turned.holes_begin()->reverse_orientation();
  const Domain expected(comb()), domain(turned);
  Random random(5);
  for(int k = 0; k < 1000; ++k) {
    const Point p = half_lattice_point(random);
    EXPECT_EQ(domain.is_inside(p), expected.is_inside(p));
  }
}

// a plate with a hole, a disk in the hole, and a square beside them
Polygons nest()
{
  return {polygon(rectangle(0, 0, 2, 2), {disk(1, 1, .6)}), polygon(disk(1, 1, .4)),
          polygon(rectangle(2.5, 0, 1, 1))};
}

TEST(Polygon_domain, numbers_its_polygons_as_parts)
{
  const Domain domain(nest());
  ASSERT_EQ(domain.part_boxes().size(), 3u);
  EXPECT_EQ(domain.part(flat(.1, 1)), 0u);
  EXPECT_EQ(domain.part(flat(1, 1)), 1u);
  EXPECT_EQ(domain.part(flat(3, .5)), 2u);
  EXPECT_FALSE(domain.is_inside(flat(1, 1.5)));
  EXPECT_EQ(domain.part_boxes()[2], CGAL::Bbox_3(2.5, 0, 0, 3.5, 1, 0));
}

TEST(Polygon_domain, is_scaled_by_powers_of_two)
{
  const Domain domain(nest()), large = domain.scaled(0x1p200);
  Random random(6);
  for(int k = 0; k < 300; ++k) {
    const Point p = random_point(random, domain.bbox());
    const Point q(0x1p200 * p.x(), 0x1p200 * p.y(), 0);
    EXPECT_EQ(large.is_inside(q), domain.is_inside(p));
    EXPECT_EQ(large.distance(q), 0x1p200 * domain.distance(p));
  }
}

template <typename Input>
std::string refusal(const Input& input)
{
  return refusal_of([&] { const Domain domain(input); });
}

TEST(Polygon_domain, names_the_edges_that_meet)
{
  const Ring eight = polygons::ring({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(refusal(eight), "self-contact: the edge of corners 0 and 1 of the outer boundary of "
                            "polygon 0 at (0, 0) meets the edge of corners 2 and 3 of the outer "
                            "boundary of polygon 0 at (2, 0)");
  const Ring pinched = polygons::ring({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
  EXPECT_NE(refusal(pinched).find("self-contact"), std::string::npos);
  const Ring spike = polygons::ring({{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 2}});
  EXPECT_NE(refusal(spike).find("self-contact"), std::string::npos);
  const Polygon touching =
      polygon(rectangle(0, 0, 2, 2), {polygons::ring({{0, 1}, {1, .5}, {1, 1}})});
  EXPECT_NE(refusal(touching).find("of hole 0 of polygon 0"), std::string::npos);
}

TEST(Polygon_domain, refuses_rings_that_bound_no_area_or_lie_in_the_wrong_place)
{
  const Ring square = rectangle(0, 0, 4, 4);
  EXPECT_NE(refusal(Polygons()).find("no polygons"), std::string::npos);
  EXPECT_NE(refusal(Polygon()).find("fewer than 3"), std::string::npos);
  EXPECT_NE(refusal(polygons::ring({{0, 0}, {1, 0}, {1, 0}})).find("fewer than 3"),
            std::string::npos);
  EXPECT_NE(refusal(polygons::ring({{0, 0}, {1, 0}, {2, 0}})).find("self-contact"),
            std::string::npos);
  EXPECT_NE(refusal(polygons::ring({{0, 0}, {1, 0}, {1, infinity}})).find("corner 2"),
            std::string::npos);
  EXPECT_NE(refusal(polygons::ring({{0, 0}, {1, 0}, {1, 1e101}})).find("beyond 1e100"),
            std::string::npos);
  EXPECT_NE(refusal(polygon(square, {rectangle(5, 0, 1, 1)})).find("hole 0 of polygon 0 lies outs"),
            std::string::npos);
  EXPECT_NE(
      refusal(polygon(square, {disk(2, 2, 1), disk(2, 2, .5)})).find("hole 1 of polygon 0 lies w"),
      std::string::npos);
  EXPECT_NE(refusal(Polygons{polygon(square), polygon(rectangle(1, 1, 1, 1))}).find("overlap"),
            std::string::npos);
  EXPECT_EQ(refusal(nest()), "");
}

} // namespace test_polygon_domain
