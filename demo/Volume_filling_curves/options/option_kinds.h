// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OPTION_KINDS_H
#define VFC_OPTION_KINDS_H

#include "files/curve_files.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vfc {

// Adds options by the kinds of their values.

// Options and arguments with a text or the name of a file, which is not empty.
CLI::Option& add_text(CLI::App& command,
                      const std::string& name,
                      std::string& text,
                      const std::string& description);
CLI::Option& add_file(CLI::App& command,
                      const std::string& name,
                      std::string& file,
                      const std::string& description);
CLI::Option& add_curve(CLI::App& command, std::string& file);
CLI::Option& add_curves(CLI::App& command, std::vector<std::string>& files);
CLI::Option& add_mesh(CLI::App& command, std::string& file);
CLI::Option& add_obstacle_option(CLI::App& command, std::vector<std::string>& files);
CLI::Option& add_curve_output(CLI::App& command, std::string& file);

void add_reading_flags(CLI::App& command, Curve_reading& reading);

// Range of the numbers that an option takes, both ends included. Ratios far from 1 are typing
// errors, and beyond these ends their products with lengths would overflow or be lost to rounding.
struct Range
{
  double least, most;
};
constexpr Range positive = {(std::numeric_limits<double>::min)(),
                            (std::numeric_limits<double>::max)()};
constexpr Range not_negative = {0, (std::numeric_limits<double>::max)()};
constexpr Range positive_ratio = {1e-9, 1e6};
constexpr Range positive_share = {1e-9, 1};
constexpr Range ratio = {0, 1e6};

// Options with a number, which refuse anything else with an error that names them.
CLI::Option& add_number(CLI::App& command,
                        const std::string& name,
                        double& number,
                        const std::string& description,
                        Range range = positive);
CLI::Option& add_whole_number(CLI::App& command,
                              const std::string& name,
                              std::size_t& number,
                              const std::string& description,
                              std::size_t least,
                              std::size_t most = std::numeric_limits<std::size_t>::max());

// Option whose value is one of several names; the first is the default.
template <typename Choice>
CLI::Option& add_choice(CLI::App& command,
                        const std::string& name,
                        Choice& choice,
                        const std::vector<std::pair<std::string, Choice>>& choices,
                        const std::string& description)
{
  const std::map<std::string, Choice> by_name(choices.begin(), choices.end());
  const auto set = [&choice, by_name](const std::string& text) { choice = by_name.at(text); };
  return *command.add_option_function<std::string>(name, set, description)
              ->check(CLI::IsMember(by_name).description(""))
              ->default_str(choices.front().first)
              ->type_name("NAME");
}

} // namespace vfc

#endif // VFC_OPTION_KINDS_H
