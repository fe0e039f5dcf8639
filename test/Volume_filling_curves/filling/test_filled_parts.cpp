// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Every connected part of the inside is filled, or the result reports which is not.

#include "support/fill_test_support.h"
#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Implicit_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

#include <CGAL/Bbox_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace test_filled_parts {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Mesh_domain = VFC::Triangle_mesh_domain_3<Kernel>;
using meshes::Soup;
using VFC::Filling_status;

Soup moved(Soup soup, double x, double y, double z)
{
  for(Point& p : soup.points) p = {p.x() + x, p.y() + y, p.z() + z};
  return soup;
}

using Polylines = std::vector<std::vector<Point>>;

const Soup two_spheres = meshes::sphere(1, 2) + meshes::sphere(0.6, 2, Point(2, 0, 0));

template <typename Domain>
void expect_filled(const Domain& domain, double thickness, std::size_t parts)
{
  Curve curve;
  const auto result = VFC::fill(curve, domain, preview(thickness));
  const bool is_crowded = result.crowded_fraction > 0.05; // in the shell around a cavity
  EXPECT_EQ(result.status, is_crowded ? Filling_status::PARTIAL : Filling_status::CONVERGED);
  EXPECT_EQ(result.reason.empty(), !is_crowded) << result.reason;
  EXPECT_LE(result.unfilled_fraction, 0.01);
  EXPECT_EQ(result.parts, parts);
  EXPECT_EQ(result.unreachable_parts, 0u);
  EXPECT_EQ(result.start.size(), parts);
  EXPECT_EQ(curve.number_of_components(), parts);
  expect_inside(curve, domain);
  EXPECT_LT(coverage(curve, domain, thickness).p99, 1.6);
}

TEST(Parts, of_a_mesh_are_filled_by_a_curve_each)
{
  expect_filled(Mesh_domain(meshes::to_mesh(two_spheres)), 0.2, 2);
}

TEST(Parts, touch_in_a_vertex_of_an_hourglass)
{
  const Soup hourglass = meshes::cube() + moved(meshes::cube(), 1, 1, 1);
  expect_filled(Mesh_domain(meshes::to_mesh(hourglass)), 0.2, 2);
}

TEST(Parts, are_not_divided_by_a_cavity)
{
  const Soup shell = meshes::sphere(1, 2) + meshes::sphere(0.3, 2).inverted();
  expect_filled(Mesh_domain(meshes::to_mesh(shell)), 0.25, 1);
}

TEST(Parts, lie_in_the_cavities_of_others)
{
  const Soup shells =
      meshes::sphere(1.2, 2) + meshes::sphere(0.6, 2).inverted() + meshes::sphere(0.5, 2);
  expect_filled(Mesh_domain(meshes::to_mesh(shells)), 0.2, 2);
}

TEST(Parts, without_samples_are_found_in_their_boxes)
{
  const Soup soup = meshes::cube(40) + moved(meshes::cube(0.5), 50, 0, 0);
  const Mesh_domain domain(meshes::to_mesh(soup));
  Curve curve;
  const auto result =
      VFC::fill(curve, domain,
                preview(0.4).number_of_iterations(1).spacing(1).start(VFC::Filling_start::CIRCLE));
  EXPECT_EQ(result.parts, 2u);
  EXPECT_EQ(curve.number_of_components(), 2u);
}

// the signed distance to two balls
struct Two_balls
{
  double operator()(const Point& p) const
  {
    return (std::min)(std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0))) - 1,
                      std::sqrt(CGAL::squared_distance(p, Point(2.5, 0, 0))) - 0.7);
  }
};

TEST(Parts, of_any_domain_are_found_by_samples)
{
  const VFC::Implicit_domain_3 domain(Two_balls(), CGAL::Bbox_3(-1, -1, -1, 3.2, 1, 1));
  expect_filled(domain, 0.25, 2);
}

template <typename Function>
std::size_t number_of_parts(const Function& f, const CGAL::Bbox_3& box, double lipschitz, double r)
{
  Curve curve;
  const VFC::Implicit_domain_3<Function> domain(f, box, lipschitz);
  return VFC::fill(curve, domain, preview(r).number_of_iterations(0)).parts;
}

// Few edges of a thin domain, or of one with too large a bound of the slope, are proved inside.
TEST(Parts, of_implicit_domains_are_not_torn_apart)
{
  const auto ball = [](const Point& p) { return std::hypot(p.x(), p.y(), p.z()) - 1; };
  EXPECT_EQ(number_of_parts(ball, {-1, -1, -1, 1, 1, 1}, 30, 0.3), 1u);
  const double thin = 0.02;
  const auto plate = [thin](const Point& p) {
    return (std::max)({std::abs(p.x()) - 1, std::abs(p.y()) - 1, std::abs(p.z()) - thin});
  };
  EXPECT_EQ(number_of_parts(plate, {-1, -1, -thin, 1, 1, thin}, 1, 2 * thin), 1u);
}

TEST(Parts, have_no_curve_if_one_is_given)
{
  const Mesh_domain domain(meshes::to_mesh(two_spheres));
  const Curve start(std::vector<Point>{{0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}, {0, 0, 0}});
  Curve curve = start;
  const auto result = VFC::fill(curve, domain, preview(0.25));
  EXPECT_EQ(result.status, Filling_status::PARTIAL);
  EXPECT_EQ(result.parts, 2u);
  EXPECT_EQ(result.unreachable_parts, 1u);
  EXPECT_GT(result.unfilled_fraction, 0.1);
  EXPECT_EQ(result.reason, "no curve was started in 1 of 2 parts of the inside");
  EXPECT_TRUE(result.start.empty());
}

TEST(Parts, are_in_the_certificate)
{
  const Mesh_domain domain(meshes::to_mesh(two_spheres));
  Curve curve;
  VFC::Isotopy_certificate certificate;
  const auto result = VFC::fill(
      curve, domain, preview(0.3).number_of_iterations(10).certificate(std::ref(certificate)));
  const Curve start(result.start);
  EXPECT_EQ(start.number_of_components(), 2u);
  EXPECT_TRUE(
      VFC::verify_certificate(certificate, start, curve, meshes::to_mesh(two_spheres)).is_valid);
}

// A search for overlapping boxes that counts the pairs of hulls that it compares.
struct Counted_overlaps : VFC::internal::Overlap_query
{
  using Part = VFC::internal::Box_tree::Part;
  mutable std::size_t number = 0;

  double entry(const Part& a, const Part& b) const
  {
    ++number;
    return Overlap_query::entry(a, b);
  }

  void visit(const Part&, const Part&) const {}
};

std::size_t compared_hulls(const Polylines& closed_polylines)
{
  std::vector<CGAL::Bbox_3> edges;
  for(const auto& polyline : closed_polylines)
    for(std::size_t k = 0; k + 1 < polyline.size(); ++k)
      edges.push_back(polyline[k].bbox() + polyline[k + 1].bbox());
  const VFC::internal::Box_tree tree(edges);
  Counted_overlaps overlaps;
  VFC::internal::Nearest_pair_descent(tree, overlaps).run();
  return overlaps.number;
}

// In a random order, 400 circles take twenty times as many comparisons.
TEST(Parts, come_in_an_order_in_space_if_they_are_many)
{
  std::vector<std::array<int, 3>> cubes;
  for(int x = 0; x < 20; ++x)
    for(int y = 0; y < 20; ++y) cubes.push_back({2 * x, 2 * y, 0});
  const Mesh_domain domain(meshes::to_mesh(meshes::voxels(cubes)));
  Curve curve;
  Polylines circles = VFC::fill(curve, domain, preview(0.5).number_of_iterations(0)).start;
  EXPECT_EQ(circles.size(), 400u);
  const std::size_t in_space = compared_hulls(circles);
  std::shuffle(circles.begin(), circles.end(), std::mt19937(1));
  EXPECT_LT(10 * in_space, compared_hulls(circles));
}

// A visitor that takes note of a warning.
struct Warned : VFC::Default_curve_flow_visitor
{
  void on_thin_domain(const VFC::Thickness_fit& given) { fit = given; }
  VFC::Thickness_fit fit;
};

VFC::Filling_result<Point> filled_plate(double thickness, Warned& visitor)
{
  Soup soup = meshes::cube(3);
  for(Point& p : soup.points) p = {p.x(), p.y(), p.z() / 15};
  const Mesh_domain plate(meshes::to_mesh(soup));
  Curve curve;
  return VFC::fill(curve, plate, preview(thickness).visitor(std::ref(visitor)));
}

TEST(Thin_domain, is_told_before_and_after)
{
  Warned visitor;
  const auto result = filled_plate(0.4, visitor);
  EXPECT_EQ(visitor.fit.thickness, 0.4);
  EXPECT_GT(visitor.fit.thin_fraction, 0.99);
  EXPECT_NEAR(visitor.fit.fitting_thickness, 0.1, 0.03); // half of the plate's own
  EXPECT_EQ(result.status, Filling_status::PARTIAL);
  EXPECT_GT(result.unfilled_fraction, 0.05);
  EXPECT_EQ(result.reason.substr(0, 46), "walls are too thin for r = 0.4 in 100 % of the");
}

TEST(Thin_domain, is_filled_by_the_thickness_that_fits)
{
  Warned none;
  const auto result = filled_plate(0.0707, none);
  EXPECT_EQ(none.fit.thickness, 0); // not called
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
}

} // namespace test_filled_parts
