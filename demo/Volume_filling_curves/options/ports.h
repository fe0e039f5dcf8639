// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PORTS_H
#define VFC_PORTS_H

#include "files/curve_files.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace vfc {

using Ports = std::vector<CGAL::Volume_filling_curves::Port<Curve::Point_3>>;

CLI::Option& add_port_option(CLI::App& command, std::vector<std::string>& texts);

// Reads "X,Y,Z" or "X,Y,Z,NX,NY,NZ". \throws Usage_error
Ports read_ports(const std::vector<std::string>& texts);

} // namespace vfc

#endif // VFC_PORTS_H
