// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_IS_CLOSED_AND_ORIENTED_H
#define VFC_IS_CLOSED_AND_ORIENTED_H

#include "meshes/Mesh_soup.h"

namespace vfc {

// Returns whether the faces around each vertex form one cycle with consistent orientation: the
// surface is closed, and does not touch itself in an edge or vertex. Takes a tenth of the time of
// CGAL's test, which orients the faces.
bool is_closed_and_oriented(const Mesh_soup& soup);

} // namespace vfc

#endif // VFC_IS_CLOSED_AND_ORIENTED_H
