// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_UNTANGLE_TEST_SUPPORT_H
#define VFC_TEST_UNTANGLE_TEST_SUPPORT_H

#include "support/flow_test_support.h"
#include "support/guard_test_support.h"
#include "support/knot_invariants.h"

#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Tangled curves, and what their untangling must keep.
namespace untangle_test {

using namespace flow_test;
namespace parameters = CGAL::Volume_filling_curves::parameters;
using CGAL::Volume_filling_curves::Link_status;
using CGAL::Volume_filling_curves::make_closed_braid;
using CGAL::Volume_filling_curves::parse_braid_word;
using CGAL::Volume_filling_curves::Unknot_proof;
using CGAL::Volume_filling_curves::untangle;
using CGAL::Volume_filling_curves::Untangling_result;
using CGAL::Volume_filling_curves::Untangling_status;
using guard_test::contents;
using Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>;

// Tangles a curve in the unit ball by certified moves, so that it keeps its type.
inline Network tangled(const Network& curve, std::uint64_t seed, std::size_t number_of_moves = 1500)
{
  double size = 0;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    size = (std::max)(size, internal::to_vector(curve.point(v)).norm());
  Network result = transformed(curve, 0.9 / size);
  CGAL::Volume_filling_curves::Isotopy_guard_3<> guard(result);
  internal::Random_tangler<Traits> tangler(guard, seed);
  tangler.tangle(number_of_moves, 0.6);
  tangler.refine(2 * result.number_of_nodes());
  tangler.tangle(number_of_moves, 0.3);
  return result;
}

inline Network braid(const std::string& word,
                     std::size_t number_of_nodes,
                     std::size_t number_of_strands = 1)
{
  return make_closed_braid(parse_braid_word(word), number_of_nodes, 0, number_of_strands);
}

inline knot_test::Invariants invariants_of(const Network& curve)
{
  return knot_test::invariants_of(knot_test::loops_of(curve));
}

// Nodes come from different nodes of the input, or from none; the network is still a network.
inline void expect_valid(const Network& curve, std::size_t number_of_nodes_before)
{
  std::vector<bool> is_used(number_of_nodes_before, false);
  EXPECT_FALSE(curve.has_garbage());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    const std::size_t origin = curve.origin(v);
    if(origin == Network::null_node()) continue;
    ASSERT_LT(origin, number_of_nodes_before);
    EXPECT_FALSE(is_used[origin]);
    is_used[origin] = true;
  }
  EXPECT_NO_THROW(internal::check_embedded(curve));
}

} // namespace untangle_test

#endif // VFC_TEST_UNTANGLE_TEST_SUPPORT_H
