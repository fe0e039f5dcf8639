// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_LENGTH_UNIT_H
#define VFC_LENGTH_UNIT_H

#include <CLI/CLI.hpp>

#include <string>

namespace vfc {

// Unit of a file's numbers, declared by the user. Numbers are never converted.
enum class Length_unit
{
  NONE,
  MILLIMETER,
  CENTIMETER,
  METER,
  INCH
};

// returns "mm", "cm", "m", "inch", or nothing
std::string to_string(Length_unit unit);

CLI::Option& add_unit_option(CLI::App& command, Length_unit& unit);

// Throws Usage_error if a unit is given for a file that cannot hold it.
void check_unit(Length_unit unit, const std::string& file);

} // namespace vfc

#endif // VFC_LENGTH_UNIT_H
