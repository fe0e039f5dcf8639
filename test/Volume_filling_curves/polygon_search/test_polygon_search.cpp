// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace test_polygon_search {

namespace internal = CGAL::Volume_filling_curves::internal;
namespace parameters = CGAL::Volume_filling_curves::parameters;
using CGAL::Volume_filling_curves::Default_curve_flow_visitor;
using CGAL::Volume_filling_curves::Isotopy_guard_3;
using CGAL::Volume_filling_curves::Link_status;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::make_lattice_polygon;
using CGAL::Volume_filling_curves::make_torus_knot;
using CGAL::Volume_filling_curves::parse_braid_word;
using CGAL::Volume_filling_curves::Run_progress;
using CGAL::Volume_filling_curves::Run_stage;
using CGAL::Volume_filling_curves::Search_progress;
using CGAL::Volume_filling_curves::simplify_curves;
using CGAL::Volume_filling_curves::untangle;
using CGAL::Volume_filling_curves::Untangling_result;
using CGAL::Volume_filling_curves::Untangling_status;
using CGAL::Volume_filling_curves::Untangling_strategy;
using guard_test::contents;
using internal::Polygons;
using internal::Vector;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Point_3 = Network::Point_3;

Polygons braid(const std::string& word, std::size_t number_of_nodes, std::size_t strands = 1)
{
  return internal::braid_closure(parse_braid_word(word), number_of_nodes, 0, strands);
}

template <typename Function>
Network mapped(Polygons polygons, const Function& f)
{
  for(auto& polygon : polygons)
    for(auto& p : polygon) p = f(p);
  return internal::closed_network(polygons);
}

Network on_lattice(const Polygons& polygons, double scale)
{
  return mapped(polygons, [&](const Vector& p) {
    return Vector(std::round(scale * p.x()), std::round(scale * p.y()), std::round(scale * p.z()));
  });
}

struct Search_outcome
{
  bool has_reached_goal;
  std::size_t moves, refusals;
};

template <typename ConcurrencyTag = CGAL::Sequential_tag>
Search_outcome search(Network& curve, std::uint64_t seed, std::size_t number_of_chains = 1)
{
  Isotopy_guard_3<> guard(curve);
  internal::Polygon_search<Isotopy_guard_3<>, ConcurrencyTag> polygon_search(
      curve, internal::Search_parameters(), number_of_chains, seed);
  polygon_search.run([] { return true; });
  polygon_search.apply(guard, [] { return true; });
  guard.collect_garbage();
  return {polygon_search.has_reached_goal(), polygon_search.progress().moves,
          guard.number_of_refused_changes()};
}

knot_test::Invariants invariants_of(const Network& curve)
{
  return knot_test::invariants_of(knot_test::loops_of(curve));
}

// The guard carries out all that the search did, whose double filters are its own.
void expect_unknotted(const Network& curve, const std::string& name)
{
  ASSERT_NO_THROW(internal::check_embedded(curve)) << name;
  for(std::uint64_t seed = 0; seed < 3; ++seed) {
    Network copy = curve;
    const Search_outcome result = search(copy, seed);
    EXPECT_TRUE(result.has_reached_goal) << name << ", seed " << seed;
    EXPECT_EQ(result.refusals, 0u) << name << ", seed " << seed;
    EXPECT_LE(copy.number_of_nodes(), 5u) << name << ", seed " << seed;
    EXPECT_NO_THROW(internal::check_embedded(copy));
  }
}

void expect_kept(const Network& curve,
                 const knot_test::Invariants& before,
                 std::size_t stick_number,
                 const std::string& name)
{
  ASSERT_NO_THROW(internal::check_embedded(curve)) << name;
  for(std::uint64_t seed = 0; seed < 3; ++seed) {
    Network copy = curve;
    const Search_outcome result = search(copy, seed);
    EXPECT_FALSE(result.has_reached_goal) << name;
    EXPECT_EQ(result.refusals, 0u) << name;
    EXPECT_GE(copy.number_of_nodes(), stick_number) << name;
    EXPECT_LE(copy.number_of_nodes(), stick_number + 1) << name;
    EXPECT_TRUE(invariants_of(copy) == before) << name;
    EXPECT_NO_THROW(internal::check_embedded(copy));
  }
}

void expect_kept(const Network& curve, std::size_t stick_number, const std::string& name)
{
  expect_kept(curve, invariants_of(curve), stick_number, name);
}

TEST(Polygon_search, unties_unknots)
{
  expect_unknotted(make_hard_unknot(300, 40, 1), "hard unknot");
  expect_unknotted(internal::closed_network(braid("1 2 -3 4", 160)), "braid");
}

TEST(Polygon_search, unties_lattice_polygons)
{
  for(std::uint64_t seed = 0; seed < 3; ++seed)
    expect_unknotted(make_lattice_polygon(600, seed), "lattice polygon");
}

TEST(Polygon_search, keeps_knots_and_their_stick_numbers)
{
  expect_kept(internal::closed_network(braid("1 1 1", 100)), 6, "3_1");
  expect_kept(internal::closed_network(braid("1 -2 1 -2", 100)), 7, "4_1");
  expect_kept(internal::closed_network(braid("1 1 1 1 1", 120)), 8, "5_1");
  expect_kept(internal::closed_network(braid("1 1 1 2 -1 2", 120)), 8, "5_2");
  expect_kept(make_torus_knot(4, 3, 150), 8, "8_19");
}

TEST(Polygon_search, keeps_knots_on_the_lattice)
{
  expect_kept(on_lattice(braid("1 1 1", 60), 12), 6, "3_1");
  expect_kept(on_lattice(braid("1 -2 1 -2", 80), 16), 7, "4_1");
}

// All strands within a few units in the last place of a plane.
TEST(Polygon_search, keeps_knots_with_contacts_at_rounding_level)
{
  const auto flat = [](double height, double shift) {
    return mapped(braid("1 1 1", 60), [=](const Vector& p) {
      return Vector(std::round(0x1p20 * p.x()) * 0x1p-20, std::round(0x1p20 * p.y()) * 0x1p-20,
                    shift + height * std::round(0x1p6 * p.z()));
    });
  };
  const knot_test::Invariants trefoil = invariants_of(flat(1, 0));
  expect_kept(flat(0x1p-50, 1), trefoil, 6, "strands 4 ulp apart");
  expect_kept(flat(0x1p-60, 0), trefoil, 6, "strands 1e-18 apart");
  expect_kept(flat(0x1p-300, 0), trefoil, 6, "strands 1e-90 apart");
}

TEST(Polygon_search, manages_collinear_runs_and_planar_curves)
{
  Polygons comb(1);
  for(int tooth = 0; tooth < 10; ++tooth)
    for(const auto& [x, y] :
        std::vector<std::array<int, 2>>{{0, 0}, {0, 1}, {0, 5}, {1, 5}, {1, 1}, {1, 0}})
      comb[0].emplace_back(2 * tooth + x, y, 0);
  for(int x = 19; x >= 0; --x) comb[0].emplace_back(x, -1, 0);
  expect_unknotted(internal::closed_network(comb), "comb");
}

TEST(Polygon_search, pulls_split_components_apart)
{
  // each ring hooks into the other and comes back
  Network curve = internal::closed_network(braid("1 1 -1 -1 1 -1", 120));
  ASSERT_EQ(curve.number_of_components(), 2u);
  const Search_outcome result = search(curve, 0);
  EXPECT_TRUE(result.has_reached_goal);
  EXPECT_EQ(result.refusals, 0u);
  EXPECT_LE(curve.number_of_nodes(), 10u);
}

TEST(Polygon_search, keeps_links)
{
  for(const std::string word : {"1 1", "1 -2 1 -2 1 -2", "1 1 1 1"}) {
    Network curve = internal::closed_network(braid(word, 120));
    const knot_test::Invariants before = invariants_of(curve);
    EXPECT_FALSE(search(curve, 0).has_reached_goal) << word;
    EXPECT_TRUE(invariants_of(curve) == before) << word;
  }
}

// The nodes that must stay, by their origins.
std::map<std::size_t, Point_3> fixed_nodes(const Network& curve)
{
  std::map<std::size_t, Point_3> result;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) != 2 || curve.is_pinned(v)) result[curve.origin(v)] = curve.point(v);
  return result;
}

TEST(Polygon_search, leaves_pins_ends_and_junctions_where_they_are)
{
  guard_test::Random random(5);
  for(int k = 0; k < 100; ++k) {
    Network curve = guard_test::to_network(guard_test::random_curve(5, k % 2 == 0, random));
    curve.set_pinned(0);
    const Network start = curve;
    EXPECT_EQ(search(curve, static_cast<std::uint64_t>(k)).refusals, 0u);
    EXPECT_NO_THROW(internal::check_embedded(curve));
    EXPECT_EQ(fixed_nodes(curve), fixed_nodes(start));
  }
}

TEST(Polygon_search, depends_on_the_seed_only)
{
  const Network start = make_hard_unknot(300, 40, 2);
  Network first = start, again = start, other = start;
  search(first, 7, 3);
  search(again, 7, 3);
  search(other, 8, 3);
  EXPECT_EQ(contents(first), contents(again));
  EXPECT_NE(contents(first), contents(other));
#ifdef CGAL_LINKED_WITH_TBB
  for(int k = 0; k < 10; ++k) {
    Network parallel = start;
    search<CGAL::Parallel_tag>(parallel, 7, 3);
    EXPECT_EQ(contents(first), contents(parallel));
  }
#endif
}

TEST(Polygon_search, does_not_depend_on_powers_of_two)
{
  const auto moves = [](double scale) {
    Network curve = mapped(braid("1 1 1", 100), [&](const Vector& p) { return Vector(scale * p); });
    search(curve, 0);
    std::vector<double> result;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      for(int k = 0; k < 3; ++k) result.push_back(curve.point(v)[k] / scale);
    return result;
  };
  EXPECT_EQ(moves(1), moves(0x1p30));
  EXPECT_EQ(moves(1), moves(0x1p-30));
}

TEST(Polygon_search, takes_the_search_with_the_fewest_moves)
{
  const Network start = make_hard_unknot(400, 60, 3);
  Network one = start, four = start;
  EXPECT_GE(search(one, 1, 1).moves, search(four, 1, 4).moves);
}

Untangling_result untangled(Network& curve, Untangling_strategy strategy)
{
  return untangle(curve, parameters::strategy(strategy).number_of_chains(1).random_seed(3));
}

TEST(Untangling_strategy, searches_for_few_edges)
{
  Network unknot = make_hard_unknot(300, 40, 1);
  const Untangling_result result = untangled(unknot, Untangling_strategy::SEARCH);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_LE(unknot.number_of_nodes(), 5u);
  EXPECT_EQ(result.statistics.iterations, 0u);
  EXPECT_EQ(result.searches, 1u);
  Network trefoil = internal::closed_network(braid("1 1 1", 100));
  EXPECT_EQ(untangled(trefoil, Untangling_strategy::SEARCH).status, Untangling_status::CONVERGED);
  EXPECT_EQ(trefoil.number_of_nodes(), 6u);
}

TEST(Untangling_strategy, auto_ends_like_the_flow)
{
  for(const std::string word : {"1 1 1", "1 -2 1 -2", "1 1"}) {
    Network by_flow = internal::closed_network(braid(word, 150)), by_auto = by_flow;
    const knot_test::Invariants before = invariants_of(by_flow);
    const Untangling_result flow = untangled(by_flow, Untangling_strategy::FLOW);
    const Untangling_result mixed = untangled(by_auto, Untangling_strategy::AUTO);
    EXPECT_EQ(flow.status, Untangling_status::CONVERGED) << word;
    EXPECT_EQ(mixed.status, Untangling_status::CONVERGED) << word;
    EXPECT_EQ(flow.searches, 0u);
    EXPECT_GE(mixed.searches, 1u);
    EXPECT_TRUE(invariants_of(by_auto) == before) << word;
    EXPECT_EQ(mixed.link, flow.link) << word;
    const double a = internal::total_length(by_flow) / flow.thickness;
    const double b = internal::total_length(by_auto) / mixed.thickness;
    EXPECT_NEAR(b / a, 1, 0.1) << word;
  }
}

TEST(Untangling_strategy, auto_makes_unknots_smooth_and_of_the_former_length)
{
  Network curve = make_hard_unknot(300, 40, 1);
  const double length = internal::total_length(curve);
  const Untangling_result result = untangle(curve, parameters::random_seed(1).keep_length(true));
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_LT(internal::max_turning_angle(curve), 1.01);
  EXPECT_NEAR(internal::total_length(curve) / length, 1, 1e-9);
}

TEST(Untangling_strategy, auto_lets_unknots_flow_as_far_as_the_flow_does)
{
  Network curve = make_hard_unknot(300, 40, 1);
  const double start_length = internal::total_length(curve);
  const Untangling_result result = untangled(curve, Untangling_strategy::AUTO);
  EXPECT_EQ(result.status, Untangling_status::UNKNOTTED);
  EXPECT_NEAR(internal::total_length(curve) / (8 * result.thickness), 1, 1e-9);
  EXPECT_GT(internal::total_length(curve), 0.1 * start_length) << "the search has shrunk it";
  EXPECT_LT(CGAL::Volume_filling_curves::total_curvatures(curve)[0], 1.5 * 6.283);
}

TEST(Untangling_strategy, takes_a_thickness)
{
  Network curve = internal::closed_network(braid("1 1 1", 150));
  const double thickness = 0.005 * internal::total_length(curve);
  const Untangling_result result = untangle(curve, parameters::thickness(thickness));
  EXPECT_EQ(result.status, Untangling_status::CONVERGED);
  EXPECT_EQ(result.thickness, thickness);
}

struct Impatient_visitor : Default_curve_flow_visitor
{
  bool on_search(const Search_progress& progress)
  {
    edges = progress.edges;
    return ++calls < 2;
  }

  std::size_t calls = 0, edges = 0;
};

TEST(Untangling_strategy, can_be_stopped)
{
  const Network start = internal::closed_network(braid("1 -2 3 -2 1 -2 3 -2 1 -2", 300));
  Network curve = start;
  Impatient_visitor visitor;
  Untangling_result result =
      untangle(curve, parameters::visitor(std::ref(visitor)).strategy(Untangling_strategy::SEARCH));
  EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
  EXPECT_EQ(visitor.calls, 2u);
  EXPECT_EQ(visitor.edges, curve.number_of_nodes());
  EXPECT_TRUE(invariants_of(curve) == invariants_of(start));
  curve = start;
  result = untangle(curve, parameters::time_limit(0));
  EXPECT_EQ(result.status, Untangling_status::LIMIT);
}

// The changes of the search were not carried over to the curve.
TEST(Untangling_strategy, keeps_what_a_search_has_found_before_an_interruption)
{
  const Network start = internal::closed_network(braid("1 -2 3 -2 1 -2 3 -2 1 -2", 300));
  for(const auto strategy : {Untangling_strategy::SEARCH, Untangling_strategy::AUTO}) {
    Network simplified = start, curve = start;
    simplify_curves(simplified);
    std::size_t edges = 0;
    const auto progress = [&](const Run_progress& moment) {
      if(moment.stage != Run_stage::SEARCHING || moment.nodes == 0) return true;
      edges = moment.nodes;
      return edges >= simplified.number_of_nodes();
    };
    const auto result = untangle(curve, parameters::strategy(strategy).progress(progress));
    EXPECT_EQ(result.status, Untangling_status::INTERRUPTED);
    EXPECT_LT(edges, simplified.number_of_nodes());
    EXPECT_LE(curve.number_of_nodes(), edges);
    EXPECT_TRUE(invariants_of(curve) == invariants_of(start));
    curve = start;
    Impatient_visitor visitor;
    untangle(curve, parameters::strategy(strategy).visitor(std::ref(visitor)));
    EXPECT_EQ(curve.number_of_nodes(), visitor.edges);
  }
}

} // namespace test_polygon_search
