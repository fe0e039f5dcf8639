// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/ports.h"

#include "meshes/vertex_values.h"
#include "options/numbers.h"
#include "session/errors.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstddef>
#include <sstream>

namespace vfc {
namespace {

// Returns the index of the n-th comma, or npos.
std::size_t comma(const std::string& text, int n)
{
  std::size_t k = text.find(',');
  while(--n > 0 && k != std::string::npos) k = text.find(',', k + 1);
  return k;
}

} // namespace

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

std::vector<double> read_volume_shares(const std::string& text)
{
  std::vector<double> shares;
  if(text.empty()) return shares;
  std::istringstream numbers(text + ',');
  for(std::string number; std::getline(numbers, number, ',');)
    if(!parse(number, shares.emplace_back()) || !(shares.back() > 0))
      throw Usage_error("--volume-shares: '" + number + "' is not a positive number");
  return shares;
}

Ports read_ports(const std::vector<std::string>& texts)
{
  Ports ports;
  for(const std::string& text : texts) {
    const std::size_t end = comma(text, 3);
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
