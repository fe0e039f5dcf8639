// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_MAP_H
#define VFC_CURVE_MAP_H

#include "files/curve_files.h"

#include <string>

namespace vfc {

// Writes the numbers that the nodes of a result had in the input, in the order of the result's
// file, unless the name of the map is empty. \throws Usage_error
void write_map(const std::string& map, const std::string& output, const Curve& curve);

} // namespace vfc

#endif // VFC_CURVE_MAP_H
