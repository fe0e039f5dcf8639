// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_FILLING_OPTIONS_H
#define VFC_BENCHMARK_FILLING_OPTIONS_H

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "Json_line.h"
#include "command_words.h"

namespace vfc_benchmark {

namespace vfc = CGAL::Volume_filling_curves;

// What a filling is asked for, and what is to be done with it.
struct Filling_options
{
  vfc::Filling_parameters<> parameters;
  double until_length = 0; // of the flow alone: it ends when the curve is that long
  std::size_t repeat = 1;
  bool is_flow_alone = false;
  std::string directory;
};

inline const std::vector<std::string>& names(vfc::Wall)
{
  static const std::vector<std::string> result = {"cover", "keep-clear"};
  return result;
}

inline const std::vector<std::string>& names(vfc::Preconditioner)
{
  static const std::vector<std::string> result = {"medial", "h1", "l2", "quasi-newton"};
  return result;
}

template <typename Enum>
Enum value_of_name(const std::string& name)
{
  const std::vector<std::string>& all = names(Enum());
  const auto found = std::find(all.begin(), all.end(), name);
  if(found == all.end()) throw std::runtime_error("unknown name " + name);
  return static_cast<Enum>(found - all.begin());
}

template <typename Enum>
const std::string& name_of_value(Enum value)
{
  return names(value)[static_cast<std::size_t>(value)];
}

// The options that have a value.
inline std::map<std::string, std::function<void(const std::string&)>> setters(Filling_options& o)
{
  const auto real = [](double& x) { return [&x](const std::string& s) { x = std::stod(s); }; };
  const auto count = [](auto& x) { return [&x](const std::string& s) { x = std::stoul(s); }; };
  return {
      {"--thickness", real(o.parameters.thickness)},
      {"--length", real(o.parameters.length)},
      {"--lambda", real(o.parameters.screening)},
      {"--rmax", real(o.parameters.max_radius)},
      {"--spacing", real(o.parameters.spacing)},
      {"--beta", real(o.parameters.coupling)},
      {"--alpha", real(o.parameters.medial_weight)},
      {"--tau", real(o.parameters.time_step)},
      {"--displacement", real(o.parameters.max_displacement)},
      {"--until-length", real(o.until_length)},
      {"--time-limit", real(o.parameters.time_limit)},
      {"--directions", count(o.parameters.number_of_directions)},
      {"--iterations", count(o.parameters.number_of_iterations)},
      {"--repeat", count(o.repeat)},
      {"--seed", count(o.parameters.random_seed)},
      {"--wall", [&o](const std::string& s) { o.parameters.wall = value_of_name<vfc::Wall>(s); }},
      {"--preconditioner",
       [&o](const std::string& s) {
         o.parameters.preconditioner = value_of_name<vfc::Preconditioner>(s);
       }},
      {"-o", [&o](const std::string& s) { o.directory = s; }}};
}

// Reads one option, with its value if it has one, and returns whether it was one.
inline bool read_option(Filling_options& options,
                        const std::vector<std::string>& words,
                        std::size_t& k)
{
  const std::string& word = words[k];
  if(word == "--flow-alone") return options.is_flow_alone = true;
  if(word == "--preview") {
    options.parameters.round_bends = false;
    return true;
  }
  if(word == "--reset") {
    options = Filling_options();
    return true;
  }
  const auto all = setters(options);
  const auto found = all.find(word);
  if(found == all.end()) {
    if(word.rfind('-', 0) == 0) throw std::runtime_error("unknown option " + word);
    return false;
  }
  found->second(value_of_option(words, k));
  return true;
}

inline void add_options(Json_line& line, const Filling_options& options)
{
  const vfc::Curve_flow_parameters& flow = options.parameters;
  line.add("flow_alone", options.is_flow_alone)
      .add("round", options.parameters.round_bends)
      .add("wall", name_of_value(flow.wall))
      .add("preconditioner", name_of_value(flow.preconditioner))
      .add("lambda", flow.screening)
      .add("rmax", flow.max_radius)
      .add("spacing", flow.spacing)
      .add("beta", flow.coupling)
      .add("alpha", flow.medial_weight)
      .add("tau", flow.time_step)
      .add("directions", flow.number_of_directions)
      .add("seed", options.parameters.random_seed);
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_FILLING_OPTIONS_H
