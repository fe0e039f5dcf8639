// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_EMBEDDED_POLYLINES_H
#define CGAL_VOLUME_FILLING_CURVES_IO_EMBEDDED_POLYLINES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_defect.h>
#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/IO/polylines.h>
#include <CGAL/Volume_filling_curves/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_format.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/draft_to_embedded_network.h>

#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a curve network from a file, and lists everything that is wrong with it, also where
 * edges meet.
 *
 * As `read_curve_network()`, with the same parameters, but the network is constructed only if it is
 * embedded (see `is_embedded()`). The time is \cgalBigO{n \log^2 n} for `n` vertices unless many
 * edges have intersecting bounding boxes.
 *
 * \return whether there is no error
 */
template <typename Traits>
bool read_embedded_curve_network(
    const std::string& filename,
    Volume_filling_curves::Curve_network_3<Traits>& network,
    std::vector<Volume_filling_curves::Curve_defect>& defects,
    Volume_filling_curves::Junctions junctions = Volume_filling_curves::Junctions::FORBIDDEN)
{
  namespace internal = Volume_filling_curves::internal;
  internal::Curve_draft draft = internal::read_curve_draft(filename, junctions);
  return internal::draft_to_embedded_network(draft, network, defects, junctions);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_EMBEDDED_POLYLINES_H
