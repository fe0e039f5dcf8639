// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Resampled curves are even, near what they were, and isotopic to it.

#include "resampling/resample.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace test_resample {

using namespace CGAL::Volume_filling_curves;
using vfc::Curve;
using vfc::resample;
using vfc::Resampling;
using Point_3 = Curve::Point_3;
using Points = std::vector<Point_3>;

double distance(const Point_3& p, const Curve& curve)
{
  const internal::Vector x = internal::to_vector(p);
  double least = std::numeric_limits<double>::infinity();
  for(const std::size_t e : curve.edges())
    least = std::min(least, internal::squared_distance_to_segment(
                                x, internal::to_vector(curve.point(curve.source(e))),
                                internal::to_vector(curve.point(curve.target(e)))));
  return std::sqrt(least);
}

void expect_near(const Curve& a, const Curve& b, double bound)
{
  for(const Point_3& p : a.points()) EXPECT_LE(distance(p, b), bound * (1 + 1e-9) + 1e-12);
}

TEST(Resample, spaces_nodes_evenly_on_the_curve)
{
  for(const double spacing : {0.05, 0.4, 1.}) {
    const Curve knot = make_torus_knot(2, 3, 100, 1);
    Curve curve = knot;
    const Resampling result = resample(curve, spacing);
    const double number = std::round(length(knot) / spacing);
    EXPECT_EQ(static_cast<double>(curve.number_of_nodes()), number);
    EXPECT_EQ(result.number_of_kept_nodes, 0u);
    EXPECT_LE(result.max_spacing, length(knot) / number * (1 + 1e-9));
    EXPECT_GT(result.min_spacing, 0.9 * spacing);
    EXPECT_EQ(curve.point(0), knot.point(0));
    EXPECT_TRUE(is_embedded(curve));
    EXPECT_LE(result.max_distance, spacing / 2);
    expect_near(curve, knot, 0);
    expect_near(knot, curve, result.max_distance);
  }
}

TEST(Resample, keeps_ends_and_junctions)
{
  Curve star(Points{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)},
             {{1, 0}, {0, 2}, {0, 3}}); // the first edge leads to the junction
  resample(star, 0.25);
  EXPECT_EQ(star.number_of_nodes(), 13u);
  std::size_t ends = 0, junctions = 0;
  for(const std::size_t v : star.nodes()) {
    ends += star.degree(v) == 1;
    junctions += star.degree(v) == 3;
  }
  EXPECT_EQ(ends, 3u);
  EXPECT_EQ(junctions, 1u);
}

TEST(Resample, keeps_a_node_that_holds_two_strands_apart)
{
  Curve linked(std::vector<Points>{{Point_3(-1, 0, 0), Point_3(0, 1, 0), Point_3(1, 0, 0)},
                                   {Point_3(0, 0.5, -1), Point_3(0, 0.5, 1)}});
  const Resampling result = resample(linked, 10);
  EXPECT_EQ(result.number_of_kept_nodes, 1u);
  EXPECT_EQ(linked.number_of_nodes(), 5u);
}

TEST(Resample, keeps_linking_numbers_at_any_spacing)
{
  const Curve link = make_closed_braid(parse_braid_word("1 1 1 1"), 200, 1);
  for(const double spacing : {0.1, 1., 3., 100.}) {
    Curve curve = link;
    resample(curve, spacing);
    EXPECT_TRUE(is_embedded(curve));
    EXPECT_EQ(linking_matrix(curve), linking_matrix(link));
  }
}

TEST(Resample, refuses_more_nodes_than_memory_holds)
{
  Curve knot = make_torus_knot(2, 3, 100, 1);
  EXPECT_THROW(resample(knot, 1e-9), std::invalid_argument);
}

} // namespace test_resample
