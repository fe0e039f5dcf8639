// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// How an untangling ended.
enum class Untangling_status
{
  CONVERGED, ///< the gradient got below the tolerance, and contacts and bends resist the pull of
             ///< the length; the curve is tight, not necessarily simple, and does not look like an
             ///< unknot by its Alexander polynomial
  UNKNOTTED, ///< every component is a proved unknot and, if there are several, the link is trivial
  LIMIT,     ///< the limit of iterations or of time was reached
  STALLED,   ///< the length, or the gradient, or what looks like an unknot got nowhere any more, or
             ///< the thickness is too small, see `Untangling_result::fitting_thickness`
  INTERRUPTED ///< the visitor asked to stop
};

/// \ingroup PkgVolumeFillingCurvesRef
///
/// returns the name in plain English, for example "unknotted".
inline const char* to_string(Untangling_status status)
{
  switch(status) {
  case Untangling_status::CONVERGED:
    return "converged";
  case Untangling_status::UNKNOTTED:
    return "unknotted";
  case Untangling_status::LIMIT:
    return "limit";
  case Untangling_status::STALLED:
    return "stalled";
  case Untangling_status::INTERRUPTED:
    return "interrupted";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Untangling_status status)
{
  return out << to_string(status);
}

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
/// returns the name in plain English, for example "total curvature".
inline const char* to_string(Unknot_proof proof)
{
  switch(proof) {
  case Unknot_proof::NONE:
    return "none";
  case Unknot_proof::EDGES:
    return "edges";
  case Unknot_proof::TOTAL_CURVATURE:
    return "total curvature";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Unknot_proof proof)
{
  return out << to_string(proof);
}

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
/// returns the name in plain English, for example "not a link".
inline const char* to_string(Link_status status)
{
  switch(status) {
  case Link_status::NOT_A_LINK:
    return "not a link";
  case Link_status::TRIVIAL:
    return "trivial";
  case Link_status::LINKED:
    return "linked";
  case Link_status::UNDECIDED:
    return "undecided";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesRef
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Link_status status)
{
  return out << to_string(status);
}

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/untangle.h
///
/// What `untangle()` returns. Whatever the status, the curve is ambient isotopic to the input.
struct Untangling_result
{
  Untangling_status status = Untangling_status::LIMIT; ///< how the run ended
  std::vector<Unknot_proof> proofs;                    ///< one per component
  Link_status link = Link_status::NOT_A_LINK;          ///< whether the components are linked
  bool is_round = false; ///< whether the curve is a regular polygon now
  /// Whether the ropelength was lowered until it hardly fell any more, which may have been at once;
  /// it may also have been lowered, but not that far. See
  /// `Untangling_parameters::lower_ropelength`.
  bool is_ropelength_lowered = false;
  bool is_input = false; ///< whether it is the input, which is tighter than what was found
  /// Whether every open component with pinned ends, closed as `untangle()` says, is known to have
  /// the knot type that it had. It is after a run that has converged; at a limit, strands may still
  /// be in the way of the closing lines.
  bool is_closure_kept = true;
  double thickness = 0; ///< r, in the input's unit
  /// A thickness that suits the curve, in the input's unit, where the flow has stalled since the
  /// given one is too small: the curve is smooth on that scale, but not tight. Otherwise 0.
  double fitting_thickness = 0;
  /// At the end, see `Curve_flow_3::gradient_norm()`; larger again where the ropelength was
  /// lowered. NaN if the run was stopped before it was known.
  double gradient_norm = 0;
  Curve_flow_statistics statistics; ///< the work; of all flows if there were several
  std::size_t searches = 0;         ///< for few edges: how often; after each jam once more
  std::size_t sweeps = 0;           ///< of all searches, see `Search_progress`
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H
