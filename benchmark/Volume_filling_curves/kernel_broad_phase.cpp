// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The pairs of edges that can meet during a motion of all nodes: hash grid against CGAL's AABB tree,
// each built and asked for the candidates of every edge, with the number of nodes and the largest
// displacement in percent of the thickness.

#include "Flow_sample.h"

#include <CGAL/Volume_filling_curves/internal/Aabb_tree_broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/Grid_broad_phase.h>

namespace {

using namespace vfc_benchmark;

template <typename Broad_phase>
void broad_phase(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const Vector_field target = sample.target(static_cast<double>(state.range(1)) / 100);
  const double margin = 0.1 * sample.thickness; // the flow's clearance
  std::size_t pairs = 0;
  for(auto _ : state) {
    const Broad_phase phase(sample.curve, sample.positions, target, margin);
    pairs = 0;
    for(std::size_t e = 0; e < sample.curve.number_of_edges(); ++e)
      phase.for_each_candidate_below(e, [&](std::size_t) { ++pairs; });
  }
  state.counters["pairs"] = static_cast<double>(pairs);
  count_nodes(state, sample);
}

using Grid = vfc::internal::Grid_broad_phase<Curve>;
using Aabb_tree = vfc::internal::Aabb_tree_broad_phase<Curve>;

void arguments(benchmark::internal::Benchmark* benchmark)
{
  for(int nodes : {32, 1000, 10000, 100000}) benchmark->Args({nodes, 10});
  benchmark->Args({10000, 50});
}
BENCHMARK_TEMPLATE(broad_phase, Grid)->Apply(arguments);
BENCHMARK_TEMPLATE(broad_phase, Aabb_tree)->Apply(arguments);

} // namespace
