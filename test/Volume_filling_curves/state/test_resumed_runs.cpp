// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/exact_surface.h"
#include "support/polygon_test_support.h"
#include "support/refusal_of.h"
#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/Ball_domain_3.h>
#include <CGAL/Volume_filling_curves/Box_domain_3.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/fill.h>
#include <CGAL/Volume_filling_curves/internal/domain/Polygon_domain_3.h>
#include <CGAL/Volume_filling_curves/untangle_in_domain.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// Runs that are interrupted and resume end with the same bits as those that are not, and resume
// from no other state than their own.
namespace test_resumed_runs {

using namespace untangle_test;
using namespace CGAL::Volume_filling_curves;
using Point = Network::Point_3;

constexpr int never = std::numeric_limits<int>::max();

// Ends a run at an iteration, counted from the end of the whole run if it is negative; when the
// visitor has been asked some times whether a step or a search is to go on; or at the first report
// of a stage.
struct Interruption : Default_curve_flow_visitor
{
  Interruption(int n = never, int k = never) : iteration(n), answers(k) {}
  Interruption(Run_stage s) : Interruption() { stage = s; }

  int iteration, answers;
  std::optional<Run_stage> stage;

  bool on_search(const Search_progress&) { return answers-- > 0; }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return answers-- > 0;
  }
};

// All results of a run, except its time; and its last state, if it ends before its goal.
struct Outcome
{
  std::vector<double> numbers;
  int iterations;
  Run_state state;
};

template <typename Run, typename NamedParameters>
Outcome run_from(const Run& run,
                 Network curve,
                 const NamedParameters& np,
                 const Run_state& former,
                 Interruption end)
{
  Run_state state;
  Isotopy_certificate certificate;
  const auto is_to_go_on = [&](const Run_progress& moment) { return moment.stage != end.stage; };
  const auto keep_last = [&](const Run_checkpoint& checkpoint) {
    if(checkpoint.is_last) state = checkpoint.state();
  };
  const auto result = run(curve, np.number_of_iterations(end.iteration)
                                     .visitor(std::ref(end))
                                     .progress(is_to_go_on)
                                     .checkpoint(keep_last)
                                     .certificate(std::ref(certificate))
                                     .resume_from(std::cref(former)));
  const auto& done = result.statistics;
  std::vector<double> numbers = contents(curve);
  const auto note = [&](auto... values) { (numbers.push_back(static_cast<double>(values)), ...); };
  for(const std::size_t v : curve.nodes()) note(curve.is_free(v));
  for(const Curve_origin& origin : curve_origins(curve)) note(origin.parameter);
  note(done.iterations, done.certified_changes, done.refused_changes);
  note(result.status, result.thickness, result.gradient_norm);
  for(const char byte : certificate.bytes()) note(byte);
  return {numbers, static_cast<int>(done.iterations), state};
}

// Interrupts a run several times, and compares it with one that is left alone.
template <typename Run, typename NamedParameters>
void expect_resumed(const Run& run,
                    const Network& curve,
                    const NamedParameters& np,
                    const std::vector<Interruption>& interruptions)
{
  const Outcome whole = run_from(run, curve, np, {}, {});
  Run_state state;
  for(Interruption interruption : interruptions) {
    if(interruption.iteration < 0) interruption.iteration += whole.iterations;
    state = run_from(run, curve, np, state, interruption).state;
    ASSERT_FALSE(state.is_empty());
  }
  EXPECT_TRUE(run_from(run, curve, np, state, {}).numbers == whole.numbers);
}

const auto untangling = [](Network& curve, const auto& np) { return untangle(curve, np); };
const auto flow = parameters::strategy(Untangling_strategy::FLOW);

TEST(Resumed_runs, links_are_untangled_to_their_length)
{
  expect_resumed(untangling, tangled(braid("1 1 1 1", 120), 3), flow.keep_length(true),
                 {0, {never, 2}, 11, 29});
}

TEST(Resumed_runs, arcs_keep_their_rays)
{
  Network arc = path({{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {1, 1, 2}, {0, 1, 0.5}, {3, 0, 0}});
  arc.pin_ends();
  for(const double thickness : {0., 0.3})
    expect_resumed(untangling, arc, parameters::thickness(thickness), {1, 5});
}

TEST(Resumed_runs, networks_keep_their_input)
{
  Network theta({{-1, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0.3}, {0, 0.1, 0.7}, {0, -1, 0.2}},
                {{0, 3}, {3, 2}, {0, 4}, {4, 2}, {2, 5}, {5, 0}});
  theta.set_pinned(0);
  expect_resumed(untangling, theta, flow.thickness(0.2), {1, 4});
}

TEST(Resumed_runs, searches_begin_anew)
{
  const Network curve = tangled(make_torus_knot(3, 5, 120), 5);
  expect_resumed(untangling, curve, parameters::strategy(Untangling_strategy::AUTO),
                 {{never, 0}, {never, 1}, 0, 4, {never, 6}});
  expect_resumed(untangling, curve, parameters::strategy(Untangling_strategy::SEARCH),
                 {{never, 1}});
}

TEST(Resumed_runs, the_ropelength_is_lowered_anew)
{
  expect_resumed(untangling, make_torus_knot(2, 3, 60), flow.lower_ropelength(true), {3, 30});
}

// Interrupted while it flows and while it takes its shape.
TEST(Resumed_runs, curves_take_their_shape)
{
  expect_resumed(untangling, tangled(braid("1 1 1", 60), 1),
                 parameters::thickness(0.15).lower_ropelength(true).bend_radius(0.1), {5, -1});
}

TEST(Resumed_runs, nodes_slide_in_a_domain)
{
  const Box_domain_3<> box({-4, -4, -4}, {4, 4, 4});
  const auto run = [&](Network& curve, const auto& np) { return untangle(curve, box, np); };
  Network arc = path({{-3.9, 1, 0}, {-2, 0, 1}, {0, 1, -1}, {2, -1, 0}, {3, 1, 1}});
  arc.set_constraint(0, Node_constraint::on_boundary(0.1));
  arc.set_constraint(4,
                     Node_constraint::on_plane(arc.point(4), Network::Traits::Vector_3(1, 0, 0)));
  expect_resumed(run, arc, flow.thickness(0.3), {1, {never, 5}});
}

template <typename Domain>
auto filling(const Domain& domain)
{
  return [&domain](Network& curve, const auto& np) { return fill(curve, domain, np); };
}

const auto sharp_bends = parameters::round_bends(false);

TEST(Resumed_runs, a_ball_is_filled_with_a_thickness_that_varies)
{
  const Ball_domain_3<> ball(Point(1, 2, 3), 1);
  const auto thickness = [](const Point& p) { return 0.2 + 0.05 * p.x(); };
  expect_resumed(filling(ball), Network(), sharp_bends.thickness(thickness),
                 {Run_stage::BRANCHING, 0, 2, {never, 7}, 19});
}

TEST(Resumed_runs, a_box_is_filled_to_a_length)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(1, 1, 2));
  expect_resumed(filling(box), Network(), sharp_bends.length(20), {3, 20, 40, 60});
}

// Interrupted while it bends, and while it is polished.
TEST(Resumed_runs, a_box_is_filled_with_round_bends)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(4, 4, 4));
  expect_resumed(filling(box), Network(), parameters::thickness(1), {-10, -2, -1});
}

TEST(Resumed_runs, a_plate_is_filled_in_its_plane)
{
  const Polygon_domain_3<Traits> plate(polygons::plate());
  expect_resumed(filling(plate), Network(), parameters::thickness(0.08), {3, 18});
}

// Arcs between ports, which jam with this seed.
TEST(Long_resumed_runs, curves_are_loosened)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(8, 8, 8));
  const std::vector<Port<Point>> ports = {{Point(0, 4, 4)}, {Point(8, 4, 4)}};
  expect_resumed(filling(box), Network(), parameters::thickness(1).random_seed(15).ports(ports),
                 {20, -10, -1});
}

// Fingers are led through the neck when the curve has grown in its chamber.
TEST(Resumed_runs, two_chambers_are_filled_from_a_circle)
{
  const Triangle_mesh_domain_3<> domain(meshes::to_mesh(exact_surface::two_chambers()));
  expect_resumed(filling(domain), Network(),
                 sharp_bends.thickness(0.3).start(Filling_start::CIRCLE),
                 {10, Run_stage::BRANCHING, 20, 30});
}

// A survey that is cut short knows only the surroundings of one sample: here a slab, in which the
// curve would not grow coarse first, as it did in the tower on the slab.
TEST(Resumed_runs, pass_on_their_state_if_they_end_while_they_survey)
{
  std::vector<std::array<int, 3>> cells;
  for(int x = 0; x < 6; ++x)
    for(int y = 0; y < 6; ++y)
      for(int z = 0; z < (x < 3 && y < 3 ? 3 : 1); ++z) cells.push_back({x, y, z});
  const Triangle_mesh_domain_3<> domain(meshes::to_mesh(meshes::voxels(cells)));
  const auto resume = [&](const Run_state& state, const Interruption& end) {
    return run_from(filling(domain), Network(),
                    sharp_bends.thickness(0.18).start(Filling_start::CIRCLE).random_seed(0), state,
                    end);
  };
  const Run_state state = resume({}, 70).state;
  const Run_state same = resume(state, Run_stage::PREPARING).state;
  EXPECT_TRUE(resume(same, 73).numbers == resume(state, 73).numbers);
}

const Network trefoil = make_torus_knot(2, 3, 40);
const auto thick_flow = flow.thickness(0.3);

// Takes all states of a run, and returns the last one.
Run_state state_of_trefoil()
{
  Network curve = trefoil;
  Run_state state;
  const auto keep = [&](const Run_checkpoint& checkpoint) { state = checkpoint.state(); };
  untangle(curve, thick_flow.number_of_iterations(3).checkpoint(keep));
  return state;
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

// The message with which a state is refused. The curve stays as it is.
template <typename NamedParameters>
std::string refusal(const Network& start, const NamedParameters& np, const Run_state& state)
{
  Network curve = start;
  const std::string message =
      refusal_of<Run_state_error>([&] { untangle(curve, np.resume_from(std::cref(state))); });
  EXPECT_EQ(contents(curve), contents(start));
  return message;
}

template <typename Number>
std::string bytes_of(const Number& number)
{
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

// A state with other numbers, and the checksum of these.
Run_state forged(std::string body, const std::string& from, const std::string& to)
{
  return Run_state::sealed(body.replace(body.find(from), from.size(), to));
}

TEST(Run_state, curves_and_numbers_that_are_forged_are_refused)
{
  const Run_state state = state_of_trefoil();
  const std::string body(state.body());
  std::string fingerprint;
  std::vector<internal::Vector> points;
  internal::Byte_archive{body}(fingerprint, points);
  const std::string node = bytes_of(points[0]), other_node = bytes_of(points[15]);
  const std::string nan = bytes_of(std::numeric_limits<double>::quiet_NaN());
  for(const Run_state& other :
      {forged(body, node, other_node), forged(body, node, node.substr(8) + nan),
       forged(body, bytes_of(0.3), nan), Run_state::sealed(body.substr(0, 2000))})
    EXPECT_EQ(refusal(trefoil, thick_flow, other).find("the state contradicts itself: "), 0u);
  EXPECT_EQ(refusal(trefoil, thick_flow, forged(body, bytes_of(0.3), bytes_of(1e-300))),
            "the state contradicts itself: a thickness is too small");
}

TEST(Run_state, another_run_does_not_resume)
{
  const Run_state state = state_of_trefoil();
  const std::string other = "the state is that of a run with another ";
  EXPECT_EQ(refusal(trefoil, thick_flow.build_name("1a2b3c4"), state),
            other + "build_name: , not 1a2b3c4");
  EXPECT_EQ(refusal(trefoil, thick_flow.thickness(0.25), state),
            other + "thickness: 0.29999999999999999, not 0.25");
  EXPECT_EQ(refusal(trefoil, thick_flow.strategy(Untangling_strategy::SEARCH), state),
            other + "strategy: flow, not search");
  Network pinned = trefoil;
  pinned.set_pinned(5);
  for(const Network& curve : {make_torus_knot(2, 3, 41), pinned})
    EXPECT_EQ(refusal(curve, thick_flow, state), other + "curve");
}

TEST(Run_state, a_filling_with_other_shares_or_ports_does_not_resume)
{
  const Box_domain_3<> box(Point(0, 0, 0), Point(2, 1, 1));
  std::vector<Port<Point>> ports;
  for(const double y : {0.2, 0.8})
    for(const double x : {0., 2.}) ports.push_back({Point(x, y, 0.5)});
  const auto resume = [&](const std::vector<double>& shares, const Run_state& former, int end) {
    return run_from(filling(box), Network(),
                    sharp_bends.thickness(0.25).ports(ports).volume_shares(shares), former, end)
        .state;
  };
  const Run_state state = resume({1, 2}, {}, 1);
  EXPECT_FALSE(resume({1, 2}, state, 2).is_empty());
  EXPECT_THROW(resume({1, 3}, state, 2), Run_state_error);
  ports[1].direction = {1, 0, 0.5};
  EXPECT_THROW(resume({1, 2}, state, 2), Run_state_error);
}

TEST(Run_state, taking_states_changes_nothing_and_limits_may_be_others)
{
  const Run_state state = state_of_trefoil();
  Network whole = trefoil, rest = trefoil;
  untangle(whole, thick_flow);
  untangle(rest, thick_flow.time_limit(1000).resume_from(std::cref(state)));
  EXPECT_EQ(contents(rest), contents(whole));
}

} // namespace test_resumed_runs
