// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/ports.h"

#include "meshes/vertex_values.h"
#include "options/lists.h"
#include "session/errors.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstddef>

namespace vfc {

CLI::Option& add_port_option(CLI::App& command, std::vector<std::string>& texts)
{
  return *command
              .add_option("--port", texts,
                          "a point at the surface where the curve enters, along the inward normal "
                          "or NX,NY,NZ, and stays straight for about r; an arc leads from the "
                          "first port to the second, from the third to the fourth, and so on")
              ->expected(1)
              ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
              ->type_name("X,Y,Z[,NX,NY,NZ]");
}

Ports read_ports(const std::vector<std::string>& texts)
{
  Ports ports;
  for(const std::string& text : texts) {
    const std::size_t end = find_comma(text, 3);
    std::array<double, 3> place, direction{0, 0, 0};
    const bool is_read =
        parse_vector(text.substr(0, end), place) &&
        (end == std::string::npos || parse_vector(text.substr(end + 1), direction));
    if(!is_read) throw Usage_error("--port: " + text + ": is neither X,Y,Z nor X,Y,Z,NX,NY,NZ");
    ports.push_back({{place[0], place[1], place[2]}, direction});
  }
  if(ports.size() % 2 == 1)
    throw Usage_error("--port: there are " + std::to_string(ports.size()) +
                      ", but every arc needs two");
  return ports;
}

} // namespace vfc
