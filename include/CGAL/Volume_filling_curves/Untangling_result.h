// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_UNTANGLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_UNTANGLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How an untangling ended.
enum class Untangling_status
{
  CONVERGED,  ///< the gradient is below the tolerance; the curve is tight, not necessarily simple
  UNKNOTTED,  ///< every component is a proved unknot and, if there are several, the link is trivial
  LIMIT,      ///< the limit of iterations or of time was reached
  STALLED,    ///< neither the length nor the gradient got anywhere any more
  INTERRUPTED ///< the visitor asked to stop
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// Why a closed component is known to be an unknot.
enum class Unknot_proof
{
  NONE,           ///< it is not known
  EDGES,          ///< it has at most 5 edges
  TOTAL_CURVATURE ///< its total curvature is below 4 pi
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What is known about a link.
enum class Link_status
{
  NOT_A_LINK, ///< there is a single component, or one that is not closed
  TRIVIAL,    ///< it is proved that the link is trivial: an unlink of unknots
  LINKED,     ///< two components have a nonzero linking number
  UNDECIDED   ///< neither was found
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What `untangle()` returns. Whatever the status, the curve is ambient isotopic to the input.
struct Untangling_result
{
  Untangling_status status = Untangling_status::LIMIT; ///< how the run ended
  std::vector<Unknot_proof> proofs;                    ///< one per component
  Link_status link = Link_status::NOT_A_LINK;          ///< whether the components are linked
  double thickness = 0;                                ///< r, in the input's unit
  double gradient_norm = 0;         ///< at the end, see `Curve_flow_3::gradient_norm()`
  Curve_flow_statistics statistics; ///< the work; of all flows if there were several
  std::size_t tightenings = 0;      ///< how often it was tightened; after each jam once more
  std::size_t sweeps = 0;           ///< of all tightenings, see `Tightening_progress`
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_UNTANGLING_RESULT_H
