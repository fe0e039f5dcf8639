// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_CURVE_DEFECT_H
#define CGAL_VOLUME_FILLING_CURVES_IO_CURVE_DEFECT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief tells whether a curve network may have junctions, that is, nodes with more than two edges.
 */
enum class Junctions
{
  forbidden, ///< every component is a closed curve or an arc; a junction is an error
  allowed    ///< any graph is welcome; equal end points of polylines are one node
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief what can be wrong with a curve.
 */
enum class Curve_defect_kind
{
  unreadable_file,         ///< the file cannot be opened or read
  unknown_format,          ///< the extension of the file's name is not that of a curve file
  binary_data,             ///< bytes that do not belong in a text file
  unknown_record,          ///< a record that the format does not have (warning, ignored)
  unparsable_number,       ///< a number was expected and something else was found
  missing_coordinates,     ///< a vertex with fewer than three coordinates
  wrong_point_count,       ///< a polyline that does not have as many points as it announces
  non_finite_coordinate,   ///< a coordinate that is infinite or not a number
  coordinate_too_large,    ///< a coordinate beyond 1e150, whose products would overflow
  size_too_small,          ///< a curve smaller than 1e-150, whose products would underflow
  bad_index,               ///< an index that is zero, out of range or no integer
  short_line,              ///< a line record with fewer than two indices
  no_geometry,             ///< there are no vertices or no edges
  faces_only,              ///< the file holds a surface, not a curve
  no_lines,                ///< no line records: one closed curve through all vertices (warning)
  isolated_vertex,         ///< vertices without an edge (warning, ignored)
  duplicate_edge,          ///< an edge that occurs twice (warning, dropped)
  coincident_nodes,        ///< an edge of length zero (warning, its nodes are merged)
  nearly_coincident_nodes, ///< an edge shorter than 1e-12 of the size of all curves (warning)
  degenerate_loop,         ///< a closed curve with fewer than three distinct nodes
  junction,                ///< a node with more than two edges where junctions are forbidden
  self_contact             ///< two edges that meet elsewhere than in a common node
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief The class `Curve_defect` describes one defect of a curve, and where it is.
 */
struct Curve_defect
{
  /// what is wrong
  Curve_defect_kind kind;

  /// a sentence for humans, in ASCII, without a newline
  std::string message;

  /// the line of the file, counted from 1, or 0 if it is unknown
  std::size_t line = 0;

  /// the nodes concerned, counted from 1 in the order of the file's vertices
  std::vector<std::size_t> nodes = {};

  /// the component concerned, counted from 1 in the order of the components' first edges, or 0 if it
  /// is unknown
  std::size_t component = 0;
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns whether a curve with a defect of this kind is refused. All other defects are
 * warnings.
 */
inline bool is_error(Curve_defect_kind kind)
{
  switch(kind) {
  case Curve_defect_kind::unknown_record:
  case Curve_defect_kind::no_lines:
  case Curve_defect_kind::isolated_vertex:
  case Curve_defect_kind::duplicate_edge:
  case Curve_defect_kind::coincident_nodes:
  case Curve_defect_kind::nearly_coincident_nodes:
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
  case Curve_defect_kind::unreadable_file:
    return "unreadable file";
  case Curve_defect_kind::unknown_format:
    return "unknown format";
  case Curve_defect_kind::binary_data:
    return "binary data";
  case Curve_defect_kind::unknown_record:
    return "unknown record";
  case Curve_defect_kind::unparsable_number:
    return "unparsable number";
  case Curve_defect_kind::missing_coordinates:
    return "missing coordinates";
  case Curve_defect_kind::wrong_point_count:
    return "wrong point count";
  case Curve_defect_kind::non_finite_coordinate:
    return "non-finite coordinate";
  case Curve_defect_kind::coordinate_too_large:
    return "coordinate too large";
  case Curve_defect_kind::size_too_small:
    return "size too small";
  case Curve_defect_kind::bad_index:
    return "bad index";
  case Curve_defect_kind::short_line:
    return "short line";
  case Curve_defect_kind::no_geometry:
    return "no geometry";
  case Curve_defect_kind::faces_only:
    return "faces only";
  case Curve_defect_kind::no_lines:
    return "no lines";
  case Curve_defect_kind::isolated_vertex:
    return "isolated vertex";
  case Curve_defect_kind::duplicate_edge:
    return "duplicate edge";
  case Curve_defect_kind::coincident_nodes:
    return "coincident nodes";
  case Curve_defect_kind::nearly_coincident_nodes:
    return "nearly coincident nodes";
  case Curve_defect_kind::degenerate_loop:
    return "degenerate loop";
  case Curve_defect_kind::junction:
    return "junction";
  case Curve_defect_kind::self_contact:
    return "self-contact";
  }
  return "";
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns the line that a compiler would print:
 * `FILE:LINE: error|warning: KIND: message (nodes i j)`.
 *
 * An unknown line is left out, and of many nodes only the first ten are listed.
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

#endif // CGAL_VOLUME_FILLING_CURVES_IO_CURVE_DEFECT_H
