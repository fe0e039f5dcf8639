// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_DEFECT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_DEFECT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief the kinds of defects of a curve.
 */
enum class Curve_defect_kind
{
  UNREADABLE_FILE,         ///< the file cannot be opened or read
  UNKNOWN_FORMAT,          ///< the file name has no extension of a curve format, or the contents do
                           ///< not match it
  BINARY_DATA,             ///< bytes that cannot occur in a text file, or encoded data
  UNKNOWN_RECORD,          ///< a record that the format does not define (warning, ignored)
  UNPARSABLE_NUMBER,       ///< a word that should be a number
  MISSING_COORDINATES,     ///< a vertex with fewer than three coordinates
  WRONG_POINT_COUNT,       ///< a polyline whose announced number of points is wrong
  NON_FINITE_COORDINATE,   ///< a coordinate that is infinite or not a number
  COORDINATE_TOO_LARGE,    ///< a coordinate beyond 1e150, whose products would overflow
  SIZE_TOO_SMALL,          ///< a curve smaller than 1e-150, whose products would underflow
  BAD_INDEX,               ///< an index that is zero, out of range or not an integer
  SHORT_LINE,              ///< a line record with fewer than two indices
  NO_GEOMETRY,             ///< no vertices or no edges
  FACES_ONLY,              ///< a surface instead of a curve
  NO_LINES,                ///< no line records: one closed curve through all vertices (warning)
  ISOLATED_VERTEX,         ///< vertices without an edge (warning, ignored)
  DUPLICATE_EDGE,          ///< an edge that occurs twice (warning, dropped)
  COINCIDENT_NODES,        ///< an edge of length zero (warning, its nodes are merged)
  NEARLY_COINCIDENT_NODES, ///< an edge shorter than 1e-12 of the size of all curves (warning)
  NEARLY_CLOSED,           ///< an arc whose ends are as close as neighbors; a closed curve repeats
                           ///< its first point (warning)
  UNDECIDED_CLOSURE,       ///< a list of points whose ends nearly meet in a format without closed
                           ///< curves; `closure` must be given
  CHAIN_GAP,               ///< missing residues of a protein, bridged by an edge (warning)
  DEGENERATE_LOOP,         ///< a closed curve with fewer than three distinct nodes
  JUNCTION,                ///< a node with more than two edges where junctions are forbidden
  SELF_CONTACT             ///< two edges that meet elsewhere than in a common node; unless a line
                           ///< turns straight back, found only by
                           ///< `CGAL::IO::read_embedded_curve_network()`
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 * \headerfile CGAL/Volume_filling_curves/IO/curve_network.h
 *
 * \brief The class `Curve_defect` describes a defect of a curve, and its location.
 */
struct Curve_defect
{
  /// the kind of the defect
  Curve_defect_kind kind;

  /// a description in English, in ASCII, without a newline
  std::string message;

  /// the line of the file, counted from 1, or 0 if it is unknown
  std::size_t line = 0;

  /// the nodes concerned, counted from 1 in the order of the file's vertices
  std::vector<std::size_t> nodes = {};

  /// the component concerned, counted from 1 in the order of the components' first edges, or 0 if
  /// it is unknown
  std::size_t component = 0;
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns whether defects of a kind are errors, for which a curve is refused. All others are
 * warnings.
 */
inline bool is_error(Curve_defect_kind kind)
{
  switch(kind) {
  case Curve_defect_kind::UNKNOWN_RECORD:
  case Curve_defect_kind::NO_LINES:
  case Curve_defect_kind::ISOLATED_VERTEX:
  case Curve_defect_kind::DUPLICATE_EDGE:
  case Curve_defect_kind::COINCIDENT_NODES:
  case Curve_defect_kind::NEARLY_COINCIDENT_NODES:
  case Curve_defect_kind::NEARLY_CLOSED:
  case Curve_defect_kind::CHAIN_GAP:
    return false;
  default:
    return true;
  }
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns the name of a kind of defects in plain English, for example "self-contact".
 */
inline const char* to_string(Curve_defect_kind kind)
{
  switch(kind) {
  case Curve_defect_kind::UNREADABLE_FILE:
    return "unreadable file";
  case Curve_defect_kind::UNKNOWN_FORMAT:
    return "unknown format";
  case Curve_defect_kind::BINARY_DATA:
    return "binary data";
  case Curve_defect_kind::UNKNOWN_RECORD:
    return "unknown record";
  case Curve_defect_kind::UNPARSABLE_NUMBER:
    return "unparsable number";
  case Curve_defect_kind::MISSING_COORDINATES:
    return "missing coordinates";
  case Curve_defect_kind::WRONG_POINT_COUNT:
    return "wrong point count";
  case Curve_defect_kind::NON_FINITE_COORDINATE:
    return "non-finite coordinate";
  case Curve_defect_kind::COORDINATE_TOO_LARGE:
    return "coordinate too large";
  case Curve_defect_kind::SIZE_TOO_SMALL:
    return "size too small";
  case Curve_defect_kind::BAD_INDEX:
    return "bad index";
  case Curve_defect_kind::SHORT_LINE:
    return "short line";
  case Curve_defect_kind::NO_GEOMETRY:
    return "no geometry";
  case Curve_defect_kind::FACES_ONLY:
    return "faces only";
  case Curve_defect_kind::NO_LINES:
    return "no lines";
  case Curve_defect_kind::ISOLATED_VERTEX:
    return "isolated vertex";
  case Curve_defect_kind::DUPLICATE_EDGE:
    return "duplicate edge";
  case Curve_defect_kind::COINCIDENT_NODES:
    return "coincident nodes";
  case Curve_defect_kind::NEARLY_COINCIDENT_NODES:
    return "nearly coincident nodes";
  case Curve_defect_kind::NEARLY_CLOSED:
    return "nearly closed";
  case Curve_defect_kind::UNDECIDED_CLOSURE:
    return "undecided closure";
  case Curve_defect_kind::CHAIN_GAP:
    return "chain gap";
  case Curve_defect_kind::DEGENERATE_LOOP:
    return "degenerate loop";
  case Curve_defect_kind::JUNCTION:
    return "junction";
  case Curve_defect_kind::SELF_CONTACT:
    return "self-contact";
  }
  return "";
}

/// \ingroup PkgVolumeFillingCurvesIO
///
/// writes the name in plain English.
inline std::ostream& operator<<(std::ostream& out, Curve_defect_kind kind)
{
  return out << to_string(kind);
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns a defect in the form of a compiler's message: `FILE:LINE: error|warning: KIND:
 * message (nodes i j)`.
 *
 * An unknown line is left out; at most ten nodes are listed.
 */
inline std::string to_string(const Curve_defect& defect, const std::string& filename)
{
  const std::size_t max_listed = 10;
  std::string text = filename + ":";
  if(defect.line > 0) text += std::to_string(defect.line) + ":";
  text += is_error(defect.kind) ? " error: " : " warning: ";
  text += std::string(to_string(defect.kind)) + ": " + defect.message;
  if(defect.nodes.empty()) return text;
  text += defect.nodes.size() == 1 ? " (node" : " (nodes";
  const std::size_t listed = (std::min)(defect.nodes.size(), max_listed);
  for(std::size_t i = 0; i < listed; ++i) text += " " + std::to_string(defect.nodes[i]);
  return text + (listed < defect.nodes.size() ? " ...)" : ")");
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_CURVE_DEFECT_H
