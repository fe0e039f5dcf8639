// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/pins.h"

#include "options/lists.h"
#include "options/numbers.h"

#include <cstddef>
#include <string>
#include <unordered_map>

namespace vfc {
namespace {

using Node_of_number = std::unordered_map<unsigned long long, std::size_t>;

Node_of_number nodes_by_number(const Curve& curve)
{
  Node_of_number node_of_number;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) node_of_number[curve.origin(v) + 1] = v;
  return node_of_number;
}

std::size_t find_node(const Node_of_number& node_of_number, const std::string& text)
{
  unsigned long long number = 0;
  if(!parse(text, number) || number == 0)
    throw Usage_error("--pin: '" + text + "' is neither 'ends' nor the number of a node, from 1");
  const auto found = node_of_number.find(number);
  if(found == node_of_number.end()) throw Usage_error("--pin: the curve has no node " + text);
  return found->second;
}

} // namespace

void pin_nodes(Curve& curve, const std::string& list)
{
  const Node_of_number node_of_number = nodes_by_number(curve);
  for(const std::string& item : items_of_list(list)) {
    if(item == "ends")
      curve.pin_ends();
    else
      curve.set_pinned(find_node(node_of_number, item));
  }
}

void pin_nodes(Curve& curve, const Curve_options& options)
{
  if(!options.pin.empty()) pin_nodes(curve, options.pin);
  if(!options.has_free_ends) curve.pin_ends();
}

} // namespace vfc
