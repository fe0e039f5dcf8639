// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_long_fill {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Mesh = CGAL::Surface_mesh<Point>;
using Ball = VFC::Ball_domain_3<Kernel>;
using Box = VFC::Box_domain_3<Kernel>;
using Mesh_domain = VFC::Triangle_mesh_domain_3<Kernel>;
using VFC::Filling_status;

Mesh cube()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(const auto f : faces) {
    const auto h = mesh.halfedge(f);
    CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  }
  return mesh;
}

TEST(Long_fill, covers_a_ball_evenly)
{
  const Ball ball(Point(1, 2, 3), 1);
  Curve curve;
  const auto result = VFC::fill(curve, ball, preview(0.15));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_TRUE(result.empty_regions.empty());
  expect_inside(curve, ball);
  const VFC::Coverage c = coverage(curve, ball, 0.15);
  EXPECT_GT(c.fraction_within_r, 0.75);
  EXPECT_LT(c.p99, 1.45);
  EXPECT_LT(c.max, 2.5);
  EXPECT_NEAR(result.medial_radius, 0.15, 0.05 * 0.15);
}

TEST(Long_fill, covers_a_mesh_of_twelve_triangles)
{
  const Mesh_domain domain(cube());
  Curve curve;
  const auto result = VFC::fill(curve, domain, preview(0.1));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  expect_inside(curve, domain);
  const VFC::Coverage c = coverage(curve, domain, 0.1);
  EXPECT_GT(c.fraction_within_r, 0.75);
  EXPECT_LT(c.p99, 1.45);
}

TEST(Long_fill, takes_as_many_iterations_at_every_size)
{
  const Mesh_domain domain(cube());
  for(const double thickness : {0.2, 0.1, 0.05}) {
    Curve curve;
    const auto result = VFC::fill(curve, domain, preview(thickness));
    EXPECT_LE(result.statistics.iterations, 30u) << "with a thickness of " << thickness;
  }
}

TEST(Long_fill, refines_the_edges_in_the_end)
{
  const Ball ball(Point(1, 2, 3), 1);
  Curve curve;
  VFC::fill(curve, ball, preview(0.2).spacing(0.1));
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    EXPECT_LE(CGAL::squared_distance(curve.point(curve.source(e)), curve.point(curve.target(e))),
              CGAL::square(2.2 * 0.1 * 0.2)); // what a last step adds
}

TEST(Long_fill, keeps_clear_of_the_wall_on_request)
{
  const Ball ball(Point(0, 0, 0), 1);
  Curve covering, clear;
  VFC::fill(covering, ball, preview(0.15).number_of_iterations(120));
  VFC::fill(clear, ball, preview(0.15).wall(VFC::Wall::KEEP_CLEAR).number_of_iterations(120));
  const auto min_distance = [&](const Curve& curve) {
    double least = 1;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      least = (std::min)(least, ball.distance(curve.point(v)));
    return least;
  };
  EXPECT_GT(min_distance(clear), 1.5 * 0.15);
  EXPECT_LT(min_distance(covering), 1.2 * 0.15);
}

TEST(Long_fill, reproduces_a_thickness_that_varies)
{
  const Box box(Point(0, 0, 0), Point(2, 1, 1));
  const auto thickness = [](const Point& p) { return 0.08 + 0.04 * p.x(); };
  Curve curve;
  const auto result = VFC::fill(curve, box, preview(thickness));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  expect_inside(curve, box);
  const VFC::Domain_samples_3<Traits, Box> samples(box, 20000, 1);
  const auto distances = VFC::sample_distances(curve, samples);
  // in units of the local thickness, both halves look the same
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  for(std::size_t k = 0; k < distances.size(); ++k) {
    const Point& p = samples.points()[k];
    const int half = p.x() < 1 ? 0 : 1;
    sum[half] += distances[k] / thickness(p);
    ++count[half];
  }
  EXPECT_NEAR(sum[0] / count[0], sum[1] / count[1], 0.08);
  EXPECT_GT(VFC::coverage(samples, distances, thickness).fraction_within_r, 0.7);
}

TEST(Long_fill, finds_the_thickness_for_a_length)
{
  const Ball ball(Point(0, 0, 0), 1);
  Curve curve;
  const auto result = VFC::fill(curve, ball, np::length(40.).round_bends(false));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  double length = 0;
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    length += std::sqrt(
        CGAL::squared_distance(curve.point(curve.source(e)), curve.point(curve.target(e))));
  EXPECT_NEAR(length, 40, 0.02 * 40);
}

} // namespace test_long_fill
