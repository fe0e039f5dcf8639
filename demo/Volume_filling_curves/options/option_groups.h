// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OPTION_GROUPS_H
#define VFC_OPTION_GROUPS_H

#include <CLI/CLI.hpp>

namespace vfc {

// Puts the options of a command that few users need into groups, which only --help-all shows.
void group_options(CLI::App& command);

} // namespace vfc

#endif // VFC_OPTION_GROUPS_H
