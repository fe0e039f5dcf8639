// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Arc splines are certified if and only if no two corner triangles meet, by the judgement of
// rational arithmetic on all pairs.

#include "support/arc_spline_test_support.h"
#include "support/exact_brute_force.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/arc_spline.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_arc_certificates {

using namespace arc_spline_test;

using Exact = CGAL::Gmpq;

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

// All of a ball of radius 4 but for a segment that is parallel to the z axis.
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
    FAIL() << "nodes 1 to 4 are outside";
  } catch(const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("node 1"), std::string::npos) << error.what();
  }
}

} // namespace test_arc_certificates
