// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/untangle_test_support.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/measures/average_crossing_number.h>

#include <gtest/gtest.h>

// Unknots are untied; knots and links are recognized as what they were, and simple.
namespace test_untangle {

using namespace untangle_test;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::make_torus_knot;

TEST(Untangle, unties_unknots)
{
  std::size_t number_of_tangles = 0;
  for(unsigned seed = 1; seed <= 8; ++seed) {
    Network unknot = make_hard_unknot(100 + 20 * seed, 3000, seed);
    const std::size_t n = unknot.number_of_nodes();
    number_of_tangles += internal::average_crossing_number(unknot) > 20;
    const Untangling_result result = untangle(unknot);
    EXPECT_EQ(result.status, Untangling_status::UNKNOTTED) << seed;
    ASSERT_EQ(result.proofs.size(), 1u);
    EXPECT_NE(result.proofs[0], Unknot_proof::NONE);
    EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
    EXPECT_EQ(internal::unknot_proof(unknot, 0), result.proofs[0]);
    EXPECT_GT(result.thickness, 0);
    EXPECT_GT(result.statistics.iterations, 0u);
    EXPECT_GT(result.statistics.certified_changes, result.statistics.iterations);
    expect_valid(unknot, n);
  }
  EXPECT_GE(number_of_tangles, 6u);
}

struct Knot
{
  const char* name;
  const char* word;
  int crossing_number;
};

class Knots : public testing::TestWithParam<Knot>
{};

TEST_P(Knots, become_tight_and_stay_what_they_are)
{
  Network knot = tangled(braid(GetParam().word, 85), 1);
  const std::size_t n = knot.number_of_nodes();
  const auto expected = invariants_of(knot);
  EXPECT_GT(internal::average_crossing_number(knot), 3. * GetParam().crossing_number);
  const Untangling_result result = untangle(knot);
  EXPECT_EQ(invariants_of(knot), expected);
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_EQ(result.proofs[0], Unknot_proof::NONE);
  EXPECT_LT(result.gradient_norm, 7e-3);
  EXPECT_LT(internal::average_crossing_number(knot), 3. * GetParam().crossing_number);
  expect_valid(knot, n);
}

INSTANTIATE_TEST_SUITE_P(Untangle,
                         Knots,
                         testing::Values(Knot{"right_trefoil", "1 1 1", 3},
                                         Knot{"left_trefoil", "-1 -1 -1", 3},
                                         Knot{"figure_eight", "1 -2 1 -2", 4},
                                         Knot{"five_one", "1 1 1 1 1", 5},
                                         Knot{"five_two", "1 1 1 2 -1 2", 5}),
                         [](const auto& test) { return test.param.name; });

TEST(Untangle, makes_torus_knots_tight)
{
  Network knot = make_torus_knot(3, -4, 300);
  const auto expected = invariants_of(knot);
  EXPECT_EQ(untangle(knot).status, Untangling_status::CONVERGED);
  EXPECT_EQ(invariants_of(knot), expected);
}

struct Link
{
  const char* name;
  const char* word;
  std::size_t number_of_strands;
  Link_status status;
};

class Links : public testing::TestWithParam<Link>
{};

TEST_P(Links, keep_their_linking_numbers)
{
  Network link = tangled(braid(GetParam().word, 90, GetParam().number_of_strands), 4);
  const std::size_t n = link.number_of_nodes(), components = link.number_of_components();
  const auto expected = invariants_of(link);
  const Untangling_result result = untangle(link);
  EXPECT_EQ(invariants_of(link), expected);
  EXPECT_EQ(result.link, GetParam().status);
  EXPECT_EQ(result.status, GetParam().status == Link_status::TRIVIAL
                               ? Untangling_status::UNKNOTTED
                               : Untangling_status::CONVERGED);
  EXPECT_EQ(result.proofs.size(), components);
  EXPECT_EQ(link.number_of_components(), components);
  for(Unknot_proof proof : result.proofs)
    EXPECT_TRUE(proof != Unknot_proof::NONE || result.link != Link_status::TRIVIAL);
  expect_valid(link, n);
}

INSTANTIATE_TEST_SUITE_P(
    Untangle,
    Links,
    testing::Values(Link{"hopf", "1 1", 2, Link_status::LINKED},
                    Link{"chain", "1 1 -2 -2", 3, Link_status::LINKED},
                    Link{"whitehead", "1 -2 1 -2 -2", 3, Link_status::UNDECIDED},
                    Link{"borromean", "1 -2 1 -2 1 -2", 3, Link_status::UNDECIDED},
                    Link{"unlink", "", 3, Link_status::TRIVIAL}),
    [](const auto& test) { return test.param.name; });

// The components of a trivial link drift apart or stay until one of them is found removable.
TEST(Untangle, proves_nested_circles_unlinked)
{
  Network rings = internal::closed_network({circle(60, 3), circle(30, 1)});
  const Untangling_result result = untangle(rings);
  EXPECT_EQ(result.link, Link_status::TRIVIAL);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
}

TEST(Untangle, flows_junctions_and_keeps_their_graph)
{
  for(unsigned seed = 1; seed < 6; ++seed) {
    Random random(seed);
    Network graph = junctions_and_ends(12, random);
    graph.pin_ends();
    const std::size_t n = graph.number_of_nodes(), m = graph.number_of_edges();
    const Untangling_result result = untangle(graph, parameters::number_of_iterations(60));
    EXPECT_EQ(result.link, Link_status::NOT_A_LINK);
    expect_valid(graph, n);
    EXPECT_EQ(graph.number_of_edges() + n, m + graph.number_of_nodes());
    std::size_t number_of_junctions = 0, number_of_ends = 0;
    for(std::size_t v = 0; v < graph.number_of_nodes(); ++v) {
      number_of_junctions += graph.degree(v) == 3;
      number_of_ends += graph.degree(v) == 1;
    }
    EXPECT_EQ(number_of_junctions, 2u);
    EXPECT_EQ(number_of_ends, 6u);
  }
}

} // namespace test_untangle
