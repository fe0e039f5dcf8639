// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_POLISHING_RECORD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_POLISHING_RECORD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Progress of polishing: the fractions of the nodes at which a limit is exceeded, before the first
// step and after each that moves the curve.
struct Polishing_record
{
  std::vector<double> fractions;

  void add(std::size_t exceeding_nodes, std::size_t nodes)
  {
    fractions.push_back(
        nodes > 0 ? static_cast<double>(exceeding_nodes) / static_cast<double>(nodes) : 0);
  }

  double last() const { return fractions.empty() ? 0 : fractions.back(); }
  bool is_done() const { return last() == 0; }

  // Whether the domain has no room for the limits: after the last step more than a twentieth of the
  // nodes still exceed them, and more than half as many as before it. In 108 fillings between ports
  // the first step leaves at most 4 %; in six meshes with walls too thin for the thickness 34 to
  // 70 %, in a plate 1.8 r thick 17 of 22 %. Without this rule the plate took 25 s instead of 2 s,
  // and five of the meshes, polished further and loosened, were filled to 31 instead of 77 %
  // (2026-11-27).
  bool are_limits_out_of_reach() const
  {
    constexpr double many = 0.05, remainder = 0.5;
    const std::size_t n = fractions.size();
    return n > 1 && last() > many && last() > remainder * fractions[n - 2];
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_POLISHING_RECORD_H
