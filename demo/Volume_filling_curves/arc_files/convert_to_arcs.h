// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CONVERT_TO_ARCS_H
#define VFC_CONVERT_TO_ARCS_H

#include "arc_files/Length_unit.h"
#include "files/curve_files.h"

#include <CLI/CLI.hpp>

#include <string>

namespace vfc {

// Options of the conversion to an arc spline, and of its output.
struct Arc_options
{
  bool is_wanted = false, is_uncertified_welcome = false;
  std::string domain; // a mesh, or empty
  Length_unit unit = Length_unit::NONE;
};

// Adds --arcs, and its own options.
CLI::Option& add_arc_options(CLI::App& command, Arc_options& options);

// Plans to write an arc spline, .csv, .step, .stp or .svg. \throws Usage_error
void plan_arc_files(Session& session, const Arc_options& options, const std::string& output);

// Writes the arc spline of a curve that was read from a file, and returns the exit status.
// \throws Input_error if it is not certified, unless this is allowed, and Usage_error if the format
// cannot represent it
int convert_to_arcs(Session& session,
                    const Arc_options& options,
                    const Curve& curve,
                    const std::string& file,
                    const std::string& output);

} // namespace vfc

#endif // VFC_CONVERT_TO_ARCS_H
