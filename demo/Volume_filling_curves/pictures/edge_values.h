// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_EDGE_VALUES_H
#define VFC_EDGE_VALUES_H

#include "pictures/Picture_options.h"

#include <array>
#include <vector>

namespace vfc {

// Color values of each edge of a curve, at its source and its target.
using Edge_values = std::vector<std::array<double, 2>>;

// Returns the values of a coloring. COMPONENT: the number of the component, from 0. ARCLENGTH: the
// length along the component, from its first node. CURVATURE: the reciprocal of the bend radius, 0
// at ends and junctions. RADIUS: the mean of the node's medial radii, each capped at twice the
// curve's default thickness. THICKNESS: the least of these radii, which is that of the thickest
// tube that neither kinks there nor meets another strand (Gonzalez and Maddocks 1999). \throws
// Usage_error for the arclength of a component with a junction
Edge_values edge_values(const Curve& curve, Coloring coloring);

} // namespace vfc

#endif // VFC_EDGE_VALUES_H
