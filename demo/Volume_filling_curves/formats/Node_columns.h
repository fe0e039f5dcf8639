// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_NODE_COLUMNS_H
#define VFC_NODE_COLUMNS_H

#include <CGAL/Volume_filling_curves/Curve_network_3.h>

#include <string>
#include <vector>

namespace vfc {

// Column of a file: a value of each node beside its position, for programs that color curves.
struct Node_column
{
  std::string name;
  std::vector<double> values;
  bool has_integers = false;
};

using Node_columns = std::vector<Node_column>;

// Returns the columns of every curve: its origin in the input, -1 beyond the ends of the input;
// its component; and its curvature.
Node_columns node_columns(const CGAL::Volume_filling_curves::Curve_network_3<>& curve);

} // namespace vfc

#endif // VFC_NODE_COLUMNS_H
