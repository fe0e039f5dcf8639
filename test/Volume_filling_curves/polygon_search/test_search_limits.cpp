// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/guard_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

// When a search ends that does not help any more, and how much it remembers.
namespace test_search_limits {

namespace internal = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::Isotopy_guard_3;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::make_hard_unknot;
using CGAL::Volume_filling_curves::parse_braid_word;
using guard_test::contents;
using internal::Search_chain;
using internal::Search_parameters;
using Network = CGAL::Volume_filling_curves::Curve_network_3<>;
using Guard = Isotopy_guard_3<>;
using Search = internal::Polygon_search<Guard, CGAL::Sequential_tag>;

Search_chain chain(const Network& curve, const Search_parameters& parameters)
{
  return {internal::Search_polygon(curve), internal::Search_goal(curve), parameters, 1};
}

// An alternating diagram of 48 crossings has no fewer, and a polygon of 11 edges has at most 44.
Network alternating_braid()
{
  std::string word;
  for(int k = 0; k < 12; ++k) word += "1 -2 3 -2 ";
  return make_closed_braid(parse_braid_word(word), 700, 0, 1);
}

TEST(Search_limits, ends_after_work_in_vain)
{
  Search_chain search = chain(alternating_braid(), Search_parameters());
  search.run(3'000'000);
  EXPECT_TRUE(search.has_ended());
  EXPECT_FALSE(search.has_reached_goal());
  EXPECT_GT(search.best(), 11u);
}

TEST(Search_limits, has_more_patience_where_it_helps)
{
  const Search_parameters parameters;
  for(std::size_t n = 3; n < 200; ++n) {
    EXPECT_GE(parameters.patience(n + 1), parameters.patience(n));
    EXPECT_GE(parameters.patience(n), 10'000u);
    EXPECT_LE(parameters.patience(n), 1'000'000u);
  }
  EXPECT_GT(parameters.patience(72), 810'000u);
}

TEST(Search_limits, remembers_no_more_operations_than_it_may)
{
  Search_parameters parameters;
  parameters.max_operations = 3000;
  const Network curve = alternating_braid();
  Search_chain search = chain(curve, parameters);
  for(std::size_t moves = 1000; !search.has_ended(); moves += 1000) {
    search.run(moves);
    search.record();
    EXPECT_LE(search.best_operations().size(), 2 * curve.number_of_nodes() + 3000);
  }
  EXPECT_GT(search.best_operations().size(), 0u);
}

TEST(Search_limits, knows_its_result_before_it_is_certified)
{
  const Network start = make_hard_unknot(200, 20, 1);
  Search search(start, Search_parameters(), 1, 1);
  search.run([] { return true; });
  Network certified = start;
  Guard guard(certified);
  search.apply(guard, [] { return true; });
  guard.collect_garbage();
  EXPECT_EQ(contents(search.uncertified_result(start)), contents(certified));
  EXPECT_LE(certified.number_of_nodes(), 5u);
}

// A curve on the way is as good as any for its type.
TEST(Search_limits, can_end_while_it_applies_its_result)
{
  const Network start = make_hard_unknot(400, 60, 3);
  Search search(start, Search_parameters(), 1, 1);
  search.run([] { return true; });
  Network curve = start;
  Guard guard(curve);
  search.apply(guard, [] { return false; });
  guard.collect_garbage();
  EXPECT_LT(guard.number_of_certified_changes(), 1025u);
  EXPECT_EQ(guard.number_of_refused_changes(), 0u);
  EXPECT_NO_THROW(internal::check_embedded(curve));
}

} // namespace test_search_limits
