// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "session/errors.h"

#include "session/Console.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace vfc {
namespace {

const Defect& first_error_of(const Defects& defects)
{
  return *std::find_if(defects.begin(), defects.end(),
                       [](const Defect& defect) { return defect.is_error; });
}

} // namespace

Input_error::Input_error(Defects defects, const std::string& expected)
    : std::runtime_error(first_error_of(defects).file + " is not " + expected),
      m_defects(std::move(defects))
{}

const Defect& Input_error::first_error() const
{
  return first_error_of(m_defects);
}

void print_defects(const Console& console, const Defects& defects)
{
  constexpr std::size_t max_lines = 10;                               // of each kind
  std::map<std::pair<std::string, std::string>, std::size_t> numbers; // by file and kind
  for(const Defect& defect : defects)
    if((defect.is_error || !console.is_quiet()) &&
       ++numbers[{defect.file, defect.kind}] <= max_lines)
      console.print(defect.text + '\n');
  for(const auto& [name, number] : numbers)
    if(number > max_lines)
      console.print(name.first + ": " + name.second + ": and " +
                    std::to_string(number - max_lines) + " more\n");
}

} // namespace vfc
