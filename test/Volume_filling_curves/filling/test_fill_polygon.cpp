// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Planar domains: curves stay in the plane, exactly, and fill it evenly.

#include "support/fill_test_support.h"
#include "support/polygon_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

namespace test_fill_polygon {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using polygons::disk;
using polygons::plate;
using polygons::Polygon;
using polygons::polygon;
using polygons::rectangle;
using VFC::Filling_status;
using Domain = VFC::Polygon_domain_3<Traits>;
using Polygons = std::vector<Polygon>;
using Coordinates = std::vector<std::array<double, 3>>;

constexpr double thickness = .08;

Coordinates coordinates(const Curve& curve)
{
  Coordinates result;
  for(const Point& p : curve.points()) result.push_back({p.x(), p.y(), p.z()});
  return result;
}

void expect_in_plane(const Curve& curve)
{
  for(const auto& p : coordinates(curve)) EXPECT_EQ(p[2], 0);
}

// Whether each component is a simple polygon, by a sweep that the guard does not share.
void expect_simple(const Curve& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    std::vector<polygons::Corner> corners;
    std::size_t v = curve.first_node(c), e = curve.incident_edge(v, 0);
    do {
      corners.push_back({curve.point(v).x(), curve.point(v).y()});
      v = curve.source(e) == v ? curve.target(e) : curve.source(e);
      e = curve.incident_edge(v, curve.incident_edge(v, 0) == e ? 1 : 0);
    } while(v != curve.first_node(c));
    EXPECT_TRUE(CGAL::is_simple_2(corners.begin(), corners.end()));
  }
}

template <typename Input>
void expect_filled(const Input& input, double r, std::size_t components = 1)
{
  const Domain domain(input);
  Curve curve;
  const auto result = VFC::fill(curve, input, preview(r));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  EXPECT_EQ(curve.number_of_components(), components);
  EXPECT_EQ(result.parts, components);
  expect_in_plane(curve);
  expect_simple(curve);
  expect_inside(curve, domain);
  const VFC::Coverage found = coverage(curve, domain, r);
  EXPECT_GT(found.fraction_within_r, .91);
  EXPECT_LT(found.p99, 1.25);
  EXPECT_GT(VFC::min_clearance(curve, r), .9 * r);
}

TEST(Fill_polygon, covers_a_plate_with_two_holes_at_two_thicknesses)
{
  expect_filled(plate(), thickness);
  expect_filled(plate(), thickness / 2);
}

TEST(Fill_polygon, covers_a_thin_corner)
{
  expect_filled(polygons::ring({{0, 0}, {3, 0}, {3, .5}, {.5, .5}, {.5, 3}, {0, 3}}), .06);
}

TEST(Fill_polygon, covers_a_star_with_a_thousand_corners)
{
  polygons::Ring star;
  for(int k = 0; k < 1000; ++k) {
    const double t = 2 * CGAL_PI * k / 1000, r = 2 + .35 * std::sin(9 * t) + .1 * std::sin(40 * t);
    star.push_back({r * std::cos(t), r * std::sin(t)});
  }
  expect_filled(star, .1);
}

TEST(Fill_polygon, gives_each_of_several_polygons_a_curve)
{
  const Polygons polygons = {polygon(rectangle(0, 0, 2, 2), {disk(1, 1, .6)}),
                             polygon(disk(1, 1, .4)), polygon(rectangle(2.2, 0, 1, 1))};
  expect_filled(polygons, .05, 3);
}

template <typename Tag, typename NamedParameters>
Coordinates filled(const Polygon& polygon, const NamedParameters& np)
{
  Curve curve;
  VFC::fill<Tag>(curve, polygon, np);
  expect_in_plane(curve);
  return coordinates(curve);
}

TEST(Fill_polygon, gives_the_same_bits_again_and_for_any_number_of_threads)
{
  const auto parameters = preview(thickness);
  const Coordinates expected = filled<CGAL::Sequential_tag>(plate(), parameters);
  EXPECT_EQ(filled<CGAL::Sequential_tag>(plate(), parameters), expected);
  EXPECT_EQ(filled<CGAL::Parallel_if_available_tag>(plate(), parameters), expected);
  EXPECT_NE(filled<CGAL::Sequential_tag>(plate(), parameters.random_seed(1)), expected);
}

TEST(Fill_polygon, scales_with_its_polygon_by_powers_of_two)
{
  const Domain domain(plate());
  Coordinates expected;
  for(const int exponent : {0, -300, -100, 100, 400}) {
    const double unit = std::ldexp(1., exponent);
    Curve curve;
    const auto result = VFC::fill(curve, domain.scaled(unit), preview(thickness * unit));
    Coordinates found = coordinates(curve);
    for(auto& p : found)
      for(double& x : p) x /= unit;
    if(expected.empty()) expected = found;
    EXPECT_EQ(found, expected) << exponent;
    EXPECT_EQ(result.thickness, thickness * unit);
  }
}

TEST(Fill_polygon, leads_from_port_to_port)
{
  std::vector<Point> arc = {{-1.45, -.9, 0}, {-1.3, -.9, 0}, {1.45, -.9, 0}};
  const auto result = VFC::fill(arc, plate(), preview(thickness));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  EXPECT_EQ(arc.front(), Point(-1.45, -.9, 0));
  EXPECT_EQ(arc.back(), Point(1.45, -.9, 0));
  EXPECT_GT(arc.size(), 500u);
  for(const Point& p : arc) EXPECT_EQ(p.z(), 0);
  expect_inside(polyline(arc), Domain(plate()));
  EXPECT_GT(coverage(polyline(arc), Domain(plate()), thickness).fraction_within_r, .88);
}

TEST(Fill_polygon, grows_from_a_circle)
{
  Curve curve;
  const auto result =
      VFC::fill(curve, plate(), preview(thickness).start(VFC::Filling_start::CIRCLE));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  expect_in_plane(curve);
  expect_simple(curve);
  EXPECT_GT(coverage(curve, Domain(plate()), thickness).fraction_within_r, .85);
}

TEST(Fill_polygon, keeps_clear_of_the_boundary)
{
  Curve curve;
  VFC::fill(curve, plate(), preview(thickness).wall(VFC::Wall::KEEP_CLEAR));
  expect_in_plane(curve);
  const Domain domain(plate());
  double least = 1;
  for(const Point& p : curve.points()) least = (std::min)(least, domain.distance(p));
  EXPECT_GT(least, thickness);
}

TEST(Fill_polygon, follows_a_thickness_that_varies)
{
  const auto field = [](const Point& p) { return .06 + .02 * (p.x() + 1.5); };
  const Domain domain(plate());
  Curve curve;
  const auto result = VFC::fill(curve, domain, preview(field));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  expect_in_plane(curve);
  const VFC::Domain_samples_3<Traits, Domain> samples(domain, 20000, 1);
  const auto found = VFC::coverage(samples, VFC::sample_distances(curve, samples), field);
  EXPECT_GT(found.fraction_within_r, .9);
  EXPECT_LT(found.p99, 1.3);
}

TEST(Fill_polygon, follows_the_projection_of_a_direction_field)
{
  const std::function<std::array<double, 3>(const Point&)> field = [](const Point&) {
    return std::array<double, 3>{1, 0, 1};
  };
  const auto along_x = [](const Point&) { return std::array<double, 3>{1, 0, 0}; };
  Curve with, without;
  const auto result = VFC::fill(with, plate(), preview(thickness).direction_field(field));
  VFC::fill(without, plate(), preview(thickness));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  expect_in_plane(with);
  EXPECT_GT(VFC::alignment(with, along_x), .1 + VFC::alignment(without, along_x));
}

TEST(Fill_polygon, reaches_a_length)
{
  Curve curve;
  const auto result = VFC::fill(curve, plate(), np::length(40).round_bends(false));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  EXPECT_NEAR(VFC::length(curve), 40, .8);
  expect_in_plane(curve);
}

TEST(Fill_polygon, is_certified_in_its_domain)
{
  VFC::Isotopy_certificate certificate;
  Curve curve;
  const Domain domain(plate());
  const auto result =
      VFC::fill(curve, domain, preview(2 * thickness).certificate(std::ref(certificate)));
  const Curve start(result.start);
  const auto verdict = VFC::verify_certificate(certificate, start, curve, domain);
  EXPECT_TRUE(verdict.is_valid) << verdict.message;
}

TEST(Fill_polygon, ends_at_its_limits)
{
  Curve curve;
  const auto result = VFC::fill(curve, plate(), preview(.01).time_limit(.2));
  EXPECT_EQ(result.status, Filling_status::LIMIT);
  expect_in_plane(curve);
  expect_inside(curve, Domain(plate()));
}

TEST(Fill_polygon, refuses_curves_off_the_plane)
{
  std::vector<Point> arc = {{-1.4, 0, 0}, {-1.2, 0, 1e-9}};
  EXPECT_THROW(VFC::fill(arc, plate(), preview(thickness)), std::invalid_argument);
}

TEST(Isotopy_guard, refuses_to_leave_a_plane_however_far_the_boundary_is)
{
  Curve curve = polyline({{-1.4, 0, 0}, {-1.35, .01, 0}, {-1.3, 0, 0}});
  const Domain domain(plate());
  VFC::Isotopy_guard_3<Traits, Domain> guard(curve, domain);
  EXPECT_FALSE(guard.move_node(1, Point(-1.35, .01, 1e-300)));
  EXPECT_FALSE(guard.insert_node(0, Point(-1.37, .01, -1e-9)));
  EXPECT_TRUE(guard.move_node(1, Point(-1.35, .02, 0)));
  expect_in_plane(curve);
}

// A planar domain that can only do what the concept asks for.
class Disk
{
public:
  using Point_3 = Point;
  using Vector_3 = Kernel::Vector_3;
  static constexpr int dimension = 2;

  CGAL::Bbox_3 bbox() const { return {-1, -1, 0, 1, 1, 0}; }

  bool is_inside(const Point& p) const { return p.z() == 0 && p.x() * p.x() + p.y() * p.y() < 1; }

  bool is_triangle_inside(const Point&, const Point& q, const Point& r) const
  {
    return is_inside(q) && is_inside(r);
  }

  double distance(const Point& p) const { return std::abs(1 - std::hypot(p.x(), p.y())); }

  double distance_along(const Point& p, const Vector_3& u, double limit) const
  {
    const double along = p.x() * u.x() + p.y() * u.y(), c = p.x() * p.x() + p.y() * p.y() - 1;
    return (std::min)(limit, std::sqrt(along * along - c) - along);
  }
};

TEST(Fill_polygon, takes_other_planar_domains)
{
  Curve curve;
  const auto result = VFC::fill(curve, Disk(), preview(.1));
  EXPECT_EQ(result.status, Filling_status::CONVERGED) << result.reason;
  EXPECT_EQ(result.parts, 1u);
  expect_in_plane(curve);
  expect_simple(curve);
  expect_inside(curve, Disk());
  EXPECT_GT(coverage(curve, Disk(), .1).fraction_within_r, .9);
}

} // namespace test_fill_polygon
