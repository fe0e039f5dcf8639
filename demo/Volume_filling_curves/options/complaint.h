// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COMPLAINT_H
#define VFC_COMPLAINT_H

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace vfc {

// Returns the name closest to a typed one, by letters inserted, left out, replaced or swapped with
// the next; empty if more than a third of its letters would change.
std::string meant_name(const std::string& typed, const std::vector<std::string>& names);

// returns the message about arguments that the program cannot parse, with the name of the command
// or the option that was probably meant
std::string complaint(const CLI::ParseError& error,
                      const CLI::App& program,
                      const std::vector<std::string>& arguments);

} // namespace vfc

#endif // VFC_COMPLAINT_H
