// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Arc splines are smooth, have the bend radius of each corner, and are certified if and only if no
// two corner triangles meet, by the judgement of rational arithmetic on all pairs.

#include "support/exact_brute_force.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/arc_spline.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <CGAL/Gmpq.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_arc_spline {

using namespace CGAL::Volume_filling_curves;

using Curve = Curve_network_3<>;
using Point_3 = Curve::Point_3;
using Spline = Arc_spline<Point_3>;
using Piece = Arc_spline_piece<Point_3>;
using Points = std::vector<Point_3>;
using Exact = CGAL::Gmpq;

internal::Vector vector(const Point_3& p)
{
  return internal::to_vector(p);
}

// Closed polylines repeat their first point.
Curve curve_of(const std::vector<Points>& polylines)
{
  return Curve(polylines);
}

std::vector<Piece> pieces(const Spline& spline)
{
  std::vector<Piece> all;
  for(const auto& path : spline.paths)
    all.insert(all.end(), path.pieces.begin(), path.pieces.end());
  return all;
}

std::vector<std::size_t> conflicting_nodes(const Spline& spline)
{
  std::vector<std::size_t> nodes;
  for(const Arc_conflict& conflict : spline.conflicts) nodes.push_back(conflict.node);
  return nodes;
}

// the radius of the circle through the start, the middle and the end
double radius_through_points(const Piece& arc)
{
  const auto a = vector(arc.start) - vector(arc.middle), b = vector(arc.end) - vector(arc.middle);
  return a.norm() * b.norm() * (a - b).norm() / (2 * a.cross(b).norm());
}

// Each piece begins where the one before it ends, in its direction.
void expect_smooth(const Spline& spline)
{
  for(const auto& path : spline.paths)
    for(std::size_t k = 0; k < path.pieces.size(); ++k) {
      if(k == 0 && !path.is_closed) continue;
      const Piece& last = path.pieces[k == 0 ? path.pieces.size() - 1 : k - 1];
      const Piece& next = path.pieces[k];
      EXPECT_EQ(last.end, next.start);
      if(!last.is_arc() && !next.is_arc()) continue; // a straight corner
      const auto in = (vector(last.end) - vector(last.corner)).normalized();
      const auto out = (vector(next.corner) - vector(next.start)).normalized();
      EXPECT_LT((in - out).norm(), 1e-6);
    }
}

void expect_arcs_of_corners(const Spline& spline, const Curve& curve)
{
  const std::vector<double> curvatures = node_curvatures(curve);
  double length = 0;
  for(const Piece& piece : pieces(spline)) {
    length += piece.length;
    if(!piece.is_arc()) continue;
    const std::size_t v = piece.node;
    EXPECT_EQ(piece.corner, curve.point(v));
    EXPECT_NEAR(piece.radius * curvatures[v], 1, 1e-12);
    const double rise =
        (vector(piece.middle) - (vector(piece.start) + vector(piece.end)) / 2).norm();
    EXPECT_NEAR(radius_through_points(piece) / piece.radius, 1, 1e-9 + 1e-13 / rise);
    const auto p = vector(piece.corner);
    const double shorter = (std::min)((vector(curve.point(curve.neighbor(v, 0))) - p).norm(),
                                      (vector(curve.point(curve.neighbor(v, 1))) - p).norm());
    EXPECT_NEAR((vector(piece.start) - p).norm() / (shorter / 2), 1, 1e-9);
    EXPECT_NEAR((vector(piece.end) - p).norm() / (shorter / 2), 1, 1e-9);
  }
  EXPECT_NEAR(spline.min_radius, min_bend_radius(curve), 1e-12 * spline.min_radius);
  EXPECT_NEAR(spline.length, length, 1e-9 * length);
  EXPECT_LT(spline.length, CGAL::Volume_filling_curves::length(curve));
}

// The corners whose triangles meet another triangle or a segment that has no end in common.
std::vector<std::size_t> nodes_in_contact_by_brute_force(const Spline& spline)
{
  using Vec = brute_force::Vec<Exact>;
  const auto hull = [](const Piece& piece) {
    std::vector<Vec> points;
    for(const Point_3& p : {piece.start, piece.corner, piece.end})
      if(piece.is_arc() || p != piece.corner)
        points.push_back({Exact(p.x()), Exact(p.y()), Exact(p.z())});
    return points;
  };
  const auto box = [](const Piece& piece) {
    return piece.start.bbox() + piece.corner.bbox() + piece.end.bbox();
  };
  const std::vector<Piece> all = pieces(spline);
  std::set<std::size_t> nodes;
  for(std::size_t i = 0; i < all.size(); ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const Piece &s = all[i], &t = all[j];
      if((!s.is_arc() && !t.is_arc()) || !CGAL::do_overlap(box(s), box(t))) continue;
      if(s.start == t.end || s.end == t.start || s.start == t.start || s.end == t.end) continue;
      if(!brute_force::do_hulls_meet<Exact>(hull(s), hull(t))) continue;
      if(s.is_arc()) nodes.insert(s.node);
      if(t.is_arc()) nodes.insert(t.node);
    }
  return {nodes.begin(), nodes.end()};
}

// The spline as a polygon, whose edges are at most an eighth of an arc long.
Curve sampled(const Spline& spline)
{
  constexpr int parts = 8;
  std::vector<Points> polylines;
  for(const auto& path : spline.paths) {
    Points points = {path.pieces.front().start};
    for(const Piece& piece : path.pieces) {
      const auto a = vector(piece.start), p = vector(piece.corner), b = vector(piece.end);
      const double weight = std::cos(piece.length / piece.radius / 2);
      for(int k = 1; k < parts && piece.is_arc(); ++k) { // a rational quadratic Bezier curve
        const double t = static_cast<double>(k) / parts, s = 1 - t, w = 2 * s * t * weight;
        const auto x = (s * s * a + w * p + t * t * b) / (s * s + w + t * t);
        points.emplace_back(x.x(), x.y(), x.z());
      }
      points.push_back(piece.end);
    }
    polylines.push_back(points);
  }
  return Curve(polylines);
}

Points regular_polygon(std::size_t n)
{
  Points points;
  for(std::size_t k = 0; k <= n; ++k) {
    const double angle = 2 * CGAL_PI * static_cast<double>(k % n) / static_cast<double>(n);
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return points;
}

TEST(Arc_spline, of_a_regular_polygon_is_its_inscribed_circle)
{
  for(const std::size_t n : {3u, 4u, 7u, 100u}) {
    const Curve polygon = curve_of({regular_polygon(n)});
    const Spline spline = arc_spline(polygon);
    const double radius = std::cos(CGAL_PI / static_cast<double>(n));
    EXPECT_TRUE(spline.is_certified);
    EXPECT_EQ(spline.number_of_arcs, n);
    EXPECT_EQ(spline.number_of_segments, 0u) << "arcs of equal edges end in one point";
    EXPECT_NEAR(spline.length, 2 * CGAL_PI * radius, 1e-12);
    EXPECT_NEAR(spline.max_distance, 1 - radius, 1e-12);
    EXPECT_TRUE(spline.paths[0].is_closed);
    expect_smooth(spline);
    expect_arcs_of_corners(spline, polygon);
  }
}

TEST(Arc_spline, has_the_bend_radius_of_each_corner)
{
  for(const Curve& curve :
      {make_torus_knot(2, 3, 100, 1), make_torus_knot(3, 5, 300, 1), make_random_polygon(50, 1),
       make_closed_braid(parse_braid_word("1 -2 1 -2"), 300, 1)}) {
    const Spline spline = arc_spline(curve);
    EXPECT_EQ(spline.number_of_arcs, curve.number_of_nodes());
    expect_smooth(spline);
    expect_arcs_of_corners(spline, curve);
  }
}

TEST(Arc_spline, of_a_filling_is_certified_inside)
{
  Curve curve;
  const Ball_domain_3 ball(Point_3(0, 0, 0), 1);
  fill(curve, ball, parameters::thickness(0.25).number_of_iterations(60));
  const Spline spline = arc_spline(curve, ball);
  EXPECT_TRUE(spline.is_certified);
  expect_smooth(spline);
  expect_arcs_of_corners(spline, curve);
  EXPECT_TRUE(nodes_in_contact_by_brute_force(spline).empty());
}

// One edge of length 2, one of length 1, and a strand through the corner or beside it.
Curve corner_and_strand(double x)
{
  return curve_of({{Point_3(2, 0, 0), Point_3(0, 0, 0), Point_3(0, 1, 0)},
                   {Point_3(x, x, -1), Point_3(x, x, 1)}});
}

TEST(Arc_spline, is_refused_where_a_strand_cuts_a_corner)
{
  for(const double x : {0.01, 0.2, 0.25}) { // the last one touches the chord
    const Spline spline = arc_spline(corner_and_strand(x));
    EXPECT_FALSE(spline.is_certified);
    ASSERT_EQ(spline.conflicts.size(), 1u);
    EXPECT_EQ(spline.conflicts[0].node, 1u);
    EXPECT_EQ(spline.conflicts[0].obstacle, Arc_obstacle::STRAND);
    EXPECT_EQ(spline.conflicts[0].other, 3u);
    EXPECT_EQ(spline.number_of_arcs, 1u) << "an uncertified spline is returned nevertheless";
  }
  EXPECT_TRUE(arc_spline(corner_and_strand(0.2500001)).is_certified);
  EXPECT_TRUE(arc_spline(corner_and_strand(-1e-9)).is_certified);
}

// The triangles of two corners meet although no edge of the curve meets a triangle.
TEST(Arc_spline, is_refused_where_only_chords_meet_triangles)
{
  const auto two_corners = [](double x) {
    return curve_of({{Point_3(1, 0, 0), Point_3(0, 0, 0), Point_3(0, 1, 0)},
                     {Point_3(x - 0.8, x - 0.8, 1), Point_3(x + 0.8, x + 0.8, 0),
                      Point_3(x - 0.8, x - 0.8, -1)}});
  };
  EXPECT_EQ(conflicting_nodes(arc_spline(two_corners(0.2))), (std::vector<std::size_t>{1, 4}));
  EXPECT_TRUE(arc_spline(two_corners(0.26)).is_certified);
}

TEST(Arc_spline, has_the_conflicts_that_brute_force_finds)
{
  std::size_t number_of_certified = 0;
  for(std::size_t seed = 0; seed < 40; ++seed) {
    const Curve polygon = make_random_polygon(10 + 2 * seed, seed);
    const Spline spline = arc_spline(polygon);
    const auto expected = nodes_in_contact_by_brute_force(spline);
    EXPECT_EQ(conflicting_nodes(spline), expected) << "seed " << seed;
    EXPECT_EQ(spline.is_certified, expected.empty());
    if(!spline.is_certified) continue;
    ++number_of_certified;
    EXPECT_TRUE(is_embedded(sampled(spline)));
  }
  EXPECT_GT(number_of_certified, 0u);
  EXPECT_LT(number_of_certified, 40u);
}

// Right angles, coplanar triangles and common ends everywhere.
TEST(Arc_spline, of_lattice_polygons_is_certified)
{
  for(std::size_t seed = 0; seed < 30; ++seed) {
    const Curve polygon = make_lattice_polygon(120, seed);
    const Spline spline = arc_spline(polygon);
    EXPECT_TRUE(spline.is_certified) << "seed " << seed;
    EXPECT_TRUE(nodes_in_contact_by_brute_force(spline).empty());
    expect_smooth(spline);
  }
}

TEST(Arc_spline, keeps_linking_numbers)
{
  const Curve link = make_closed_braid(parse_braid_word("1 1 1 1"), 200, 1);
  const Spline spline = arc_spline(link);
  ASSERT_TRUE(spline.is_certified);
  EXPECT_EQ(linking_matrix(sampled(spline)), linking_matrix(link));
}

TEST(Arc_spline, has_no_arcs_at_straight_corners_and_ends)
{
  const Curve straight =
      curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(3, 0, 0), Point_3(3, 1, 0)}});
  const Spline spline = arc_spline(straight);
  EXPECT_TRUE(spline.is_certified);
  EXPECT_EQ(spline.number_of_arcs, 1u);
  EXPECT_EQ(spline.number_of_segments, 4u - 1);
  EXPECT_FALSE(spline.paths[0].is_closed);
  EXPECT_EQ(spline.paths[0].pieces.front().start, straight.point(0));
  EXPECT_EQ(spline.paths[0].pieces.back().end, straight.point(3));
  const Spline segment = arc_spline(curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0)}}));
  EXPECT_TRUE(segment.is_certified);
  EXPECT_EQ(segment.min_radius, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(arc_spline(Curve()).is_certified);
}

TEST(Arc_spline, bends_as_tightly_as_a_nearly_reversing_corner)
{
  const double angle = 1e-7;
  const Curve spike = curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, angle, 0)}});
  const Spline spline = arc_spline(spike);
  EXPECT_TRUE(spline.is_certified);
  EXPECT_NEAR(spline.min_radius, angle / 4, 1e-9 * angle);
  EXPECT_NEAR(spline.max_distance, 0.5, 1e-6);
  EXPECT_THROW(
      (void)arc_spline(curve_of({{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(.5, 0, 0)}})),
      std::invalid_argument);
}

// The middle of an edge that is one unit in the last place long is one of its ends.
TEST(Arc_spline, is_refused_where_coordinates_are_too_coarse)
{
  const double next = 1 + std::numeric_limits<double>::epsilon();
  const Spline spline = arc_spline(
      curve_of({{Point_3(0, 0, 1), Point_3(1, 1, 1), Point_3(next, 1, 1), Point_3(2, 0, 2)}}));
  EXPECT_FALSE(spline.is_certified);
  ASSERT_FALSE(spline.conflicts.empty());
  for(const Arc_conflict& conflict : spline.conflicts)
    EXPECT_EQ(conflict.obstacle, Arc_obstacle::ROUNDING);
}

TEST(Arc_spline, ends_at_junctions)
{
  const Curve theta(Points{Point_3(0, 0, 0), Point_3(2, 0, 0), Point_3(1, 1, 0), Point_3(1, 0, 1)},
                    {{0, 1}, {2, 0}, {2, 1}, {0, 3}, {3, 1}}); // edges of any direction
  const Spline spline = arc_spline(theta);
  EXPECT_TRUE(spline.is_certified);
  ASSERT_EQ(spline.paths.size(), 3u);
  EXPECT_EQ(spline.number_of_arcs, 2u);
  for(const auto& path : spline.paths) {
    EXPECT_FALSE(path.is_closed);
    EXPECT_EQ(path.component, 0u);
    EXPECT_FALSE(path.pieces.front().is_arc());
    EXPECT_FALSE(path.pieces.back().is_arc());
  }
  expect_smooth(spline);
}

// All of a ball of radius 2 but for a segment that is parallel to the z axis.
class Cut_ball : public Ball_domain_3<>
{
public:
  explicit Cut_ball(double x) : Ball_domain_3<>(Point_3(0, 0, 0), 4), m_x(x) {}

  bool is_triangle_inside(const Point_3& p, const Point_3& q, const Point_3& r) const
  {
    const internal::Exact_predicates<Curve::Traits> predicates{Curve::Traits()};
    return Ball_domain_3<>::is_triangle_inside(p, q, r) &&
           !predicates.does_segment_meet_triangle(Point_3(m_x, m_x, -1), Point_3(m_x, m_x, 1), p, q,
                                                  r);
  }

  double distance(const Point_3&) const { return 0; }

private:
  double m_x;
};

TEST(Arc_spline, is_refused_where_the_boundary_cuts_a_corner)
{
  const Curve corner = curve_of({{Point_3(2, 0, 0), Point_3(0, 0, 0), Point_3(0, 1, 0)}});
  EXPECT_TRUE(arc_spline(corner, Cut_ball(0.26)).is_certified);
  const Spline spline = arc_spline(corner, Cut_ball(0.2));
  EXPECT_FALSE(spline.is_certified);
  ASSERT_EQ(spline.conflicts.size(), 1u);
  EXPECT_EQ(spline.conflicts[0].node, 1u);
  EXPECT_EQ(spline.conflicts[0].obstacle, Arc_obstacle::BOUNDARY);
}

TEST(Arc_spline, names_nodes_outside_the_domain)
{
  const Curve polygon = curve_of({regular_polygon(5)});
  try {
    (void)arc_spline(polygon, Ball_domain_3(Point_3(1, 0, 0), 1));
    FAIL() << "nodes 2 and 3 are outside";
  } catch(const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("node 1"), std::string::npos) << error.what();
  }
}

TEST(Arc_spline, scales_with_the_curve)
{
  const double factor = std::ldexp(1, 100);
  const auto points = [&](double scale) {
    Points all;
    const Curve polygon = make_random_polygon(60, 7);
    for(const Point_3& p : polygon.points())
      all.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    all.push_back(all.front());
    return all;
  };
  const Spline small = arc_spline(curve_of({points(1)})),
               large = arc_spline(curve_of({points(factor)}));
  EXPECT_EQ(conflicting_nodes(small), conflicting_nodes(large));
  EXPECT_EQ(factor * small.length, large.length);
  EXPECT_EQ(factor * small.min_radius, large.min_radius);
}

TEST(Arc_spline, ends_when_asked_to)
{
  EXPECT_THROW((void)arc_spline(make_random_polygon(100, 1),
                                parameters::progress([](const Run_progress&) { return false; })),
               Run_interrupted);
}

} // namespace test_arc_spline
