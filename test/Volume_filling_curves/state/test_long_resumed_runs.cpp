// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/resume_test_support.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

// Runs that are interrupted, at several places, end with the same bits as those that are not.
namespace test_long_resumed_runs {

using namespace untangle_test;
using namespace resume_test;
using CGAL::Volume_filling_curves::Ball_domain_3;
using CGAL::Volume_filling_curves::Box_domain_3;
using CGAL::Volume_filling_curves::fill;
using CGAL::Volume_filling_curves::Filling_parameters;
using CGAL::Volume_filling_curves::Filling_start;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::make_torus_knot;
using CGAL::Volume_filling_curves::Triangle_mesh_domain_3;
using CGAL::Volume_filling_curves::Untangling_parameters;
using CGAL::Volume_filling_curves::Untangling_strategy;
using Point = Traits::Point_3;

Interruption after(std::size_t steps)
{
  Interruption interruption;
  interruption.steps = steps;
  return interruption;
}

Interruption in_search(std::size_t looks)
{
  Interruption interruption;
  interruption.looks = looks;
  return interruption;
}

// Interrupts the run once at each of some iterations, and then at all of them.
template <typename Run, typename Parameters>
void expect_resumed(const Run& run,
                    const Network& curve,
                    const Parameters& parameters,
                    const std::vector<std::size_t>& iterations)
{
  const auto whole = run_from(run, curve, parameters, {}, {});
  std::vector<Interruption> all;
  for(const std::size_t k : iterations) {
    SCOPED_TRACE(k);
    ASSERT_LT(k, whole.result.statistics.iterations);
    expect_same(run_in_pieces(run, curve, parameters, {after(k)}), whole);
    all.push_back(after(k));
  }
  expect_same(run_in_pieces(run, curve, parameters, all), whole);
}

const auto run_untangle = [](Network& curve,
                             const Untangling_parameters& parameters,
                             auto visitor) { return untangle(curve, parameters, visitor); };

Untangling_parameters by(Untangling_strategy strategy)
{
  Untangling_parameters parameters;
  parameters.strategy = strategy;
  return parameters;
}

TEST(Resumed_untangling, of_an_unknot)
{
  expect_resumed(run_untangle, make_hard_unknot(200, 300), by(Untangling_strategy::FLOW),
                 {0, 1, 7, 20, 28});
}

TEST(Resumed_untangling, of_a_link_to_its_length)
{
  Untangling_parameters parameters = by(Untangling_strategy::FLOW);
  parameters.keep_length = true;
  expect_resumed(run_untangle, tangled(braid("1 1 1 1", 120), 3), parameters, {2, 11, 29});
}

TEST(Resumed_untangling, of_an_arc_with_closing_rays)
{
  Network arc({{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {1, 1, 2}, {0, 1, 0.5}, {3, 0, 0}},
              {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  arc.pin_ends();
  Untangling_parameters parameters;
  parameters.thickness = 0.3;
  expect_resumed(run_untangle, arc, parameters, {1, 5, 9});
}

TEST(Resumed_untangling, of_a_network)
{
  Network theta({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0.3}, {0, 0.1, 0.7}, {0, -1, 0.2}},
                {{0, 2}, {2, 1}, {0, 3}, {3, 1}, {1, 4}, {4, 0}});
  theta.set_pinned(0);
  theta.set_pinned(1);
  Untangling_parameters parameters = by(Untangling_strategy::FLOW);
  parameters.thickness = 0.2;
  expect_resumed(run_untangle, theta, parameters, {1, 4, 8});
}

TEST(Resumed_untangling, after_a_search)
{
  expect_resumed(run_untangle, tangled(make_torus_knot(2, 5, 80), 5), by(Untangling_strategy::AUTO),
                 {0, 3, 10});
}

// The search takes long enough to be looked at.
TEST(Resumed_untangling, in_the_middle_of_a_search)
{
  const Network curve = tangled(make_torus_knot(3, 5, 120), 5);
  for(const Untangling_strategy strategy :
      {Untangling_strategy::AUTO, Untangling_strategy::SEARCH}) {
    const auto whole = run_from(run_untangle, curve, by(strategy), {}, {});
    expect_same(run_in_pieces(run_untangle, curve, by(strategy), {in_search(0), in_search(1)}),
                whole);
  }
  const auto whole = run_from(run_untangle, curve, by(Untangling_strategy::AUTO), {}, {});
  expect_same(
      run_in_pieces(run_untangle, curve, by(Untangling_strategy::AUTO), {in_search(0), after(4)}),
      whole);
}

TEST(Resumed_untangling, while_the_ropelength_is_lowered)
{
  Untangling_parameters parameters = by(Untangling_strategy::FLOW);
  parameters.lower_ropelength = true;
  expect_resumed(run_untangle, make_torus_knot(2, 3, 60), parameters, {3, 20, 30});
}

TEST(Resumed_untangling, in_a_domain)
{
  const Box_domain_3<> box({-4, -4, -4}, {4, 4, 4});
  const auto run = [&](Network& curve, const Untangling_parameters& parameters, auto visitor) {
    return untangle(curve, box, parameters, visitor);
  };
  expect_resumed(run, make_torus_knot(2, 3, 100), by(Untangling_strategy::FLOW), {1, 5});
}

template <typename Domain>
auto run_fill(const Domain& domain)
{
  return [&domain](Network& curve, const Filling_parameters<Point>& parameters, auto visitor) {
    return fill(curve, domain, parameters, visitor);
  };
}

Filling_parameters<Point> with_thickness(double thickness)
{
  Filling_parameters<Point> parameters;
  parameters.thickness = thickness;
  return parameters;
}

TEST(Resumed_filling, of_a_ball)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 1);
  expect_resumed(run_fill(ball), Network(), with_thickness(0.25), {0, 1, 8, 18});
}

TEST(Resumed_filling, of_a_box_from_a_circle)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(1, 1, 2));
  Filling_parameters<Point> parameters = with_thickness(0.2);
  parameters.start = Filling_start::CIRCLE;
  expect_resumed(run_fill(box), Network(), parameters, {0, 5, 20, 50});
}

TEST(Resumed_filling, to_a_length)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(1, 1, 2));
  Filling_parameters<Point> parameters;
  parameters.length = 20;
  parameters.number_of_iterations = 150;
  expect_resumed(run_fill(box), Network(), parameters, {3, 40, 60, 120});
}

TEST(Resumed_filling, with_a_thickness_that_varies)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 1);
  Filling_parameters<Point> parameters;
  parameters.thickness_field = [](const Point& p) { return 0.2 + 0.05 * p.x(); };
  expect_resumed(run_fill(ball), Network(), parameters, {2, 9, 19});
}

// Fingers are led through the neck when the curve has grown in its chamber.
TEST(Resumed_filling, of_two_chambers)
{
  const Triangle_mesh_domain_3<> domain(meshes::to_mesh(exact_surface::two_chambers()));
  Filling_parameters<Point> parameters = with_thickness(0.2);
  parameters.start = Filling_start::CIRCLE;
  expect_resumed(run_fill(domain), Network(), parameters, {10, 40, 60});
}

} // namespace test_long_resumed_runs
