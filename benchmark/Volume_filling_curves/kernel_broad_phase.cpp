// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The pairs of edges that can meet during a motion of all nodes, with the number of nodes and the
// largest displacement in percent of the thickness: on tangled unknots, few strands of which touch,
// and on torus knots that are nearly tight.

#include "Flow_sample.h"

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>

namespace {

using namespace vfc_benchmark;

void find_pairs(benchmark::State& state, const Flow_sample& sample)
{
  const Vector_field target = sample.target(static_cast<double>(state.range(1)) / 100);
  const double margin = 0.1 * sample.thickness; // the flow's clearance
  const auto have_no_common_node = [&](std::size_t e, std::size_t f) {
    return !vfc::internal::share_a_node(sample.curve, e, f);
  };
  std::size_t pairs = 0;
  for(auto _ : state) {
    const vfc::internal::Broad_phase phase(CGAL::Sequential_tag(), sample.curve, sample.positions,
                                           target, margin);
    pairs = phase.pairs<CGAL::Sequential_tag>(have_no_common_node).size();
  }
  state.counters["pairs"] = static_cast<double>(pairs);
  count_nodes(state, sample);
}

void tangle(benchmark::State& state)
{
  find_pairs(state, tangled_unknot(state.range(0)));
}
BENCHMARK(tangle)->ArgsProduct({{32, 1000, 10000, 100000}, {10}})->Args({10000, 50});

void torus_knot(benchmark::State& state)
{
  find_pairs(state, tight_torus_knot(state.range(0)));
}
BENCHMARK(torus_knot)->ArgsProduct({{3, 7, 15}, {10, 50}});

} // namespace
