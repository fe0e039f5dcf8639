// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Measures of the curve of an arc and its images.

#include "files/mesh_files.h"
#include "symmetry/images.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace test_images {

using CGAL::Volume_filling_curves::Filling_status;
using CGAL::Volume_filling_curves::Run_progress;
using Point = vfc::Kernel::Point_3;

// A square around the middle of a cube, which fills it, or so it was thought.
struct Filling
{
  Filling()
  {
    vfc::Mesh cube;
    CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                          Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), cube);
    CGAL::Polygon_mesh_processing::triangulate_faces(cube);
    domain.emplace(cube);
    const double a = 0.5;
    const std::vector<Point> square = {{a, a, 0}, {-a, a, 0}, {-a, -a, 0}, {a, -a, 0}, {a, a, 0}};
    curve = vfc::Curve(std::vector<std::vector<Point>>{square});
    result.status = Filling_status::CONVERGED;
    result.thickness = 0.5;
    result.min_bend_radius = result.min_wall_distance = 7; // of the arc
    result.coverage.fraction_within_r = 7;
  }

  void measure_while(bool goes_on)
  {
    vfc::measure_again(result, curve, *domain, {},
                       [goes_on](const Run_progress&) { return goes_on; });
  }

  std::optional<vfc::Domain> domain;
  vfc::Curve curve;
  vfc::Filling_result result;
};

TEST(Images, are_measured_together)
{
  Filling filling;
  filling.measure_while(true);
  EXPECT_EQ(filling.result.min_bend_radius, 0.5);
  EXPECT_EQ(filling.result.min_wall_distance, 0.5);
  EXPECT_LT(filling.result.coverage.fraction_within_r, 1);
  EXPECT_NE(filling.result.status, Filling_status::LIMIT);
}

TEST(Images, have_no_measures_of_the_arc_if_the_measuring_is_stopped)
{
  Filling filling;
  filling.measure_while(false);
  EXPECT_TRUE(std::isnan(filling.result.min_bend_radius));
  EXPECT_TRUE(std::isnan(filling.result.min_wall_distance));
  EXPECT_TRUE(std::isnan(filling.result.unfilled_fraction));
  EXPECT_TRUE(std::isnan(filling.result.crowded_fraction));
  EXPECT_FALSE(filling.result.coverage.fraction_within_r == 7);
  EXPECT_EQ(filling.result.status, Filling_status::LIMIT);
}

TEST(Images, keep_the_status_of_a_run_that_ended_early_anyway)
{
  Filling filling;
  filling.result.status = Filling_status::STALLED;
  filling.measure_while(false);
  EXPECT_EQ(filling.result.status, Filling_status::STALLED);
}

} // namespace test_images
