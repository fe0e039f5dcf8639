// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/cpu_time.h"
#include "support/fill_test_support.h"
#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_size.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace test_fill_limits {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using VFC::Run_progress;
using VFC::Run_stage;
using VFC::internal::Filling_size;
using Box = VFC::Box_domain_3<Kernel>;

const VFC::Ball_domain_3<Kernel> ball(Point(0, 0, 0), 1);

// The distances of uniform samples of a plate to its boundary.
std::vector<double> distances_in_plate(double thickness)
{
  std::vector<double> distances;
  for(int k = 1; k <= 1000; ++k) distances.push_back(k * thickness / 2000);
  return distances;
}

TEST(Filling_size, is_that_of_a_cube_which_was_filled)
{
  const Filling_size size(1, distances_in_plate(1. / 3), 0.2);
  EXPECT_NEAR(size.length(0.06), 75.4, 4);
  EXPECT_NEAR(size.number_of_nodes(0.06), 4561, 300);
}

TEST(Filling_size, lays_strands_side_by_side_in_a_thin_plate)
{
  const double width = 1e-6, r = 0.01;
  const Filling_size size(width, distances_in_plate(width), 0.2);
  EXPECT_NEAR(size.length(r), 1 / (2 * r), 1);
  EXPECT_NEAR(size.number_of_nodes(size.thickness_with(1000)), 1000, 1);
}

TEST(Filling_size, grows_by_the_inverse_cube_of_the_thickness)
{
  const Filling_size size(8, distances_in_plate(1), 0.2);
  EXPECT_DOUBLE_EQ(size.number_of_nodes(0.01), 8 * size.number_of_nodes(0.02));
  EXPECT_NEAR(size.number_of_nodes(size.thickness_with(5e6)), 5e6, 1);
}

TEST(Fill_limits, a_thickness_that_needs_too_many_nodes_is_refused)
{
  Curve curve;
  try {
    VFC::fill(curve, ball, np::thickness(1e-4));
    FAIL();
  } catch(const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("thickness is 0.0001, but the curve would have some "), 0u) << text;
    EXPECT_NE(text.find(" GB; with "), std::string::npos) << text;
  }
  EXPECT_EQ(curve.number_of_nodes(), 0u);
}

// Its mean is 0.1.
TEST(Fill_limits, a_field_that_needs_too_many_nodes_in_some_places_is_refused)
{
  Curve curve;
  const auto field = [](const Point& p) { return p.x() > 0 ? 1e-9 : 0.2; };
  EXPECT_THROW(VFC::fill(curve, ball, np::thickness(field)), std::invalid_argument);
  EXPECT_EQ(curve.number_of_nodes(), 0u);
}

TEST(Fill_limits, the_default_thickness_grows_in_thin_domains_and_says_so)
{
  const Box plate(Point(0, 0, 0), Point(1, 1, 0.02));
  Curve curve;
  Run_progress last;
  const auto note = [&](const Run_progress& progress) {
    last = progress;
    return progress.stage == Run_stage::PREPARING;
  };
  const auto result = VFC::fill(curve, plate, np::progress(note).round_bends(false));
  EXPECT_EQ(result.status, Filling_status::INTERRUPTED);
  EXPECT_NEAR(result.default_thickness, 2.5e-3, 1e-4);
  EXPECT_NEAR(result.thickness, 4.67e-3, 1e-4);
  EXPECT_EQ(last.default_thickness, result.default_thickness);
  EXPECT_EQ(last.thickness, result.thickness);
  EXPECT_NEAR(static_cast<double>(last.expected_nodes), 2e5, 1e3);
}

TEST(Fill_limits, the_default_thickness_does_not_grow_beyond_the_widest_ball)
{
  const Box plate(Point(0, 0, 0), Point(1, 1, 0.004)); // with r = 0.0031 it has 200,000 nodes
  Curve curve;
  const auto go_on = [](const Run_progress& progress) {
    return progress.stage == Run_stage::PREPARING;
  };
  const auto result = VFC::fill(curve, plate, np::progress(go_on));
  EXPECT_NEAR(result.thickness, 0.002, 1e-6);
  EXPECT_NEAR(result.default_thickness, 0.0005, 1e-6);
}

TEST(Fill_limits, a_domain_too_thin_for_any_default_thickness_is_refused)
{
  // of a mesh, which knows that it is in one piece
  meshes::Mesh plate;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1e-6), Point(0, 0, 1e-6), Point(1, 0, 1e-6), Point(1, 1, 1e-6),
                        plate);
  CGAL::Polygon_mesh_processing::triangulate_faces(plate);
  Curve curve;
  try {
    VFC::fill(curve, plate);
    FAIL();
  } catch(const std::invalid_argument& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find("thickness is 4.99"), 0u) << text;
    EXPECT_NE(text.find("e-07, but the curve would have some "), std::string::npos) << text;
    EXPECT_NE(text.find("the most that are allowed by default"), std::string::npos) << text;
  }
}

// the signed distance to a ball in each unit cube
double distance_to_balls(const Point& p)
{
  const auto from_center = [](double x) { return x - std::floor(x) - 0.5; };
  return std::hypot(from_center(p.x()), from_center(p.y()), from_center(p.z())) - 0.4;
}

TEST(Fill_limits, a_run_that_is_stopped_returns_soon_whatever_the_number_of_parts)
{
  const VFC::Implicit_domain_3 balls(&distance_to_balls, CGAL::Bbox_3(0, 0, 0, 12, 12, 12));
  Curve curve;
  double seconds_at_stop = 0;
  const auto go_on = [&](const Run_progress& progress) {
    if(progress.stage == Run_stage::PREPARING) return true;
    seconds_at_stop = cpu_time::of_process();
    return false;
  };
  const double start = cpu_time::of_process();
  const auto result = VFC::fill(curve, balls, np::thickness(0.3).progress(go_on));
  EXPECT_EQ(result.status, Filling_status::INTERRUPTED);
  EXPECT_EQ(result.parts, 1728u);
  EXPECT_EQ(result.unreachable_parts, 0u);
  EXPECT_LT(cpu_time::of_process() - seconds_at_stop, seconds_at_stop - start);
}

TEST(Fill_limits, a_run_can_be_stopped_while_the_domain_is_made_of_a_mesh)
{
  std::vector<std::array<int, 3>> cubes;
  for(int k = 0; k < 200; ++k) cubes.push_back({k, 0, 0});
  const auto mesh = meshes::to_mesh(meshes::voxels(cubes));
  Curve curve;
  const auto result = VFC::fill(curve, mesh, np::progress([](const auto&) { return false; }));
  EXPECT_EQ(result.status, Filling_status::INTERRUPTED);
  EXPECT_EQ(VFC::fill(curve, mesh, np::time_limit(0)).status, Filling_status::LIMIT);
  EXPECT_EQ(curve.number_of_nodes(), 0u);
}

TEST(Fill_limits, the_default_thickness_of_wide_domains_stays)
{
  Curve curve;
  const auto result = VFC::fill(curve, ball, np::number_of_iterations(0));
  EXPECT_EQ(result.default_thickness, 0);
  EXPECT_NEAR(result.thickness, 0.25, 3e-3);
}

TEST(Fill_limits, without_any_time_the_curve_is_valid)
{
  Curve curve;
  const auto result = VFC::fill(curve, ball, np::thickness(0.1).time_limit(0));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
  EXPECT_EQ(result.statistics.iterations, 0u);
  EXPECT_TRUE(std::isnan(result.thickness_fit.thin_fraction)) << "nobody has looked";
  EXPECT_GT(curve.number_of_nodes(), 2u);
  expect_inside(curve, ball);
}

TEST(Fill_limits, without_any_time_nothing_is_said_against_thin_domains)
{
  meshes::Mesh rod; // one in 2,500 points of its box is inside
  const double w = 0.01;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(w, -w, 0), Point(w, w, -w), Point(0, w, -w),
                        Point(1, 1 + w, 1 - w), Point(1, 1, 1), Point(1 + w, 1 - w, 1),
                        Point(1 + w, 1 + w, 1 - w), rod);
  CGAL::Polygon_mesh_processing::triangulate_faces(rod);
  Curve curve;
  const auto result = VFC::fill(curve, rod, np::thickness(0.1).time_limit(1e-9));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
}

TEST(Fill_limits, without_any_time_a_thickness_far_too_small_is_not_tried)
{
  Curve curve;
  const auto result = VFC::fill(curve, ball, np::thickness(1e-30).time_limit(0));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
  EXPECT_TRUE(VFC::is_embedded(curve));
}

TEST(Fill_limits, a_run_that_reaches_its_goal_at_the_limit_has_converged)
{
  Curve curve, limited;
  const auto result = VFC::fill(curve, ball, np::thickness(0.3));
  ASSERT_EQ(result.status, Filling_status::CONVERGED);
  const std::size_t n = result.statistics.iterations;
  const auto at_limit = np::thickness(0.3).number_of_iterations(n);
  EXPECT_EQ(VFC::fill(limited, ball, at_limit).status, Filling_status::CONVERGED);
  limited = Curve();
  const auto below = np::thickness(0.3).number_of_iterations(n - 1);
  EXPECT_EQ(VFC::fill(limited, ball, below).status, Filling_status::LIMIT);
}

// With round bends, the result of the settled curve was lost, and all was measured again.
void expect_unmeasured(bool has_round_bends)
{
  std::atomic<bool> is_measuring{false};
  const auto slow = [&](const Point&) {
    if(is_measuring.exchange(false)) std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return 0.3;
  };
  const auto stop_measuring = [&](const Run_progress& progress) {
    is_measuring = progress.stage == Run_stage::MEASURING;
    return !is_measuring;
  };
  Curve curve;
  const auto result = VFC::fill(
      curve, ball, np::thickness(slow).round_bends(has_round_bends).progress(stop_measuring));
  EXPECT_TRUE(std::isnan(result.crowded_fraction));
  EXPECT_NEAR(result.medial_radius, 0.3, 0.05);
  EXPECT_EQ(result.status, Filling_status::INTERRUPTED);
}

TEST(Fill_limits, a_curve_that_nobody_had_time_to_measure_has_not_converged)
{
  expect_unmeasured(false);
  expect_unmeasured(true);
}

// Stops a run at the given report of the flow, which can be within a step.
void expect_valid_when_stopped(std::size_t last)
{
  std::size_t reports = 0;
  const auto go_on = [&](const Run_progress& progress) {
    return progress.stage != Run_stage::FLOWING || ++reports < last;
  };
  Curve curve;
  VFC::Isotopy_certificate certificate;
  const auto result = VFC::fill(
      curve, ball, np::thickness(0.15).certificate(std::ref(certificate)).progress(go_on));
  EXPECT_EQ(result.status, Filling_status::INTERRUPTED) << last;
  EXPECT_FALSE(curve.has_garbage());
  EXPECT_TRUE(VFC::is_embedded(curve));
  expect_inside(curve, ball);
  EXPECT_TRUE(VFC::verify_certificate(certificate, Curve(result.start), curve).is_valid) << last;
}

TEST(Fill_limits, a_run_that_is_stopped_within_a_step_has_a_certified_curve)
{
  for(const std::size_t last : {1u, 2u, 3u, 5u, 8u, 13u}) expect_valid_when_stopped(last);
}

} // namespace test_fill_limits
