// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CUTS_H
#define VFC_CUTS_H

#include "pictures/Drawn_curve.h"
#include "pictures/Half_space.h"
#include "pictures/Triangle_soup.h"

#include <array>
#include <cstddef>
#include <vector>

namespace vfc {

// Keeps the part in the half-space; strands that are cut get new ends.
void cut(Drawn_curve& curve, const Half_space& half_space);

// Surface after a cut, and the edges along the cut. For a closed surface these form loops around
// its inside, oriented like the faces of the removed part.
struct Cut_surface
{
  Triangle_soup soup;
  std::vector<std::array<std::size_t, 2>> rim;
};

Cut_surface cut(const Triangle_soup& surface, const Half_space& half_space);

} // namespace vfc

#endif // VFC_CUTS_H
