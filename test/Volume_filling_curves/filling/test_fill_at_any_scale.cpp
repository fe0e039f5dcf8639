// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// A domain multiplied by a power of two is filled by the same curve at that scale, even at sizes
// whose sixth powers overflow or underflow.

#include "support/fill_test_support.h"
#include "support/mesh_test_support.h"
#include "support/refusal_of.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace test_fill_at_any_scale {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using VFC::Filling_status;
using Domain = VFC::Triangle_mesh_domain_3<Kernel>;
using Ball = VFC::Ball_domain_3<Kernel>;
using Coordinates = std::vector<std::array<double, 3>>;

// of two; the first three are sizes that a run takes as they are, and meshes end at 1e100
const std::vector<int> exponents = {0, -120, 120, -320, -200, 170, 300};
const std::vector<int> far_exponents = {0, -490, 490};

// An L of three cubes, which is not convex.
meshes::Mesh corner(double unit)
{
  return meshes::to_mesh(meshes::voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, unit));
}

template <typename Points>
Coordinates coordinates(const Points& points, double unit)
{
  Coordinates result;
  for(const Point& p : points) result.push_back({p.x() / unit, p.y() / unit, p.z() / unit});
  return result;
}

template <typename MakeDomain, typename NamedParameters>
void expect_same_at_any_scale(const std::vector<int>& exponents_of_units,
                              const MakeDomain& make_domain,
                              const NamedParameters& np)
{
  Coordinates expected;
  for(const int exponent : exponents_of_units) {
    const double unit = std::ldexp(1., exponent);
    Curve curve;
    const auto result = VFC::fill(curve, make_domain(unit), np);
    const Coordinates found = coordinates(curve.points(), unit);
    EXPECT_GT(found.size(), 100u);
    EXPECT_GT(result.thickness / unit, 0.05);
    if(expected.empty()) expected = found;
    EXPECT_TRUE(found == expected) << "2^" << exponent;
  }
}

const auto few_steps = np::number_of_iterations(5);

TEST(Fill_at_any_scale, meshes)
{
  expect_same_at_any_scale(
      exponents, [](double unit) { return corner(unit); }, few_steps);
}

TEST(Fill_at_any_scale, boxes)
{
  expect_same_at_any_scale(
      far_exponents,
      [](double unit) {
        return VFC::Box_domain_3<Kernel>(Point(0, 0, 0), Point(2 * unit, unit, unit));
      },
      few_steps);
}

TEST(Fill_at_any_scale, balls)
{
  const auto ball = [](double unit) { return Ball(Point(unit, 0, 0), unit); };
  expect_same_at_any_scale(exponents, ball, few_steps);
  expect_same_at_any_scale(far_exponents, ball, few_steps);
}

TEST(Fill_at_any_scale, implicit_domains)
{
  expect_same_at_any_scale(
      far_exponents,
      [](double unit) {
        const auto distance = [unit](const Point& p) {
          return unit * (std::hypot(p.x() / unit, p.y() / unit, p.z() / unit) - 1);
        };
        return VFC::Implicit_domain_3<decltype(distance)>(distance,
                                                          {-unit, -unit, -unit, unit, unit, unit});
      },
      few_steps);
}

// Follows a run by the lengths that it is shown.
struct Lengths : VFC::Default_curve_flow_visitor
{
  template <typename Flow>
  void on_start(const Flow& flow)
  {
    on_iteration(flow);
  }

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    seen.insert(seen.end(),
                {flow.length(), flow.thickness(), flow.thickness(0), flow.parameters().thickness,
                 flow.mean_medial_radius(), flow.direction().norm(),
                 flow.medial_spheres(0)[0].radius, flow.curve().point(0).x()});
  }

  std::vector<double> seen;
};

std::vector<double> divided(std::vector<double> values, double unit)
{
  for(double& x : values) x /= unit;
  return values;
}

// All lengths of a run that come in or go out, in the given unit.
std::vector<double> lengths_of_run(double unit)
{
  Lengths visitor;
  std::vector<double> lengths;
  const auto note = [&](const VFC::Run_progress& progress) {
    lengths.insert(lengths.end(), {progress.thickness, progress.expected_length});
    return true;
  };
  const auto thickness = [unit](const Point& p) { return 0.2 * unit + 0.02 * p.x(); };
  const auto direction = [unit](const Point& p) {
    return std::array<double, 3>{p.y() / unit, -p.x() / unit, 0};
  };
  Curve curve;
  const auto result = VFC::fill(curve, Domain(corner(unit)),
                                np::thickness(thickness)
                                    .direction_field(direction)
                                    .number_of_iterations(3)
                                    .visitor(std::ref(visitor))
                                    .progress(note));
  lengths.erase(lengths.begin(), lengths.end() - 4); // there are more reports the longer it takes
  lengths.insert(lengths.end(), visitor.seen.begin(), visitor.seen.end());
  lengths.insert(lengths.end(),
                 {result.thickness, result.medial_radius, result.thickness_fit.fitting_thickness,
                  result.start.at(0).at(0).x(), result.start[0][0].y(), result.min_bend_radius,
                  result.min_strand_distance, result.closest_points[0].x(),
                  result.min_wall_distance, result.point_nearest_to_wall.x()});
  for(const auto& region : result.empty_regions)
    lengths.insert(lengths.end(), {region.point.x(), region.radius});
  return divided(lengths, unit);
}

TEST(Fill_at_any_scale, all_lengths_are_in_the_callers_unit)
{
  const std::vector<double> expected = lengths_of_run(1);
  EXPECT_GT(expected.size(), 40u);
  for(const int exponent : {-320, 170, 300})
    EXPECT_TRUE(lengths_of_run(std::ldexp(1., exponent)) == expected) << exponent;
}

TEST(Fill_at_any_scale, the_certificate_is_that_of_the_callers_curves)
{
  for(const int exponent : {-200, 300}) {
    const auto mesh = corner(std::ldexp(1., exponent));
    Curve curve;
    VFC::Isotopy_certificate certificate;
    const auto result =
        VFC::fill(curve, mesh, np::number_of_iterations(2).certificate(std::ref(certificate)));
    ASSERT_EQ(result.start.size(), 1u);
    const auto verdict = VFC::verify_certificate(certificate, Curve(result.start), curve, mesh);
    EXPECT_TRUE(verdict.is_valid);
  }
}

TEST(Fill_at_any_scale, a_given_curve_and_a_resumed_run)
{
  const double unit = std::ldexp(1., 300);
  const Domain domain(corner(unit));
  const std::vector<Point> triangle = {
      Point(unit / 4, unit / 4, unit / 2), Point(unit, unit / 2, unit / 2),
      Point(unit / 2, unit, unit / 2), Point(unit / 4, unit / 4, unit / 2)};
  VFC::Run_state state;
  const auto keep = [&](const VFC::Run_checkpoint& moment) { state = moment.state(); };
  const std::vector<std::vector<Point>> start = {triangle};
  Curve early(start), resumed(start), whole(start);
  const auto parameters = np::thickness(unit / 5);
  VFC::fill(early, domain, parameters.number_of_iterations(3).checkpoint(keep));
  VFC::fill(resumed, domain, parameters.number_of_iterations(6).resume_from(std::cref(state)));
  VFC::fill(whole, domain, parameters.number_of_iterations(6));
  EXPECT_TRUE(coordinates(resumed.points(), unit) == coordinates(whole.points(), unit));
  EXPECT_FALSE(coordinates(early.points(), unit) == coordinates(whole.points(), unit));
}

std::string refusal(const std::function<void(Curve&)>& fill)
{
  Curve curve;
  return refusal_of([&] { fill(curve); });
}

TEST(Fill_at_any_scale, beyond_the_limits_of_coordinates_it_is_refused)
{
  for(const int exponent : {-600, 600})
    EXPECT_NE(refusal([&](Curve& curve) {
                VFC::fill(curve, Ball(Point(0, 0, 0), std::ldexp(1., exponent)));
              }).find("must be between 1e-150 and 1e150"),
              std::string::npos);
}

// In the unit of the run they would be 0, which stands for none, or infinite.
TEST(Fill_at_any_scale, lengths_that_no_double_holds_in_the_unit_of_the_domain_are_refused)
{
  const auto refusal_in = [](double radius, const auto& np) {
    return refusal([&](Curve& curve) { VFC::fill(curve, Ball(Point(0, 0, 0), radius), np); });
  };
  const std::string value = " is 1e-200, but must be between 1e-307 and 1e307 times";
  for(const auto& [name, text] : std::vector<std::array<std::string, 2>>{
          {"thickness", refusal_in(1e140, np::thickness(1e-200))},
          {"thickness", refusal_in(1e140, np::thickness([](const Point&) { return 1e-200; }))},
          {"length", refusal_in(1e140, np::length(1e-200))},
          {"bend_radius", refusal_in(1e140, np::bend_radius(1e-200))},
          {"strand_distance", refusal_in(1e140, np::strand_distance(1e-200))},
          {"wall_distance", refusal_in(1e140, np::wall_distance(1e-200))}})
    EXPECT_EQ(text.find(name + value), 0u) << name << ": " << text;
  EXPECT_EQ(refusal_in(1e-140, np::length(1e200)).find("length is 1e+200, but must be "), 0u);
}

// without the member function scaled()
struct Plain_ball : private Ball
{
  using Ball::Ball, Ball::Point_3, Ball::Vector_3, Ball::bbox, Ball::is_inside,
      Ball::is_triangle_inside, Ball::distance, Ball::distance_along;
};

TEST(Fill_at_any_scale, domains_of_other_types_are_refused_with_advice)
{
  const auto fill = [](double radius) {
    return
        [radius](Curve& curve) { VFC::fill(curve, Plain_ball(Point(0, 0, 0), radius), few_steps); };
  };
  EXPECT_EQ(refusal(fill(1e38)), "");
  EXPECT_NE(refusal(fill(1e45)).find("no member function scaled()"), std::string::npos);
}

TEST(Fill_at_any_scale, a_refusal_for_the_number_of_nodes_has_the_callers_lengths)
{
  const double unit = std::ldexp(1., 300);
  const std::string text = refusal([&](Curve& curve) {
    VFC::fill(curve, Ball(Point(0, 0, 0), unit), np::thickness(1e-4 * unit));
  });
  EXPECT_EQ(text.find("thickness is 2.03704e+86, but"), 0u) << text;
}

} // namespace test_fill_at_any_scale
