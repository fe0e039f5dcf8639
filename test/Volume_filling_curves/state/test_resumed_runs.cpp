// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/polygon_test_support.h"
#include "support/resumed_run_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Runs that are interrupted and resume end with the same bits as those that are not.
namespace test_resumed_runs {

using namespace resumed_run_test;

// The number of iterations of a run that is left alone.
template <typename Run, typename P>
std::size_t iterations_of(const Run& run, Network curve, const P& parameters)
{
  return run(curve, parameters, Default_curve_flow_visitor()).statistics.iterations;
}

// Interrupts a run several times, and compares it with one that is left alone.
template <typename Run, typename P>
void expect_resumed(const Run& run,
                    const Network& curve,
                    const P& parameters,
                    const std::vector<Interruption>& interruptions)
{
  Run_state state;
  for(const Interruption& interruption : interruptions) {
    state = run_from(run, curve, parameters, state, interruption).state;
    ASSERT_FALSE(state.is_empty());
  }
  EXPECT_TRUE(run_from(run, curve, parameters, state, {}).numbers ==
              run_from(run, curve, parameters, {}, {}).numbers);
}

TEST(Resumed_runs, links_are_untangled_to_their_length)
{
  Parameters parameters = by(Untangling_strategy::FLOW);
  parameters.keep_length = true;
  expect_resumed(untangling, tangled(braid("1 1 1 1", 120), 3), parameters,
                 {0, {never, 2}, 11, 29});
}

Network arc()
{
  Network arc({{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {1, 1, 2}, {0, 1, 0.5}, {3, 0, 0}},
              {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  arc.pin_ends();
  return arc;
}

TEST(Resumed_runs, arcs_keep_their_rays)
{
  for(const double thickness : {0., 0.3})
    expect_resumed(untangling, arc(), by(Untangling_strategy::AUTO, thickness), {1, 5});
}

TEST(Resumed_runs, networks_keep_their_input)
{
  Network theta({{-1, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0.3}, {0, 0.1, 0.7}, {0, -1, 0.2}},
                {{0, 3}, {3, 2}, {0, 4}, {4, 2}, {2, 5}, {5, 0}});
  theta.set_pinned(0);
  expect_resumed(untangling, theta, by(Untangling_strategy::FLOW, 0.2), {1, 4});
}

TEST(Resumed_runs, searches_begin_anew)
{
  const Network curve = tangled(make_torus_knot(3, 5, 120), 5);
  expect_resumed(untangling, curve, by(Untangling_strategy::AUTO),
                 {{never, 0}, {never, 1}, 0, 4, {never, 6}});
  expect_resumed(untangling, curve, by(Untangling_strategy::SEARCH), {{never, 1}});
}

TEST(Resumed_runs, the_ropelength_is_lowered_anew)
{
  Parameters parameters = by(Untangling_strategy::FLOW);
  parameters.lower_ropelength = true;
  expect_resumed(untangling, make_torus_knot(2, 3, 60), parameters, {3, 30});
}

// Interrupted while it flows and while it takes its shape.
TEST(Resumed_runs, curves_take_their_shape)
{
  Parameters parameters = by(Untangling_strategy::AUTO, 0.15);
  parameters.lower_ropelength = true;
  parameters.bend_radius = 0.1;
  const Network curve = tangled(braid("1 1 1", 60), 1);
  const std::size_t n = iterations_of(untangling, curve, parameters);
  expect_resumed(untangling, curve, parameters, {5, n - 1});
}

TEST(Resumed_runs, nodes_slide_in_a_domain)
{
  const Box_domain_3<> box({-4, -4, -4}, {4, 4, 4});
  const auto run = [&](Network& curve, const Parameters& parameters, auto visitor) {
    return untangle(curve, box, parameters, visitor);
  };
  Network arc({{-3.9, 1, 0}, {-2, 0, 1}, {0, 1, -1}, {2, -1, 0}, {3, 1, 1}},
              {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  arc.set_constraint(0, Node_constraint::on_boundary(0.1));
  arc.set_constraint(4,
                     Node_constraint::on_plane(arc.point(4), Network::Traits::Vector_3(1, 0, 0)));
  expect_resumed(run, arc, by(Untangling_strategy::FLOW, 0.3), {1, {never, 5}});
}

TEST(Resumed_runs, a_ball_is_filled_with_a_thickness_that_varies)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 1);
  Filling parameters = with_sharp_bends();
  parameters.thickness_field = [](const Point& p) { return 0.2 + 0.05 * p.x(); };
  expect_resumed(filling(ball), Network(), parameters,
                 {Run_stage::BRANCHING, 0, 2, {never, 7}, 19});
}

TEST(Resumed_runs, a_box_is_filled_to_a_length)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(1, 1, 2));
  Filling parameters = with_sharp_bends();
  parameters.length = 20;
  expect_resumed(filling(box), Network(), parameters, {3, 20, 40, 60});
}

// Interrupted while it bends, and while it is polished.
TEST(Resumed_runs, a_box_is_filled_with_round_bends)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(4, 4, 4));
  Filling parameters;
  parameters.thickness = 1;
  const std::size_t n = iterations_of(filling(box), Network(), parameters);
  expect_resumed(filling(box), Network(), parameters, {n - 10, n - 2, n - 1});
}

TEST(Resumed_runs, a_plate_is_filled_in_its_plane)
{
  const Polygon_domain_3<Traits> plate(polygons::plate());
  Filling parameters;
  parameters.thickness = 0.08;
  expect_resumed(filling(plate), Network(), parameters, {3, 18});
}

// Arcs between ports, which jam with this seed.
TEST(Long_resumed_runs, curves_are_loosened)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(8, 8, 8));
  Filling parameters;
  parameters.thickness = 1;
  parameters.random_seed = 15;
  parameters.ports = {{Point(0, 4, 4)}, {Point(8, 4, 4)}};
  const std::size_t n = iterations_of(filling(box), Network(), parameters);
  expect_resumed(filling(box), Network(), parameters, {20, n - 10, n - 1});
}

// Fingers are led through the neck when the curve has grown in its chamber.
TEST(Resumed_runs, two_chambers_are_filled_from_a_circle)
{
  const Triangle_mesh_domain_3<> domain(meshes::to_mesh(exact_surface::two_chambers()));
  Filling parameters = with_sharp_bends();
  parameters.thickness = 0.3;
  parameters.start = Filling_start::CIRCLE;
  expect_resumed(filling(domain), Network(), parameters, {10, Run_stage::BRANCHING, 20, 30});
}

} // namespace test_resumed_runs
