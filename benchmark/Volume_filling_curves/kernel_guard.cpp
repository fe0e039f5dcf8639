// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The guard's operations: moving all nodes there and back; moving single nodes; a round of
// remeshing.

#include "Flow_sample.h"

#include <CGAL/Volume_filling_curves/internal/flow/Remesher.h>

#include <array>
#include <vector>

namespace {

using namespace vfc_benchmark;
using Guard = vfc::Isotopy_guard_3<Curve::Traits>;
using Remesher = vfc::internal::Remesher<Guard>;

constexpr double clearance = 0.1; // in units of the thickness, as in the flow

void move_nodes(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const std::array<Vector_field, 2> ends = {sample.target(0.1), sample.positions};
  Curve curve = sample.curve;
  Guard guard(curve);
  guard.set_clearance(clearance * sample.thickness);
  std::size_t way = 0;
  for(auto _ : state)
    if(guard.move_nodes(ends[way++ % 2]) < 1) state.SkipWithError("a move was refused");
  count_nodes(state, sample);
}
BENCHMARK(move_nodes)->Arg(32)->Arg(1000)->Arg(10000)->Arg(100000);

void move_single_nodes(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const std::array<Vector_field, 2> ends = {sample.target(0.1), sample.positions};
  Curve curve = sample.curve;
  Guard guard(curve);
  std::size_t way = 0;
  for(auto _ : state) {
    const Vector_field& x = ends[way++ % 2];
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      guard.move_node(v, vfc::internal::to_point(vfc::internal::row(x, v), curve.traits()));
  }
  count_nodes(state, sample);
}
BENCHMARK(move_single_nodes)->Arg(1000)->Arg(10000);

// Halves all edges and takes the new nodes away again.
void remeshing(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const double spacing = vfc::Curve_flow_parameters().spacing * sample.thickness;
  Curve curve = sample.curve;
  Guard guard(curve);
  guard.set_clearance(clearance * sample.thickness);
  const auto per_node = [&](double h) { return std::vector<double>(curve.number_of_nodes(), h); };
  std::size_t nodes = 0;
  for(auto _ : state) {
    Remesher(guard, per_node(spacing / 2)).split_long_edges();
    guard.collect_garbage();
    nodes += curve.number_of_nodes();
    Remesher(guard, per_node(spacing)).collapse_short_edges();
    guard.collect_garbage();
    nodes += curve.number_of_nodes();
  }
  using benchmark::Counter;
  state.counters["per_node"] =
      Counter(static_cast<double>(nodes), Counter::kIsRate | Counter::kInvert);
}
BENCHMARK(remeshing)->Arg(1000)->Arg(10000);

} // namespace
