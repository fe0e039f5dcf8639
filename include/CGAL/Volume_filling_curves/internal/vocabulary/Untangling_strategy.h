// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_STRATEGY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_STRATEGY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The method of untangling.
enum class Untangling_strategy
{
  FLOW,   ///< the flow alone, a continuous motion of all nodes
  SEARCH, ///< a random search for a polygon with as few edges as possible
  AUTO    ///< the search first, and then the flow to an even, smooth shape
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "flow".
inline const char* to_string(Untangling_strategy strategy)
{
  switch(strategy) {
  case Untangling_strategy::FLOW:
    return "flow";
  case Untangling_strategy::SEARCH:
    return "search";
  case Untangling_strategy::AUTO:
    return "auto";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Untangling_strategy strategy)
{
  return out << to_string(strategy);
}

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// The progress of a random search.
struct Search_progress
{
  std::size_t sweeps = 0; ///< the number of sweeps, which are a hundred attempted moves per edge
  std::size_t moves = 0;  ///< the number of attempted moves
  std::size_t edges = 0;  ///< the fewest edges found so far
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_STRATEGY_H
