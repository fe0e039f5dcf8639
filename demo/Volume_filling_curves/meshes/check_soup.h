// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CHECK_SOUP_H
#define VFC_CHECK_SOUP_H

#include "meshes/Mesh_findings.h"
#include "meshes/Mesh_soup.h"

namespace vfc {

// Check of single points and triangles, which merges equal points and drops points without a face.
// Degenerate triangles are errors, and are removed for subsequent checks. All decisions are exact.
// O(n log n).
void check_soup(Mesh_soup& soup, Mesh_findings& findings);

} // namespace vfc

#endif // VFC_CHECK_SOUP_H
