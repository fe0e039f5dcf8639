// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_NODE_COLUMNS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_NODE_COLUMNS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Origin_interpolation.h>
#include <CGAL/Volume_filling_curves/internal/curve/turning.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The columns of a file: values of each node beside its position.
struct Node_column
{
  std::string name;
  std::vector<double> values;
  bool has_integers = false;
};

using Node_columns = std::vector<Node_column>;

// The place in the input, as the number of its vertex; between two of them the first one's number
// and how far it is to the next. -1 beyond the ends of the input.
template <typename Network>
Node_column origin_column(const Network& curve)
{
  Node_column column{"origin", {}};
  const Origin_interpolation<Network> interpolation(curve); // which owns the origins
  for(const Curve_origin& origin : interpolation.origins()) {
    const std::size_t vertex = curve.origin(column.values.size());
    if(vertex != Network::null_node())
      column.values.push_back(static_cast<double>(vertex));
    else if(origin.source != Network::null_node())
      column.values.push_back(static_cast<double>(origin.source) + origin.parameter);
    else
      column.values.push_back(-1);
  }
  return column;
}

template <typename Network>
Node_column component_column(const Network& curve)
{
  Node_column column{"component", {}, true};
  for(const std::size_t v : curve.nodes())
    column.values.push_back(static_cast<double>(curve.component(v)));
  return column;
}

// Columns of the curve itself first, then those of the caller.
template <typename Network>
Node_columns node_columns(const Network& curve, const Node_values& values)
{
  Node_columns columns = {
      origin_column(curve), component_column(curve), {"curvature", node_curvatures(curve)}};
  for(const auto& [name, of_nodes] : values) columns.push_back({name, of_nodes});
  return columns;
}

inline bool is_column_name(std::string_view name)
{
  static constexpr std::array<std::string_view, 7> taken = {
      "x", "y", "z", "origin", "component", "curvature", "pinned"};
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_fit = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_fit) &&
         std::find(taken.begin(), taken.end(), name) == taken.end();
}

// returns whether the values can be written: one for each node, finite, under a name that is free
template <typename Network>
bool are_node_values(const Network& curve, const Node_values& values)
{
  const auto is_finite = [](double x) { return std::isfinite(x); };
  return std::all_of(values.begin(), values.end(), [&](const auto& column) {
    const auto& [name, of_nodes] = column;
    return is_column_name(name) && of_nodes.size() == curve.number_of_nodes() &&
           std::all_of(of_nodes.begin(), of_nodes.end(), is_finite);
  });
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_NODE_COLUMNS_H
