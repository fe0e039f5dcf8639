// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_VOLUME_SHARES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_VOLUME_SHARES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws std::invalid_argument unless there is a positive share for each component, and a tree of
// fingers that heeds them, or no share at all.
template <typename Point_3>
void check_volume_shares(const Filling_parameters<Point_3>& parameters, std::size_t components)
{
  const auto& shares = parameters.volume_shares;
  if(shares.empty()) return;
  if(shares.size() != components)
    throw std::invalid_argument("volume_shares: the number of shares is " +
                                std::to_string(shares.size()) + ", but that of components is " +
                                std::to_string(components));
  for(std::size_t c = 0; c < components; ++c)
    if(!(shares[c] > 0 && std::isfinite(shares[c])))
      refuse_value(internal_np::volume_shares_t(), shares[c],
                   "the share of component " + std::to_string(c) + " must be positive and finite");
  if(parameters.start != Filling_start::TREE)
    throw std::invalid_argument("volume_shares: only fingers divide the volume, see "
                                "Filling_start::TREE");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_VOLUME_SHARES_H
