// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Times steps of the flow of a crumpled unknot, a lattice polygon of N nodes, one JSON line per N:
//
//   benchmark_scaling [--steps K] [--threads N] N...
//
// Lattice polygons are equally dense whatever their size. The flow's own spacing makes some seven
// times as many nodes of them, then the number falls: the line has the mean.

#include "Json_line.h"
#include "Stage_profile.h"
#include "command_words.h"
#include "surroundings.h"

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/generators.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
using Curve = vfc::Curve_network_3<>;

template <typename ConcurrencyTag>
void run(std::size_t number_of_nodes, std::size_t number_of_steps, std::size_t threads)
{
  Curve curve = vfc::make_lattice_polygon(number_of_nodes, 1);
  const double cpu_start = vfc_benchmark::cpu_seconds();
  vfc_benchmark::Stage_profile profile;
  vfc::Isotopy_guard_3<> guard(curve);
  vfc::Curve_flow_3<Curve::Traits, vfc::Unbounded_domain_3<>, ConcurrencyTag> flow(guard);
  profile.on_start(flow);
  const double cpu_setup = vfc_benchmark::cpu_seconds();
  for(std::size_t k = 0; k < number_of_steps; ++k) {
    flow.step();
    profile.on_iteration(flow);
  }
  vfc_benchmark::Json_line line;
  line.add("nodes_of_the_input", number_of_nodes)
      .add("steps", number_of_steps)
      .add("threads", threads)
      .add("mean_number_of_nodes", profile.mean_number_of_nodes())
      .add("setup_cpu_seconds", cpu_setup - cpu_start)
      .add("cpu_seconds", vfc_benchmark::cpu_seconds() - cpu_setup)
      .add("shortened_steps", flow.statistics().shortened_steps)
      .add("microseconds_per_node_and_iteration", profile.microseconds_per_node());
  vfc_benchmark::add_surroundings(line);
  std::cout << line.str() << std::endl;
}

void run_with_threads(std::size_t number_of_nodes, std::size_t steps, std::size_t threads)
{
  if(threads == 1) return run<CGAL::Sequential_tag>(number_of_nodes, steps, threads);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  run<CGAL::Parallel_tag>(number_of_nodes, steps, threads);
#else
  throw std::runtime_error("more than one thread needs TBB");
#endif
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t steps = 20, threads = 1;
  const auto read_option = [&](const vfc_benchmark::Words& words, std::size_t& k) {
    const std::string& word = words[k];
    if(word != "--steps" && word != "--threads") return false;
    (word == "--steps" ? steps : threads) = std::stoul(vfc_benchmark::value_of_option(words, k));
    return true;
  };
  return vfc_benchmark::run_words(argc, argv, read_option, [&](const std::string& number) {
    run_with_threads(std::stoul(number), steps, threads);
  });
}
