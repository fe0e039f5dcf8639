// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/vocabulary/Bend_limits.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The outcome of untangling.
enum class Untangling_status
{
  CONVERGED, ///< the gradient is below the tolerance, and contacts and bends resist the tension;
             ///< the curve is tight, not necessarily simple, and its Alexander polynomial does not
             ///< suggest an unknot
  UNKNOTTED, ///< every component is a proved unknot and, if there are several, the link is trivial
  CONSTRAINT_NOT_REACHED, ///< like `CONVERGED` or `UNKNOTTED`, but the curve bends more tightly or
                          ///< has closer strands than required; see
                          ///< `Untangling_result::shape_excesses`
  LIMIT,                  ///< the limit of iterations or of time was reached
  STALLED,    ///< the length, the gradient, or a suspected unknot stopped making progress, or the
              ///< thickness is too small, see `Untangling_result::fitting_thickness`
  INTERRUPTED ///< the visitor or `progress` ended the run
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
  case Untangling_status::CONSTRAINT_NOT_REACHED:
    return "constraint not reached";
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
/// The proof that a closed component is an unknot.
enum class Unknot_proof
{
  NONE,           ///< no proof
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
/// The linking of the components of a curve.
enum class Link_status
{
  NOT_A_LINK, ///< there is only one component, or a component that is not closed
  TRIVIAL,    ///< the link is proved to be trivial: unlinked unknots
  LINKED,     ///< two components have a nonzero linking number
  UNDECIDED   ///< neither is proved
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
/// The result of `untangle()`. Whatever the status, the curve is ambient isotopic to the input.
struct Untangling_result
{
  Untangling_status status = Untangling_status::LIMIT; ///< how the run ended
  std::vector<Unknot_proof> proofs;                    ///< one per component
  Link_status link = Link_status::NOT_A_LINK;          ///< whether the components are linked
  bool is_round = false;                               ///< whether the curve is a regular polygon
  /// Whether the ropelength was lowered until it no longer fell noticeably. If `false`, it may have
  /// been lowered less far. See `Untangling_parameters::lower_ropelength`.
  bool is_ropelength_lowered = false;
  bool is_input = false; ///< whether the result is the input, because the input is tighter
  /// Whether the closure of every open component with pinned ends, as defined by `untangle()`, is
  /// known to have kept its knot type. `true` after a run without a domain that has converged; at a
  /// limit, strands may still block the closing rays. In a domain, which has no closing rays,
  /// `false` if there is such a component.
  bool is_closure_kept = true;
  double thickness = 0; ///< r, in the input's unit; 0 if the run ended before it was known
  /// A thickness that suits the curve, in the input's unit, if the flow has stalled because the
  /// given one is too small: the curve is then smooth on that scale, but not tight. Otherwise 0.
  double fitting_thickness = 0;
  /// The final `Curve_flow_3::gradient_norm()`, which grows while the ropelength is lowered. NaN or
  /// 0 if no flow has measured it.
  double gradient_norm = 0;
  /// the tightest bend and the closest strands in comparison with what is required, as far as they
  /// exceed that, whatever the status
  std::vector<Shape_excess_3<>> shape_excesses;
  Curve_flow_statistics statistics; ///< the work of all flows
  std::size_t searches = 0;         ///< the number of searches for few edges; each jam starts
                                    ///< another
  std::size_t sweeps = 0;           ///< the sweeps of all searches, see `Search_progress`
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_UNTANGLING_RESULT_H
