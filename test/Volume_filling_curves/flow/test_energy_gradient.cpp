// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/flow_test_support.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

// The gradient against finite differences of the energy that it is the gradient of.
namespace test_energy_gradient {

namespace VFC = CGAL::Volume_filling_curves;
using namespace flow_test;
using internal::Medial_spheres;

constexpr double medial_weight = 3.36 * 3.36; // alpha in units of 1 / r^2

struct Energy
{
  Energy(const Network& c, double r)
      : curve(c),
        thickness(r),
        x(internal::coordinates(c)),
        weights(internal::node_weights(c, x)),
        spheres(spheres_of(c, 16, 0.9, r)),
        tensions(c.number_of_components(), 1.)
  {}

  Vector_field gradient() const
  {
    internal::Energy_gradient<Network> gradient(curve, x, weights);
    gradient.add_length(tensions);
    gradient.add_medial_spheres(spheres, std::vector<double>(curve.number_of_nodes(), thickness),
                                medial_weight);
    return gradient.projected(
        {curve, internal::Boundary<VFC::Unbounded_domain_3<Network::Traits>>()});
  }

  // The centers, with spheres below r / 2 taken for smaller ones: R - (r / 2 - R).
  Vector center(std::size_t c, std::size_t l) const
  {
    const double radius = spheres.radius(c, l);
    return internal::row(x, spheres.circles()[c].node) +
           (std::min)(radius, 2 * radius - thickness / 2) * spheres.direction(c, l);
  }

  // of other positions, with the centers and the weights of x
  double operator()(const Vector_field& y) const
  {
    double sum = 0;
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      const std::size_t a = curve.source(e), b = curve.target(e);
      sum += tensions[curve.component(a)] * (internal::row(y, b) - internal::row(y, a)).norm();
    }
    const double alpha = medial_weight / (thickness * thickness);
    for(std::size_t c = 0; c < spheres.circles().size(); ++c)
      for(std::size_t l = 0; l < 16; ++l) {
        const auto& circle = spheres.circles()[c];
        const double distance2 = (internal::row(y, circle.node) - center(c, l)).squaredNorm();
        sum += alpha / 2 * weights[circle.node] * circle.share / 16 * distance2;
      }
    return sum;
  }

  double difference(Eigen::Index v, Eigen::Index k) const
  {
    constexpr double step = 1e-4;
    Vector_field low = x, high = x;
    low(v, k) -= step;
    high(v, k) += step;
    return ((*this)(high) - (*this)(low)) / (2 * step);
  }

  const Network& curve;
  double thickness;
  Vector_field x;
  std::vector<double> weights;
  Medial_spheres spheres;
  std::vector<double> tensions;
};

void expect_gradient(const Energy& energy)
{
  const Vector_field gradient = energy.gradient();
  for(Eigen::Index v = 0; v < gradient.rows(); ++v)
    for(Eigen::Index k = 0; k < 3; ++k) {
      if(energy.curve.is_pinned(static_cast<std::size_t>(v)))
        ASSERT_EQ(gradient(v, k), 0);
      else
        ASSERT_NEAR(gradient(v, k), energy.difference(v, k), 1e-5 * (1 + gradient.row(v).norm()));
    }
}

TEST(Energy_gradient, is_that_of_the_energy_with_fixed_spheres)
{
  Random random(1);
  for(double thickness : {0.05, 0.3, 2.}) {
    Network curve =
        internal::closed_network({random_polygon(25, random), random_polygon(9, random)});
    curve.set_pinned(3);
    expect_gradient(Energy(curve, thickness));
  }
}

TEST(Energy_gradient, at_ends_junctions_and_spikes)
{
  Random random(2);
  Network curve = junctions_and_ends(15, random);
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) // spikes are too sharp to differentiate
    if(curve.origin(v) == 22 || curve.origin(v) == 24) curve.set_pinned(v);
  Energy energy(curve, 0.5);
  for(double& tension : energy.tensions) tension = between(0, 1, random);
  for(const Eigen::Index v : {0, 1, 2, 5, 16, 17, 18})
    for(Eigen::Index k = 0; k < 3; ++k) {
      if(curve.is_pinned(static_cast<std::size_t>(v))) continue;
      EXPECT_NEAR(energy.gradient()(v, k), energy.difference(v, k), 1e-5);
    }
}

TEST(Energy_gradient, pushes_harder_where_spheres_are_small)
{
  Network two =
      network_of({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0.2}, {0, 0, 0.2}, {0, 1, 0.2}},
                 {{0, 1}, {1, 2}, {3, 4}, {4, 5}});
  two.pin_ends();
  for(double thickness : {0.1, 0.2, 0.3, 0.5, 2.}) expect_gradient(Energy(two, thickness));
}

TEST(Energy_gradient, of_components_too_short_to_resist_fades)
{
  Network curve = internal::closed_network(
      {circle(12, 0.05, {0, 0, 0}), circle(12, 0.5, {5, 0, 0}), circle(12, 5, {30, 0, 0})});
  const auto x = internal::coordinates(curve);
  const auto weights = internal::node_weights(curve, x);
  double length = 0;
  for(std::size_t v = 12; v < 24; ++v) length += weights[v];
  const auto at = [&](double r) {
    return internal::component_tensions(curve, x, weights, std::vector<double>(weights.size(), r));
  };
  EXPECT_EQ(at(1), (std::vector<double>{0, (length - 1) / 4, 1}));
  EXPECT_NEAR(at(length / 3)[1], 0.5, 1e-12);
  EXPECT_NEAR(at(length / 5)[1], 1, 1e-12);
  EXPECT_NEAR(at(length)[1], 0, 1e-12);
  curve.set_pinned(0);
  EXPECT_EQ(at(1)[0], 0);
  curve.set_pinned(1); // held at two nodes
  EXPECT_EQ(at(1)[0], 1);
}

TEST(Energy_gradient, keeps_the_length_of_components_held_by_sets_in_which_nodes_slide)
{
  using VFC::Node_constraint;
  using Point = Network::Point_3;
  using Vector_3 = Network::Traits::Vector_3;
  const auto plane = [](double z) {
    return Node_constraint::on_plane(Point(3, 4, z), Vector_3(0, 0, 1));
  };
  const auto line = [](double z, const Vector_3& u) {
    return Node_constraint::on_line(Point(0, 0, z), u);
  };
  const auto pin = Node_constraint::fixed(), wall = Node_constraint::on_boundary(1);
  const auto tilted = Node_constraint::on_plane(Point(0, 0, 0.1), Vector_3(0, 1, 1));
  const auto tension = [](const Node_constraint& first, const Node_constraint& last) {
    Network arc = path({{0, 0, 0}, {0, 0, 0.05}, {0, 0, 0.1}});
    arc.set_constraint(0, first);
    arc.set_constraint(2, last);
    const auto x = internal::coordinates(arc);
    return internal::component_tensions(arc, x, internal::node_weights(arc, x), {1, 1, 1})[0];
  };
  const Vector_3 along(1, 2, 0), across(1, 0, 0), up(0, 0, 1);
  for(const auto& [first, last, expected] : {
          std::tuple(plane(0), plane(0.1), 1),
          std::tuple(plane(0), plane(0), 0),
          std::tuple(plane(0), tilted, 0),
          std::tuple(plane(0), line(0.1, along), 1),
          std::tuple(line(0.1, up), plane(0), 0),
          std::tuple(line(0, along), line(0.1, across), 1),
          std::tuple(line(0, along), line(0, across), 0),
          std::tuple(line(0, along), line(0.1, along), 1),
          std::tuple(pin, plane(0.1), 1),
          std::tuple(pin, plane(0), 0),
          std::tuple(pin, wall, 0),
          std::tuple(pin, pin, 1),
      })
    EXPECT_EQ(tension(first, last), expected);
}

// Spheres of a wide circle are capped all around and balance; length pulls with the curvature.
TEST(Energy_gradient, of_a_wide_circle_is_its_curvature)
{
  Network ring = internal::closed_network({circle(900, 50)});
  CGAL::Volume_filling_curves::Curve_flow_parameters parameters;
  parameters.thickness = 1;
  CGAL::Volume_filling_curves::Isotopy_guard_3 guard(ring);
  const CGAL::Volume_filling_curves::Curve_flow_3 flow(guard, parameters);
  EXPECT_NEAR(flow.gradient_norm(), 1. / 50, 1e-6);
  EXPECT_NEAR(flow.length(), 2 * 900 * 50 * std::sin(CGAL_PI / 900), 1e-9);
}

// By symmetry nothing pulls at the middle one of seven parallel strands.
TEST(Energy_gradient, vanishes_in_a_symmetric_bundle)
{
  std::vector<Vector> points;
  Edges edges;
  for(int s = 0; s < 7; ++s)
    for(int k = 0; k < 81; ++k) {
      const double angle = CGAL_PI / 3 * s;
      const Vector axis = s == 0 ? Vector() : Vector(0, std::cos(angle), std::sin(angle));
      points.push_back(1.5 * axis + Vector(0.1 * k, 0, 0));
      if(k > 0) edges.push_back({points.size() - 2, points.size() - 1});
    }
  const Network bundle = network_of(points, edges);
  const Energy energy(bundle, 1);
  EXPECT_NEAR(energy.gradient().row(40).norm(), 0, 1e-12);
  EXPECT_GT(energy.gradient().row(81 + 40).norm(), 0.01);
}

} // namespace test_energy_gradient
