// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles curves, one JSON line per run on standard output:
//
//   benchmark_untangle [option...] FILE [[option...] FILE...]
//
//   --jitter SEED    move every coordinate by up to 1e-5 of the box diagonal
//   --rotate SEED, --mirror, --scale X, --translate X (times the box diagonal)
//   --iterations N   at most so many (5000)
//   --finish         go on after a proof until the curve is tight, and lower the ropelength
//   --thickness R    in the input's unit
//   --repeat N       runs of every file (1)
//   --threads N      (1)
//   -o DIR           write each start and end to DIR/NAME.start.obj and DIR/NAME.end.obj
//   --reset          forget all options that stand before
//
// Options hold for the files after them. The seconds are those of the call of untangle(): reading
// and measuring curves does not count. Ends of open curves are pinned, all else is as by default.

#include "Curve_transformation.h"
#include "Json_line.h"
#include "Stage_profile.h"
#include "command_words.h"
#include "read_curve.h"
#include "surroundings.h"

#include <CGAL/Volume_filling_curves/IO/curve_network.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/Real_timer.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace vfc = CGAL::Volume_filling_curves;
using vfc_benchmark::Curve;
using vfc_benchmark::Json_line;

struct Options
{
  vfc_benchmark::Curve_transformation transformation;
  std::size_t iterations = 5000, repeat = 1, threads = 1;
  bool is_finished = false;
  double thickness = 0;
  std::string directory;
};

void write_curve(const Options& options,
                 const std::string& file,
                 const std::string& when,
                 const Curve& curve)
{
  if(options.directory.empty()) return;
  const std::filesystem::path name = std::filesystem::path(file).stem().string() + when + ".obj";
  const std::string path = (std::filesystem::path(options.directory) / name).string();
  if(!CGAL::IO::write_curve_network(path, curve)) throw std::runtime_error("cannot write " + path);
}

template <typename ConcurrencyTag>
vfc::Untangling_result untangle(Curve& curve,
                                const Options& options,
                                vfc_benchmark::Stage_profile& profile)
{
  return vfc::untangle<ConcurrencyTag>(curve, vfc::parameters::visitor(std::ref(profile))
                                                  .strategy(vfc::Untangling_strategy::FLOW)
                                                  .thickness(options.thickness)
                                                  .number_of_iterations(options.iterations)
                                                  .stop_at_proof(!options.is_finished)
                                                  .lower_ropelength(options.is_finished));
}

vfc::Untangling_result untangle_with_threads(Curve& curve,
                                             const Options& options,
                                             vfc_benchmark::Stage_profile& profile)
{
  if(options.threads == 1) return untangle<CGAL::Sequential_tag>(curve, options, profile);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
  return untangle<CGAL::Parallel_tag>(curve, options, profile);
#else
  throw std::runtime_error("more than one thread needs TBB");
#endif
}

void add_work(Json_line& line, const vfc::Untangling_result& result)
{
  line.add("status", to_string(result.status))
      .add("link", to_string(result.link))
      .add("iterations", result.statistics.iterations)
      .add("shortened_steps", result.statistics.shortened_steps)
      .add("refused_remeshing", result.statistics.refused_remeshing)
      .add("thickness", result.thickness)
      .add("gradient_norm", result.gradient_norm);
}

void add_shapes(Json_line& line, const Curve& start, const Curve& end)
{
  line.add("nodes_start", start.number_of_nodes())
      .add("nodes_end", end.number_of_nodes())
      .add("length_start", vfc::length(start))
      .add("length_end", vfc::length(end))
      .add("ropelength", vfc::ropelength(end))
      .add("average_crossing_number", vfc::average_crossing_number(end))
      .add("linking_matrix_start", vfc::linking_matrix(start))
      .add("linking_matrix", vfc::linking_matrix(end));
}

void run(const std::string& file, const Options& options)
{
  const Curve start = options.transformation(vfc_benchmark::read_curve(file));
  Curve curve = start;
  CGAL::Real_timer timer;
  timer.start();
  const double cpu_start = vfc_benchmark::cpu_seconds();
  vfc_benchmark::Stage_profile profile;
  const vfc::Untangling_result result = untangle_with_threads(curve, options, profile);
  const double cpu = vfc_benchmark::cpu_seconds() - cpu_start, wall = timer.time();
  write_curve(options, file, ".start", start);
  write_curve(options, file, ".end", curve);

  Json_line line;
  line.add("file", file).add("transformation", options.transformation.description());
  add_work(line, result);
  line.add("cpu_seconds", cpu).add("wall_seconds", wall);
  line.add("setup_seconds", profile.setup_seconds()).add("threads", options.threads);
  if(result.statistics.iterations > 0)
    line.add("mean_number_of_nodes", profile.mean_number_of_nodes())
        .add("microseconds_per_node_and_iteration", profile.microseconds_per_node());
  add_shapes(line, start, curve);
  vfc_benchmark::add_surroundings(line);
  std::cout << line.str() << std::endl;
}

// Reads one option, with its value if it has one, and returns whether it was one.
bool read_option(Options& options, const vfc_benchmark::Words& words, std::size_t& k)
{
  const std::string& word = words[k];
  const auto value = [&] { return vfc_benchmark::value_of_option(words, k); };
  vfc_benchmark::Curve_transformation& transformation = options.transformation;
  if(word == "--jitter")
    transformation.jitter_seed = std::stoul(value());
  else if(word == "--rotate")
    transformation.rotation_seed = std::stoul(value());
  else if(word == "--mirror")
    transformation.is_mirrored = true;
  else if(word == "--scale")
    transformation.scale = std::stod(value());
  else if(word == "--translate")
    transformation.translation = std::stod(value());
  else if(word == "--iterations")
    options.iterations = std::stoul(value());
  else if(word == "--finish")
    options.is_finished = true;
  else if(word == "--thickness")
    options.thickness = std::stod(value());
  else if(word == "--repeat")
    options.repeat = std::stoul(value());
  else if(word == "--threads")
    options.threads = std::stoul(value());
  else if(word == "-o")
    options.directory = value();
  else if(word == "--reset")
    options = Options();
  else if(word.rfind('-', 0) == 0)
    throw std::runtime_error("unknown option " + word);
  else
    return false;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  return vfc_benchmark::run_words(
      argc, argv, [&](const auto& words, std::size_t& k) { return read_option(options, words, k); },
      [&](const std::string& file) {
        for(std::size_t i = 0; i < options.repeat; ++i) run(file, options);
      });
}
