// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The medial spheres of all nodes, tree included, with the number of nodes and of directions, and
// what follows from them: the touching pairs, the gradient, the matrix.

#include "Flow_sample.h"

#include <CGAL/Volume_filling_curves/internal/flow/Touching_nodes.h>

namespace {

using namespace vfc_benchmark;

void medial_spheres(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const auto number_of_directions = static_cast<std::size_t>(state.range(1));
  const double cap = vfc::Curve_flow_parameters().max_radius;
  const std::vector<double> thickness = sample.thickness_per_node();
  for(auto _ : state) {
    vfc::internal::Medial_sphere_search search(CGAL::Sequential_tag(), sample.positions, thickness,
                                               cap);
    const vfc::internal::Medial_spheres spheres =
        search(vfc::internal::node_circles(sample.curve, sample.positions), number_of_directions);
    benchmark::DoNotOptimize(spheres.radius(0, 0));
  }
  count_nodes(state, sample);
}
BENCHMARK(medial_spheres)
    ->Args({32, 16})
    ->Args({1000, 16})
    ->Args({10000, 16})
    ->Args({100000, 16})
    ->Args({10000, 8})
    ->Args({10000, 32});

void touching_nodes(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  for(auto _ : state) {
    const vfc::internal::Touching_nodes touching(CGAL::Sequential_tag(), sample.spheres,
                                                 sample.curve.number_of_nodes());
    benchmark::DoNotOptimize(touching.max_nodes(0));
  }
  count_nodes(state, sample);
}
BENCHMARK(touching_nodes)->Arg(1000)->Arg(10000);

void energy_gradient(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  const std::vector<double> thickness = sample.thickness_per_node();
  const double medial_weight = vfc::Curve_flow_parameters().medial_weight;
  for(auto _ : state) {
    vfc::internal::Energy_gradient<Curve> gradient(sample.curve, sample.positions, sample.weights);
    gradient.add_length(vfc::internal::component_tensions(sample.curve, sample.positions,
                                                          sample.weights, thickness));
    gradient.add_medial_spheres(sample.spheres, thickness, medial_weight);
    benchmark::DoNotOptimize(gradient.projected({}).data());
  }
  count_nodes(state, sample);
}
BENCHMARK(energy_gradient)->Arg(1000)->Arg(10000);

void assembly(benchmark::State& state)
{
  const Flow_sample& sample = tangled_unknot(state.range(0));
  for(auto _ : state) benchmark::DoNotOptimize(sample.preconditioner().nonZeros());
  count_nodes(state, sample);
}
BENCHMARK(assembly)->Arg(1000)->Arg(10000);

} // namespace
