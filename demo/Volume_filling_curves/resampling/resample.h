// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RESAMPLE_H
#define VFC_RESAMPLE_H

#include "files/curve_files.h"

#include <cstddef>

namespace vfc {

// Difference of a resampled curve from its input. Lengths are in the input's unit.
struct Resampling
{
  double max_distance = 0;                 // between the two curves
  double min_spacing = 0, max_spacing = 0; // lengths of edges
  std::size_t number_of_kept_nodes = 0;    // that are in the way of a certified change, or pinned
};

// Replaces the nodes of a curve by evenly spaced ones on it, as close to the spacing as the length
// of each component allows. Ends, junctions and the first nodes of closed components stay. The
// guard certifies every change: where a strand would be crossed, nodes stay. Takes near-linear
// time. \throws std::invalid_argument if there would be more than 20 million nodes
Resampling resample(Curve& curve, double spacing);

} // namespace vfc

#endif // VFC_RESAMPLE_H
