// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SURFACE_DISTANCE_H
#define VFC_SURFACE_DISTANCE_H

#include "meshes/Watched_points.h"

namespace vfc {

// Returns the greatest distance from points of one surface to another, over the vertices and some
// 10,000 random points, hence a lower bound. O((n + 10,000) log m) as a rule.
// \throws Work_stopped
double surface_distance(const Mesh& from, const Mesh& to, Work_watch& watch);

} // namespace vfc

#endif // VFC_SURFACE_DISTANCE_H
