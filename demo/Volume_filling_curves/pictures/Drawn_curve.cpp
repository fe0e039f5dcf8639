// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Drawn_curve.h"

namespace vfc {

Drawn_curve::Drawn_curve(const Curve& curve, const Curve_view& view, const Edge_values& values)
    : strands(strands_of(curve)), width(view.width())
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
    points.push_back(view.point(v));
    numbers.push_back(curve.origin(v) + 1);
    if(curve.degree(v) != 2) ends.push_back(v);
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    edges.push_back({curve.source(e), curve.target(e), values[e]});
}

} // namespace vfc
