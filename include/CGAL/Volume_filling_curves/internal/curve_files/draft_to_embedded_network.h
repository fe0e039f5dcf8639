// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_EMBEDDED_NETWORK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_EMBEDDED_NETWORK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Contact_checker.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_network.h>

#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The same as `draft_to_network()`, but no network starts with a self-contact.
template <typename Traits>
bool draft_to_embedded_network(Curve_draft& file,
                               Curve_network_3<Traits>& network,
                               std::vector<Curve_defect>& defects,
                               Junctions junctions)
{
  repair_and_check(file, junctions);
  if(file.is_complete && !file.edges.empty()) Contact_checker(file).run();
  return checked_draft_to_network(file, network, defects);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_DRAFT_TO_EMBEDDED_NETWORK_H
