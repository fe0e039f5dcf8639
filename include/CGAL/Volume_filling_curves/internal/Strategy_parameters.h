// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGY_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGY_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_strategy.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {

namespace internal {

// The strategy and what it takes.
struct Strategy_parameters
{
  Untangling_strategy strategy = Untangling_strategy::AUTO;
  std::size_t number_of_chains = 2;
  std::uint64_t seed = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STRATEGY_PARAMETERS_H
