// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLING_STRATEGY_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLING_STRATEGY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How curves are untangled.
enum class Untangling_strategy
{
  FLOW,    ///< by the flow alone, a continuous motion of all nodes: a film
  TIGHTEN, ///< by a random search for a polygon with as few edges as possible: an answer
  AUTO     ///< by the search first, and then by the flow to an even, smooth shape
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How far a random search has got.
struct Tightening_progress
{
  std::size_t sweeps = 0; ///< the number of times that a hundred moves per edge were tried
  std::size_t moves = 0;  ///< the number of moves that were tried
  std::size_t edges = 0;  ///< the fewest edges found so far
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLING_STRATEGY_H
