// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Node_columns.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/curve/Origin_interpolation.h>

#include <cstddef>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using Network = curves::Curve_network_3<>;

// The number of the vertex in the input; between two of them the first one's number and how far it
// is to the next.
Node_column origin_column(const Network& curve)
{
  Node_column column{"origin", {}};
  const curves::internal::Origin_interpolation<Network> interpolation(curve); // has the origins
  for(const curves::Curve_origin& origin : interpolation.origins()) {
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

Node_column component_column(const Network& curve)
{
  Node_column column{"component", {}, true};
  for(const std::size_t v : curve.nodes())
    column.values.push_back(static_cast<double>(curve.component(v)));
  return column;
}

} // namespace

Node_columns node_columns(const Network& curve)
{
  return {
      origin_column(curve), component_column(curve), {"curvature", curves::node_curvatures(curve)}};
}

} // namespace vfc
