// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_FLOW_SAMPLE_H
#define VFC_BENCHMARK_FLOW_SAMPLE_H

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace vfc_benchmark {

namespace vfc = CGAL::Volume_filling_curves;
using Curve = vfc::Curve_network_3<>;
using vfc::internal::Vector_field;

// A curve in the middle of its flow, and the direction in which it would go on. The flow's own
// spacing decides how many nodes it has.
struct Flow_sample
{
  Curve curve;
  double thickness = 0;
  Vector_field positions, gradient, direction;
  std::vector<double> weights;
  vfc::internal::Medial_spheres spheres;

  Flow_sample(const Curve& start, int steps) : curve(start)
  {
    vfc::Isotopy_guard_3<> guard(curve);
    vfc::Curve_flow_3 flow(guard);
    for(int k = 0; k < steps; ++k) flow.step();
    thickness = flow.thickness();
    gradient = flow.gradient();
    direction = flow.direction();
    positions = vfc::internal::coordinates(curve);
    weights = vfc::internal::node_weights(curve, positions);
    const vfc::Curve_flow_parameters& parameters = flow.parameters();
    const std::vector<double> thicknesses = thickness_per_node();
    spheres = vfc::internal::Medial_sphere_search(CGAL::Sequential_tag(), positions, thicknesses,
                                                  parameters.max_radius)(
        vfc::internal::node_circles(curve, positions), parameters.number_of_directions);
  }

  std::vector<double> thickness_per_node() const
  {
    return std::vector<double>(curve.number_of_nodes(), thickness);
  }

  vfc::internal::Sparse_matrix preconditioner() const
  {
    return vfc::internal::preconditioner(vfc::Curve_flow_parameters(), curve, positions, weights,
                                         thickness_per_node(), spheres);
  }

  // the positions after a step whose largest displacement is that times the thickness
  Vector_field target(double displacement) const
  {
    const double longest = direction.rowwise().norm().maxCoeff();
    return positions + displacement * thickness / longest * direction;
  }
};

// Samples are made once.
template <typename Make>
const Flow_sample& remembered_sample(std::int64_t size, const Make& make)
{
  static std::map<std::int64_t, std::unique_ptr<Flow_sample>> samples;
  std::unique_ptr<Flow_sample>& sample = samples[size];
  if(!sample) sample = std::make_unique<Flow_sample>(make(static_cast<std::size_t>(size)));
  return *sample;
}

// A tangled unknot at the beginning of its flow: strands here and there, few of which touch.
inline const Flow_sample& tangled_unknot(std::int64_t nodes_of_input)
{
  return remembered_sample(nodes_of_input, [](std::size_t n) {
    return Flow_sample(vfc::make_hard_unknot(n, 10 * n, /*seed*/ 1), 10);
  });
}

// The torus knot T(p, p + 1), nearly tight: all strands touch others.
inline const Flow_sample& tight_torus_knot(std::int64_t p)
{
  return remembered_sample(p, [](std::size_t size) {
    const int turns = static_cast<int>(size);
    return Flow_sample(vfc::make_torus_knot(turns, turns + 1, 100 * size * size), 30 + 10 * turns);
  });
}

// Adds the number of nodes and the time per node to the figures.
inline void count_nodes(benchmark::State& state, const Flow_sample& sample)
{
  using benchmark::Counter;
  const auto n = static_cast<double>(sample.curve.number_of_nodes());
  state.counters["nodes"] = n;
  state.counters["per_node"] = Counter(n, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_FLOW_SAMPLE_H
