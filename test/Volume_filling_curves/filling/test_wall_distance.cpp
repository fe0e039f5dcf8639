// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/fill_test_support.h"
#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Fillings that keep a distance from the boundary.
namespace test_wall_distance {

using namespace fill_test;
namespace np = CGAL::Volume_filling_curves::parameters;
using Ball = VFC::Ball_domain_3<Kernel>;
using Box = VFC::Box_domain_3<Kernel>;
using Mesh_domain = VFC::Triangle_mesh_domain_3<Kernel>;
using VFC::Filling_status;

const Box box(Point(0, 0, 0), Point(2, 1, 1));

TEST(Wall_distance, is_kept_by_a_filling_that_covers_the_rest)
{
  for(const double c : {0.05, 0.1}) {
    Curve curve;
    const auto result = VFC::fill(curve, box, preview(0.1).wall_distance(c));
    EXPECT_EQ(result.status, Filling_status::CONVERGED);
    EXPECT_GE(result.min_wall_distance, c);
    EXPECT_EQ(result.min_wall_distance, VFC::min_wall_distance(curve, box).distance);
    EXPECT_LE(result.unfilled_fraction, 0.01);
    EXPECT_GT(coverage(curve, box, 0.1).fraction_within_r, c < 0.1 ? 0.7 : 0.6);
  }
}

TEST(Wall_distance, is_kept_in_a_mesh_from_a_tree_and_from_a_circle)
{
  const Mesh_domain domain(meshes::to_mesh(meshes::sphere(1, 2)));
  for(const auto start : {VFC::Filling_start::TREE, VFC::Filling_start::CIRCLE}) {
    Curve curve;
    const auto result = VFC::fill(curve, domain, preview(0.25).wall_distance(0.2).start(start));
    EXPECT_GE(VFC::min_wall_distance(curve, domain).distance, 0.2);
    EXPECT_LE(result.unfilled_fraction, 0.01);
  }
}

TEST(Wall_distance, above_the_thickness_leaves_the_layer_along_the_boundary_out)
{
  Curve curve;
  const auto result = VFC::fill(curve, box, preview(0.1).wall_distance(0.3));
  EXPECT_EQ(result.status, Filling_status::CONVERGED);
  EXPECT_GE(VFC::min_wall_distance(curve, box).distance, 0.3);
  EXPECT_LE(result.unfilled_fraction, 0.01);
  EXPECT_GT(result.uncovered_fraction, 0.2);
}

TEST(Wall_distance, scales_with_the_domain)
{
  Curve curve, large;
  const double scale = 1024;
  VFC::fill(curve, Ball(Point(0, 0, 0), 1), preview(0.3).wall_distance(0.25));
  VFC::fill(large, Ball(Point(0, 0, 0), scale), preview(0.3 * scale).wall_distance(0.25 * scale));
  ASSERT_EQ(curve.number_of_nodes(), large.number_of_nodes());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const Point& p = curve.point(v);
    EXPECT_EQ(Point(scale * p.x(), scale * p.y(), scale * p.z()), large.point(v));
  }
}

TEST(Wall_distance, is_kept_between_the_necks_of_ports)
{
  const std::vector<VFC::Port<Point>> ports = {{Point(0, 0.5, 0.5)}, {Point(2, 0.5, 0.5)}};
  for(const double c : {0.05, 0.25}) {
    Curve curve;
    const auto result = VFC::fill(curve, box, np::thickness(0.12).wall_distance(c).ports(ports));
    EXPECT_EQ(result.status, Filling_status::CONVERGED) << c;
    for(const auto& neck : result.necks) EXPECT_GE(neck.length, c + 0.05);
    for(std::size_t v = 1; v < curve.number_of_nodes(); ++v) {
      if(curve.is_pinned(v) && curve.is_pinned(v - 1)) continue;
      const Curve edge({curve.point(v - 1), curve.point(v)}, {{0, 1}});
      EXPECT_GE(VFC::min_wall_distance(edge, box).distance, c);
    }
  }
}

std::string complaint(Curve curve, double wall_distance)
{
  try {
    (void)VFC::fill(curve, box, preview(0.1).wall_distance(wall_distance));
  } catch(const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Wall_distance, is_refused_if_it_leaves_no_room_or_the_curve_is_nearer)
{
  const std::string no_room = complaint(Curve(), 0.6);
  EXPECT_EQ(no_room.substr(0, 78),
            "wall_distance is 0.6, but no point was found that is farther from the boundary");
  const Curve start = polyline({Point(0.5, 0.5, 0.5), Point(1.5, 0.5, 0.5), Point(1.5, 0.8, 0.5)});
  EXPECT_EQ(complaint(start, 0.3),
            "wall_distance is 0.3, but the curve to start from comes as near "
            "to the boundary as 0.2");
  Curve slide = polyline({Point(0.5, 0.5, 0.5), Point(1, 0.5, 0.5), Point(1.5, 0.5, 0.5)});
  slide.set_constraint(1, VFC::Node_constraint::on_boundary(0.1));
  EXPECT_EQ(complaint(slide, 0.15), "wall_distance is 0.15, but a node is constrained to the "
                                    "distance from the boundary 0.1");
  EXPECT_EQ(complaint(Curve(), -1), "wall_distance is -1, but must be finite and not negative");
}

} // namespace test_wall_distance
