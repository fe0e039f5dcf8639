// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PINS_H
#define VFC_PINS_H

#include "files/curve_files.h"
#include "options/shared_options.h"

#include <string>

namespace vfc {

// Pins the nodes that the option --pin lists: "ends", or numbers from 1 in file order, or both,
// separated by commas. Pinned nodes stay pinned. \throws Usage_error
// \pre the list is not empty
void pin_nodes(Curve& curve, const std::string& list);

// Pins the nodes of the options, and the ends of open curves unless they are free.
void pin_nodes(Curve& curve, const Curve_options& options);

} // namespace vfc

#endif // VFC_PINS_H
