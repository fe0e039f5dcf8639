// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Brings curves to few edges by the random search, one JSON line per run on standard output:
//
//   benchmark_search [option...] FILE [[option...] FILE...]
//
//   --seeds N        runs of every file, with the seeds 0, ..., N - 1 (20)
//   --chains N       independent searches of which the best is taken (1)
//   --threads N      (1)
//   --time-limit S   of each run (60)
//   --temperature X, --clearance X, --step X, --removal X, --insertion X, --smoothing X,
//   --patience X
//                    what the search is tuned with, see Search_parameters
//
// Options hold for the files after them. Seconds are those of the search and of the certified
// repetition of its moves by the guard: reading the curve does not count.

#include "Json_line.h"
#include "command_words.h"
#include "read_curve.h"
#include "surroundings.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/polygon_search/Polygon_search.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
namespace internal = vfc::internal;
using Curve = vfc::Curve_network_3<>;
using Guard = vfc::Isotopy_guard_3<>;

struct Options
{
  internal::Search_parameters search;
  std::size_t seeds = 20, chains = 1, threads = 1;
  double time_limit = 60;
};

template <typename ConcurrencyTag>
void run(const std::string& file, const Curve& start, const Options& options, std::size_t seed)
{
  Curve curve = start;
  CGAL::Real_timer timer;
  timer.start();
  const double cpu_start = vfc_benchmark::cpu_seconds();
  Guard guard(curve);
  internal::Polygon_search<Guard, ConcurrencyTag> polygon_search(curve, options.search,
                                                                 options.chains, seed);
  polygon_search.run([&] { return timer.time() < options.time_limit; });
  const double cpu_of_search = vfc_benchmark::cpu_seconds() - cpu_start;
  polygon_search.apply(guard, [] { return true; });
  guard.collect_garbage();
  const double cpu = vfc_benchmark::cpu_seconds() - cpu_start, wall = timer.time();

  vfc_benchmark::Json_line line;
  line.add("file", file).add("seed", seed).add("chains", options.chains);
  line.add("threads", options.threads).add("is_unknotted", polygon_search.has_reached_goal());
  line.add("nodes_start", start.number_of_nodes()).add("nodes_end", curve.number_of_nodes());
  line.add("moves", polygon_search.progress().moves)
      .add("sweeps", polygon_search.progress().sweeps);
  line.add("certified_changes", guard.number_of_certified_changes());
  line.add("refused_changes", guard.number_of_refused_changes());
  line.add("cpu_seconds_of_search", cpu_of_search).add("cpu_seconds", cpu);
  line.add("wall_seconds", wall);
  vfc_benchmark::add_surroundings(line);
  std::cout << line.str() << std::endl;
}

void run_with_threads(const std::string& file, const Options& options)
{
  const Curve start = vfc_benchmark::read_curve(file);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
#else
  if(options.threads > 1) throw std::runtime_error("more than one thread needs TBB");
#endif
  for(std::size_t seed = 0; seed < options.seeds; ++seed) {
#ifdef CGAL_LINKED_WITH_TBB
    if(options.threads > 1) {
      run<CGAL::Parallel_tag>(file, start, options, seed);
      continue;
    }
#endif
    run<CGAL::Sequential_tag>(file, start, options, seed);
  }
}

// Reads one option, with its value, and returns whether it was one.
bool read_option(Options& options, const vfc_benchmark::Words& words, std::size_t& k)
{
  const std::string& name = words[k];
  if(name.rfind('-', 0) != 0) return false;
  internal::Search_parameters& p = options.search;
  const std::map<std::string, double*> reals = {
      {"--time-limit", &options.time_limit}, {"--temperature", &p.temperature},
      {"--clearance", &p.clearance},         {"--step", &p.max_step},
      {"--removal", &p.removal_rate},        {"--insertion", &p.insertion_rate},
      {"--smoothing", &p.smoothing_rate},    {"--patience", &p.patience_factor}};
  const std::map<std::string, std::size_t*> integers = {
      {"--seeds", &options.seeds}, {"--chains", &options.chains}, {"--threads", &options.threads}};
  if(reals.count(name) > 0)
    *reals.at(name) = std::stod(vfc_benchmark::value_of_option(words, k));
  else if(integers.count(name) > 0)
    *integers.at(name) = std::stoul(vfc_benchmark::value_of_option(words, k));
  else
    throw std::runtime_error("unknown option " + name);
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  return vfc_benchmark::run_words(
      argc, argv, [&](const auto& words, std::size_t& k) { return read_option(options, words, k); },
      [&](const std::string& file) { run_with_threads(file, options); });
}
