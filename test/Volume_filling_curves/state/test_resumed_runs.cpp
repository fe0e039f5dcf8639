// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/polygon_test_support.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// Runs that are interrupted and resume end with the same bits as those that are not; they resume
// from no other state than their own.
namespace test_resumed_runs {

using namespace untangle_test;
using namespace CGAL::Volume_filling_curves;
using Point = Network::Point_3;
using Parameters = Untangling_parameters;
using Filling = Filling_parameters<Point>;

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

// Ends a run at a limit of iterations, when the visitor has been asked some times whether a step or
// a search is to go on, or at the first report of a stage.
struct Interruption : Default_curve_flow_visitor
{
  Interruption(std::size_t n = never, std::size_t k = never) : iterations(n), answers(k) {}
  Interruption(Run_stage s) : Interruption() { stage = s; }

  std::size_t iterations, answers;
  std::optional<Run_stage> stage;

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return answers > 0 && answers-- > 0;
  }

  bool on_search(const Search_progress&) { return answers > 0 && answers-- > 0; }
};

// All results of a run, except its time and its last state.
struct Outcome
{
  std::vector<double> numbers;
  Run_state state;
};

template <typename Run, typename P>
Outcome run_from(const Run& run, Network curve, P p, const Run_state& state, Interruption visitor)
{
  Outcome outcome;
  Isotopy_certificate certificate;
  p.certificate = &certificate;
  p.resume_from = &state;
  if(visitor.iterations != never) p.number_of_iterations = visitor.iterations;
  p.progress = [&](const Run_progress& progress) { return progress.stage != visitor.stage; };
  p.checkpoint = [&](const Run_checkpoint& checkpoint) {
    if(checkpoint.is_last) outcome.state = Run_state(checkpoint.state().bytes());
  };
  const auto result = run(curve, p, visitor);
  const auto& done = result.statistics;
  const auto note = [&](auto... numbers) {
    (outcome.numbers.push_back(static_cast<double>(numbers)), ...);
  };
  for(const std::size_t v : curve.nodes()) {
    const Point& x = curve.point(v);
    note(x.x(), x.y(), x.z(), curve.origin(v), curve.is_pinned(v), curve.is_free(v),
         curve.component(v));
  }
  for(const Curve_origin& origin : curve_origins(curve)) note(origin.parameter);
  note(done.iterations, done.certified_changes, done.refused_changes);
  note(result.status, result.thickness, result.gradient_norm);
  for(const char byte : certificate.bytes()) note(byte);
  return outcome;
}

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

const auto untangling = [](Network& curve, const Parameters& parameters, auto visitor) {
  return untangle(curve, parameters, visitor);
};

Parameters by(Untangling_strategy strategy, double thickness = 0)
{
  Parameters parameters;
  parameters.strategy = strategy;
  parameters.thickness = thickness;
  return parameters;
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

template <typename Domain>
auto filling(const Domain& domain)
{
  return [&domain](Network& curve, const Filling& parameters, auto visitor) {
    return fill(curve, domain, parameters, visitor);
  };
}

Filling with_sharp_bends()
{
  Filling parameters;
  parameters.round_bends = false;
  return parameters;
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
  parameters.random_seed = 19;
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

Network trefoil()
{
  return make_torus_knot(2, 3, 40);
}

Parameters flow()
{
  return by(Untangling_strategy::FLOW, 0.3);
}

Run_state state_of_trefoil()
{
  return run_from(untangling, trefoil(), flow(), {}, 3).state;
}

TEST(Run_state, bytes_that_are_damaged_or_cut_off_are_refused)
{
  const std::string bytes = state_of_trefoil().bytes();
  EXPECT_EQ(Run_state(bytes).bytes(), bytes);
  for(std::size_t i = 0; i < bytes.size(); i += i < 64 ? 1 : 61) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    EXPECT_THROW(Run_state{damaged}, Run_state_error) << "byte " << i;
    EXPECT_THROW(Run_state(bytes.substr(0, i)), Run_state_error) << i;
  }
  EXPECT_THROW(Run_state(bytes + '\0'), Run_state_error);
}

std::string bytes_of(const std::vector<double>& numbers)
{
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// A state with other numbers, and the checksum of these.
Run_state forged(const Run_state& state, const std::string& from, const std::string& to)
{
  std::string body(state.body());
  const std::size_t begin = body.find(from);
  EXPECT_NE(begin, std::string::npos);
  return Run_state::sealed(body.replace(begin, from.size(), to));
}

TEST(Run_state, curves_and_numbers_that_are_forged_are_refused)
{
  const Run_state state = state_of_trefoil();
  const std::vector<double> numbers = run_from(untangling, trefoil(), flow(), {}, 3).numbers;
  const auto at = [&](std::size_t v) {
    return bytes_of({numbers[7 * v], numbers[7 * v + 1], numbers[7 * v + 2]});
  };
  const std::string nan = bytes_of({std::numeric_limits<double>::quiet_NaN()});
  for(const Run_state& other :
      {forged(state, at(0), at(105)), forged(state, at(0), at(0).substr(8) + nan),
       forged(state, bytes_of({0.3}), nan), Run_state::sealed(state.body().substr(0, 2000))})
    EXPECT_THROW(run_from(untangling, trefoil(), flow(), other, 4), Run_state_error);
  const Run_state contradicting = forged(state, bytes_of({0.3}), nan);
  Network curve = trefoil();
  EXPECT_THROW(untangle(curve, parameters::strategy(Untangling_strategy::FLOW)
                                   .thickness(0.3)
                                   .resume_from(std::cref(contradicting))),
               Run_state_error);
  EXPECT_EQ(contents(curve), contents(trefoil()));
}

std::string complaint(const Network& curve, const Parameters& parameters)
{
  try {
    run_from(untangling, curve, parameters, state_of_trefoil(), 4);
  } catch(const Run_state_error& error) {
    return error.what();
  }
  return "";
}

TEST(Run_state, another_run_does_not_resume)
{
  const std::string other = "the state is that of a run with another ";
  Parameters parameters = flow();
  parameters.build_name = "1a2b3c4";
  EXPECT_EQ(complaint(trefoil(), parameters), other + "build_name: , not 1a2b3c4");
  parameters = by(Untangling_strategy::FLOW, 0.25);
  EXPECT_EQ(complaint(trefoil(), parameters), other + "thickness: 0.29999999999999999, not 0.25");
  parameters = by(Untangling_strategy::SEARCH, 0.3);
  EXPECT_EQ(complaint(trefoil(), parameters), other + "strategy: flow, not search");
  EXPECT_EQ(complaint(make_torus_knot(2, 3, 41), flow()), other + "curve");
  Network pinned = trefoil();
  pinned.set_pinned(5);
  EXPECT_EQ(complaint(pinned, flow()), other + "curve");
}

TEST(Run_state, a_filling_with_other_shares_or_ports_does_not_resume)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(2, 1, 1));
  Filling parameters = with_sharp_bends();
  parameters.thickness = 0.25;
  for(const double y : {0.2, 0.8}) {
    parameters.ports.push_back({Point(0, y, 0.5)});
    parameters.ports.push_back({Point(2, y, 0.5)});
  }
  parameters.volume_shares = {1, 2};
  const auto resume = [&](const Filling& p, const Run_state& state) {
    return run_from(filling(box), Network(), p, state, state.is_empty() ? 1 : 2).state;
  };
  const Run_state state = resume(parameters, {});
  EXPECT_FALSE(resume(parameters, state).is_empty());
  Filling other = parameters;
  other.volume_shares = {1, 3};
  EXPECT_THROW(resume(other, state), Run_state_error);
  other = parameters;
  other.ports[1].direction = {1, 0, 0.5};
  EXPECT_THROW(resume(other, state), Run_state_error);
}

TEST(Run_state, taking_states_changes_nothing_and_limits_may_be_others)
{
  const auto np = parameters::strategy(Untangling_strategy::FLOW).thickness(0.3);
  Network whole = trefoil(), part = trefoil(), rest = trefoil();
  untangle(whole, np);
  Run_state state;
  untangle(part, np.number_of_iterations(3).checkpoint(
                     [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); }));
  untangle(rest, np.time_limit(1000).resume_from(std::cref(state)));
  EXPECT_EQ(contents(rest), contents(whole));
}

} // namespace test_resumed_runs
