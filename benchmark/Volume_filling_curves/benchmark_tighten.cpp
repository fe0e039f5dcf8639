// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Brings curves to few edges by the random search, one JSON line per run on standard output:
//
//   benchmark_tighten [option...] FILE [[option...] FILE...]
//
//   --seeds N        runs of every file, with the seeds 0, ..., N - 1 (20)
//   --chains N       independent searches of which the best is taken (1)
//   --threads N      (1)
//   --time-limit S   of each run (60)
//   --temperature X, --clearance X, --step X, --removal X, --insertion X, --smoothing X, --patience X
//                    what the search is tuned with, see Tightening_parameters
//
// Options hold for the files after them. Seconds are those of the search and of the certified
// repetition of its moves by the guard: reading the curve does not count.

#include "Json_line.h"
#include "surroundings.h"

#include <CGAL/Volume_filling_curves/IO/polylines.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/Tightener.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
namespace internal = vfc::internal;
using Curve = vfc::Curve_network_3<>;
using Guard = vfc::Isotopy_guard_3<>;

struct Options
{
  internal::Tightening_parameters tightening;
  std::size_t seeds = 20, chains = 1, threads = 1;
  double time_limit = 60;
};

Curve read_curve(const std::string& file)
{
  Curve curve;
  std::vector<vfc::Curve_defect> defects;
  if(!CGAL::IO::read_curve_network(file, curve, defects))
    throw std::runtime_error(vfc::to_string(defects.front(), file));
  curve.pin_ends();
  return curve;
}

template <typename ConcurrencyTag>
void run(const std::string& file, const Curve& start, const Options& options, std::size_t seed)
{
  Curve curve = start;
  CGAL::Real_timer timer;
  timer.start();
  const double cpu_start = vfc_benchmark::cpu_seconds();
  Guard guard(curve);
  internal::Tightener<Guard, ConcurrencyTag> tightener(guard, options.tightening, options.chains,
                                                       seed);
  tightener.run([&] { return timer.time() < options.time_limit; });
  const double cpu_of_search = vfc_benchmark::cpu_seconds() - cpu_start;
  tightener.apply();
  guard.collect_garbage();
  const double cpu = vfc_benchmark::cpu_seconds() - cpu_start, wall = timer.time();

  vfc_benchmark::Json_line line;
  line.add("file", file).add("seed", seed).add("chains", options.chains);
  line.add("threads", options.threads).add("is_unknotted", tightener.has_reached_goal());
  line.add("nodes_start", start.number_of_nodes()).add("nodes_end", curve.number_of_nodes());
  line.add("moves", tightener.progress().moves).add("sweeps", tightener.progress().sweeps);
  line.add("certified_changes", guard.number_of_certified_changes());
  line.add("refused_changes", guard.number_of_refused_changes());
  line.add("cpu_seconds_of_search", cpu_of_search).add("cpu_seconds", cpu);
  line.add("wall_seconds", wall);
  vfc_benchmark::add_surroundings(line);
  std::cout << line.str() << std::endl;
}

void run_with_threads(const std::string& file, const Options& options)
{
  const Curve start = read_curve(file);
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

// Sets an option and returns whether there is one of that name.
bool set(Options& options, const std::string& name, const std::string& value)
{
  internal::Tightening_parameters& p = options.tightening;
  const std::map<std::string, double*> reals = {
      {"--time-limit", &options.time_limit}, {"--temperature", &p.temperature},
      {"--clearance", &p.clearance},         {"--step", &p.largest_step},
      {"--removal", &p.removal_rate},        {"--insertion", &p.insertion_rate},
      {"--smoothing", &p.smoothing_rate},    {"--patience", &p.patience_factor}};
  const std::map<std::string, std::size_t*> integers = {
      {"--seeds", &options.seeds}, {"--chains", &options.chains}, {"--threads", &options.threads}};
  if(reals.count(name) > 0)
    *reals.at(name) = std::stod(value);
  else if(integers.count(name) > 0)
    *integers.at(name) = std::stoul(value);
  else
    return false;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    Options options;
    for(std::size_t k = 0; k < words.size(); ++k) {
      if(words[k].rfind("--", 0) != 0) {
        run_with_threads(words[k], options);
        continue;
      }
      if(k + 1 == words.size()) throw std::runtime_error(words[k] + " needs a value");
      if(!set(options, words[k], words[k + 1])) throw std::runtime_error("unknown " + words[k]);
      ++k;
    }
    return 0;
  } catch(const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
