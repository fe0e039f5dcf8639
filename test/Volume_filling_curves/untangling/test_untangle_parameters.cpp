// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/archetype_visitor.h"
#include "support/refusal_of.h"
#include "support/untangle_test_support.h"

#include <Eigen/SVD>

#include <gtest/gtest.h>

#include <functional>
#include <string>

// The named parameters of untangle(), what it returns and throws, and its visitor.
namespace test_untangle_parameters {

using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::Untangling_strategy;
using namespace untangle_test;
using CGAL::Volume_filling_curves::Curve_flow_parameters;
using CGAL::Volume_filling_curves::Default_curve_flow_visitor;
using CGAL::Volume_filling_curves::Preconditioner;
using CGAL::Volume_filling_curves::Untangling_parameters;

Network unknot(std::size_t n = 100, unsigned seed = 3)
{
  return make_hard_unknot(n, 2000, seed);
}

TEST(Untangle_parameters, limit_the_number_of_iterations)
{
  for(int limit : {0, 1, 4}) {
    Network curve = unknot();
    const Untangling_result result = untangle(
        curve, parameters::number_of_iterations(limit).strategy(Untangling_strategy::FLOW));
    EXPECT_EQ(result.status, Untangling_status::LIMIT);
    EXPECT_EQ(result.statistics.iterations, static_cast<std::size_t>(limit));
    expect_valid(curve, 100);
  }
}

TEST(Untangle_parameters, limit_the_time)
{
  Network curve = unknot();
  const Untangling_result result =
      untangle(curve, parameters::time_limit(0).strategy(Untangling_strategy::FLOW));
  EXPECT_EQ(result.status, Untangling_status::LIMIT);
  EXPECT_EQ(result.statistics.iterations, 0u);
}

// A proof counts even if no time is left.
TEST(Untangle_parameters, prove_before_they_stop)
{
  Network curve = internal::closed_network({circle(30)});
  EXPECT_EQ(untangle(curve, parameters::time_limit(0)).status, Untangling_status::UNKNOTTED);
}

TEST(Untangle_parameters, go_on_until_the_curve_is_round)
{
  Network curve = unknot();
  const Untangling_result result = untangle(curve, parameters::stop_at_proof(false));
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_GE(curve.number_of_nodes(), 64u);
  const Vector_field x = internal::coordinates(curve);
  const Eigen::VectorXd distances = (x.rowwise() - x.colwise().mean()).rowwise().norm();
  EXPECT_LT(distances.maxCoeff(), (1 + 1e-9) * distances.minCoeff());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(x.rowwise() - x.colwise().mean());
  EXPECT_LT(svd.singularValues()[2], 1e-9 * svd.singularValues()[0]); // flat
  expect_valid(curve, 100);
}

// Where the proof turned up does not matter.
TEST(Untangle_parameters, end_with_a_length_that_the_thickness_determines)
{
  for(unsigned seed : {1u, 2u, 3u}) {
    Network curve = unknot(100, seed);
    constexpr auto strategy = CGAL::Volume_filling_curves::Untangling_strategy::FLOW;
    const Untangling_result result = untangle(curve, parameters::strategy(strategy));
    ASSERT_EQ(result.status, Untangling_status::UNKNOTTED);
    EXPECT_NEAR(internal::total_length(curve), 8 * result.thickness, 1e-9 * result.thickness);
  }
}

TEST(Untangle_parameters, keep_the_length)
{
  for(bool stop_at_proof : {true, false}) {
    Network curve = unknot(), other = curve;
    const double length = internal::total_length(curve);
    const auto np = parameters::stop_at_proof(stop_at_proof);
    const Untangling_result result = untangle(curve, np.keep_length(true));
    EXPECT_NEAR(internal::total_length(curve), length, 1e-9 * length);
    const double thickness = untangle(other, np).thickness;
    EXPECT_NEAR(result.thickness / length, thickness / internal::total_length(other),
                1e-9 * thickness);
    expect_valid(curve, 100);
  }
}

TEST(Untangle_parameters, set_the_thickness)
{
  Network curve = unknot();
  EXPECT_EQ(untangle(curve, parameters::thickness(0.2)).thickness, 0.2);
}

TEST(Untangle_parameters, set_the_tolerance)
{
  Network tight = braid("1 1 1", 80), loose = tight;
  EXPECT_LT(untangle(tight, parameters::tolerance(2e-3)).gradient_norm, 2e-3);
  const Untangling_result result = untangle(loose, parameters::tolerance(0.2));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_GT(result.gradient_norm, 2e-3);
}

// Remembers what it saw, and stops the run after some iterations.
struct Witness : Default_curve_flow_visitor
{
  template <typename Flow>
  void on_start(const Flow& flow)
  {
    ++number_of_starts;
    parameters = flow.parameters();
    EXPECT_EQ(flow.statistics().iterations, 0u);
  }

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    ++number_of_iterations;
    EXPECT_EQ(flow.statistics().iterations, number_of_iterations);
    EXPECT_FALSE(flow.curve().has_garbage());
    EXPECT_EQ(static_cast<std::size_t>(flow.gradient().rows()), flow.curve().number_of_nodes());
    EXPECT_EQ(flow.direction().rows(), flow.gradient().rows());
    EXPECT_EQ(flow.medial_spheres(0).size(), flow.parameters().number_of_directions);
    EXPECT_NEAR(flow.length(), internal::total_length(flow.curve()), 1e-9 * flow.length());
  }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return number_of_iterations < limit;
  }

  std::size_t limit = 5000, number_of_starts = 0, number_of_iterations = 0;
  Curve_flow_parameters parameters;
};

TEST(Untangle_visitor, follows_and_stops_the_run)
{
  Network curve = unknot();
  Witness witness;
  witness.limit = 6;
  const Untangling_result result =
      untangle(curve, parameters::visitor(std::ref(witness)).strategy(Untangling_strategy::FLOW));
  EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
  EXPECT_EQ(witness.number_of_starts, 1u);
  EXPECT_EQ(witness.number_of_iterations, 6u);
  EXPECT_EQ(result.statistics.iterations, 6u);
}

TEST(Untangle_visitor, is_copied_without_a_reference)
{
  Network curve = unknot();
  Witness witness;
  witness.limit = 2;
  EXPECT_EQ(untangle(curve, parameters::visitor(witness)).statistics.iterations, 2u);
  EXPECT_EQ(witness.number_of_iterations, 0u);
}

TEST(Untangle_visitor, needs_what_the_concept_says_and_is_called_in_that_order)
{
  Network flows = braid("1 1 1", 60), searches = flows, does_both = flows;
  archetypes::Visitor of_flow(0), of_search(0), of_both(0);
  const auto np = parameters::number_of_iterations(2);
  untangle(flows, np.strategy(Untangling_strategy::FLOW).visitor(std::ref(of_flow)));
  EXPECT_EQ(of_flow.calls, "sgigi");
  untangle(searches, np.strategy(Untangling_strategy::SEARCH).visitor(std::ref(of_search)));
  EXPECT_EQ(of_search.calls, "r");
  untangle(does_both, np.visitor(std::ref(of_both)));
  EXPECT_EQ(of_both.calls, "rsgigi");
  EXPECT_TRUE(of_flow.is_fresh && of_both.is_fresh);
}

TEST(Untangle_parameters, can_be_given_as_a_struct)
{
  Network first = unknot(), second = first;
  Untangling_parameters p;
  p.strategy = Untangling_strategy::FLOW;
  p.number_of_iterations = 3;
  p.thickness = 0.04;
  p.keep_length = true;
  Witness witness;
  const Untangling_result one = untangle(first, p, std::ref(witness));
  const Untangling_result other = untangle(second, parameters::number_of_iterations(3)
                                                       .strategy(Untangling_strategy::FLOW)
                                                       .thickness(0.04)
                                                       .keep_length(true));
  EXPECT_EQ(witness.number_of_iterations, 3u);
  EXPECT_EQ(one.thickness, other.thickness);
  EXPECT_EQ(contents(first), contents(second));
}

// the message of the error, or nothing
template <typename Parameters>
std::string complaint(Network& curve, const Parameters& p)
{
  return refusal_of([&] { untangle(curve, p); });
}

TEST(Untangle_parameters, are_refused_by_name)
{
  Network curve = unknot();
  const auto before = contents(curve);
  EXPECT_EQ(complaint(curve, parameters::screening(-1)),
            "screening is -1, but must be positive and finite");
  EXPECT_EQ(complaint(curve, parameters::number_of_chains(0)),
            "number_of_chains is 0, but must be positive and at most 1000000");
  EXPECT_EQ(complaint(curve, parameters::time_limit(-1)),
            "time_limit is -1, but must not be negative");
  EXPECT_EQ(complaint(curve, parameters::thickness(1e-9)),
            "thickness is 1e-09, but the curves would have more than 20 million nodes with that "
            "spacing");
  const std::string too_many_nodes =
      "spacing is 1e-09, but the curve would have far more than 20 million nodes";
  for(const auto strategy : {Untangling_strategy::AUTO, Untangling_strategy::FLOW})
    EXPECT_EQ(complaint(curve, parameters::spacing(1e-9).strategy(strategy)), too_many_nodes);
  EXPECT_EQ(complaint(curve, parameters::thickness(1e300)).substr(0, 54),
            "thickness is 1e+300, but must not be larger than the c");
  EXPECT_EQ(contents(curve), before);
  Network arc({{0, 0, 0}, {1, 0, 1}, {2, 1, 0}}, {{0, 1}, {1, 2}});
  arc.pin_ends(); // so that it flows with every strategy
  EXPECT_EQ(complaint(arc, parameters::spacing(1e-9)), too_many_nodes);
  EXPECT_EQ(complaint(arc, parameters::strategy(Untangling_strategy::SEARCH).thickness(1e-9)),
            complaint(curve, parameters::thickness(1e-9)));
  curve.set_pinned(3);
  EXPECT_EQ(complaint(curve, parameters::keep_length(true)),
            "keep_length is true, but node 3 is pinned, so the curves cannot be scaled");
}

void expect_all_parameters(const Curve_flow_parameters& p)
{
  EXPECT_EQ(p.thickness, 0.04);
  EXPECT_EQ(p.number_of_directions, 7u);
  EXPECT_EQ(p.max_radius, 0.8);
  EXPECT_EQ(p.spacing, 0.25);
  EXPECT_EQ(p.screening, 0.4);
  EXPECT_EQ(p.coupling, 0.02);
  EXPECT_EQ(p.preconditioner, Preconditioner::H1);
  EXPECT_EQ(p.time_step, 0.01);
  EXPECT_EQ(p.medial_weight, 11);
  EXPECT_EQ(p.max_displacement, 0.4);
}

TEST(Untangle_parameters, chain_in_any_order_with_those_of_cgal)
{
  Witness witness;
  Network first = unknot(), second = first;
  const Untangling_result one = untangle(first, parameters::thickness(0.04)
                                                    .number_of_iterations(3)
                                                    .visitor(std::ref(witness))
                                                    .number_of_directions(7)
                                                    .max_radius(0.8)
                                                    .spacing(0.25)
                                                    .screening(0.4)
                                                    .coupling(0.02)
                                                    .preconditioner(Preconditioner::H1)
                                                    .time_step(0.01)
                                                    .medial_weight(11)
                                                    .max_displacement(0.4)
                                                    .tolerance(1e-4)
                                                    .time_limit(1000)
                                                    .stop_at_proof(false)
                                                    .keep_length(true));
  expect_all_parameters(witness.parameters);
  EXPECT_EQ(one.statistics.iterations, 3u);
  Witness another;
  untangle(second, parameters::visitor(std::ref(another))
                       .keep_length(true)
                       .stop_at_proof(false)
                       .time_limit(1000)
                       .tolerance(1e-4)
                       .max_displacement(0.4)
                       .medial_weight(11)
                       .time_step(0.01)
                       .preconditioner(Preconditioner::H1)
                       .coupling(0.02)
                       .screening(0.4)
                       .spacing(0.25)
                       .max_radius(0.8)
                       .number_of_directions(7)
                       .number_of_iterations(3)
                       .thickness(0.04));
  expect_all_parameters(another.parameters);
  EXPECT_EQ(contents(first), contents(second));
}

TEST(Untangle_parameters, take_all_preconditioners)
{
  for(Preconditioner kind : {Preconditioner::MEDIAL, Preconditioner::H1, Preconditioner::L2,
                             Preconditioner::QUASI_NEWTON, Preconditioner::CONTACT}) {
    Network knot = braid("1 1 1", 60);
    const auto expected = invariants_of(knot);
    const double length = internal::total_length(knot);
    untangle(knot, parameters::preconditioner(kind).number_of_iterations(200));
    EXPECT_EQ(invariants_of(knot), expected);
    EXPECT_LT(internal::total_length(knot), length);
  }
}

// The default.
TEST(Untangle_parameters, untie_sooner_with_the_stiffness_of_contacts)
{
  EXPECT_EQ(Untangling_parameters().preconditioner, Preconditioner::CONTACT);
  std::size_t iterations = 0, iterations_of_paper = 0;
  for(unsigned seed : {3u, 4u, 5u}) {
    const auto np = parameters::strategy(Untangling_strategy::FLOW);
    Network curve = unknot(100, seed), another = curve;
    const Untangling_result result = untangle(curve, np);
    EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
    iterations += result.statistics.iterations;
    iterations_of_paper +=
        untangle(another, np.preconditioner(Preconditioner::MEDIAL)).statistics.iterations;
  }
  EXPECT_LT(iterations, iterations_of_paper);
}

TEST(Untangle_parameters, take_few_and_many_directions)
{
  for(int number : {1, 2, 3, 5, 17, 64}) {
    Network knot = braid("1 1 1", 60);
    const auto np = parameters::number_of_directions(number).number_of_iterations(40);
    untangle(knot, np.thickness(0.5));
    expect_valid(knot, 60);
  }
}

} // namespace test_untangle_parameters
