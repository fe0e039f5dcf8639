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
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Throws std::invalid_argument unless all shares are positive, and given for curves or arcs to a
// tree of fingers that heeds them.
template <typename Point_3>
void check_volume_shares(const Filling_parameters<Point_3>& parameters, bool has_curves)
{
  const auto& shares = parameters.volume_shares;
  for(std::size_t c = 0; c < shares.size(); ++c)
    if(!(shares[c] > 0 && std::isfinite(shares[c])))
      refuse_value(internal_np::volume_shares_t(), shares[c],
                   "the share of component " + std::to_string(c) + " must be positive and finite");
  if(!shares.empty() && parameters.start != Filling_start::TREE)
    throw std::invalid_argument("volume_shares: only fingers divide the volume, see "
                                "Filling_start::TREE");
  if(!shares.empty() && !has_curves && parameters.ports.empty())
    throw std::invalid_argument("volume_shares: there are neither curves nor ports, and a single "
                                "curve fills each connected part of the domain");
}

// Throws std::invalid_argument unless there is a share for each component, or none at all.
inline void check_number_of_shares(const std::vector<double>& shares, std::size_t components)
{
  if(!shares.empty() && shares.size() != components)
    throw std::invalid_argument("volume_shares: the number of shares is " +
                                std::to_string(shares.size()) + ", but that of components is " +
                                std::to_string(components));
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_CHECK_VOLUME_SHARES_H
