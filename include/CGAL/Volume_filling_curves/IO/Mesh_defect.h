// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_MESH_DEFECT_H
#define CGAL_VOLUME_FILLING_CURVES_IO_MESH_DEFECT_H

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
 * \brief what can be wrong with a mesh that shall bound a domain.
 */
enum class Mesh_defect_kind
{
  UNREADABLE_FILE, ///< the file cannot be opened, or no reader understands it
  UNKNOWN_FORMAT,  ///< the extension of the file's name is not that of a mesh file that can be read
  TRUNCATED_FILE,  ///< the file ends before all that it announces
  UNPARSABLE_NUMBER,     ///< a number was expected and something else was found
  NON_FINITE_COORDINATE, ///< a coordinate that is infinite or not a number
  COORDINATE_TOO_LARGE,  ///< a coordinate beyond 1e150, whose products would overflow
  SIZE_TOO_SMALL,        ///< a mesh smaller than 1e-150, whose products would underflow
  BAD_INDEX,             ///< a face with a vertex index that is out of range or no integer
  NO_GEOMETRY,           ///< there are no vertices or no faces
  POLYGONAL_FACE,        ///< faces with more than three corners (warning, cut into triangles)
  ISOLATED_VERTEX,       ///< vertices without a face (warning, ignored)
  COINCIDENT_VERTICES,   ///< vertices with the same coordinates (warning, merged)
  DEGENERATE_FACE,       ///< a face whose corners are not three, or lie on a line
  DUPLICATE_FACE,        ///< two faces with the same corners
  OPEN_BOUNDARY,         ///< edges with one face only: a hole
  NON_MANIFOLD_EDGE,     ///< an edge with more than two faces
  NON_MANIFOLD_VERTEX,   ///< a vertex where the surface touches itself (warning, split)
  SELF_INTERSECTION,     ///< two faces that meet elsewhere than in a common vertex or edge
  ZERO_VOLUME,           ///< all vertices lie in a plane
  MIXED_ORIENTATION,     ///< faces that are turned against their neighbors (warning, reoriented)
  INVERTED_ORIENTATION,  ///< a shell that is turned inside out (warning, reoriented)
  MISSING_PROPERTY,  ///< a PLY file without the asked vertex property, or not as float or double
  BAD_VALUE,         ///< a value at a vertex that is not a positive, finite number
  WRONG_VALUE_COUNT, ///< a file with more or fewer values than the mesh has vertices
  AMBIGUOUS_SHELLS   ///< a shell within another one that is turned the same way: a cavity or not?
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief The class `Mesh_defect` describes one defect of a mesh, and where it is.
 */
struct Mesh_defect
{
  /// what is wrong
  Mesh_defect_kind kind;

  /// a sentence for humans, in ASCII, without a newline
  std::string message;

  /// the line of the file, counted from 1, or 0 if it is unknown
  std::size_t line = 0;

  /// the vertices concerned, counted from 1 in the order of the file
  std::vector<std::size_t> vertices = {};

  /// the faces concerned, counted from 1 in the order of the file
  std::vector<std::size_t> faces = {};

  /// the shell concerned, counted from 1 in the order of the shells' first faces, or 0
  std::size_t shell = 0;
};

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns whether a mesh with a defect of this kind is refused. All other defects are
 * warnings.
 */
inline bool is_error(Mesh_defect_kind kind)
{
  switch(kind) {
  case Mesh_defect_kind::POLYGONAL_FACE:
  case Mesh_defect_kind::ISOLATED_VERTEX:
  case Mesh_defect_kind::COINCIDENT_VERTICES:
  case Mesh_defect_kind::NON_MANIFOLD_VERTEX:
  case Mesh_defect_kind::MIXED_ORIENTATION:
  case Mesh_defect_kind::INVERTED_ORIENTATION:
    return false;
  default:
    return true;
  }
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns the name of a kind of defects in plain English, for example "open boundary".
 */
inline const char* to_string(Mesh_defect_kind kind)
{
  switch(kind) {
  case Mesh_defect_kind::UNREADABLE_FILE:
    return "unreadable file";
  case Mesh_defect_kind::UNKNOWN_FORMAT:
    return "unknown format";
  case Mesh_defect_kind::TRUNCATED_FILE:
    return "truncated file";
  case Mesh_defect_kind::UNPARSABLE_NUMBER:
    return "unparsable number";
  case Mesh_defect_kind::NON_FINITE_COORDINATE:
    return "non-finite coordinate";
  case Mesh_defect_kind::COORDINATE_TOO_LARGE:
    return "coordinate too large";
  case Mesh_defect_kind::SIZE_TOO_SMALL:
    return "size too small";
  case Mesh_defect_kind::BAD_INDEX:
    return "bad index";
  case Mesh_defect_kind::NO_GEOMETRY:
    return "no geometry";
  case Mesh_defect_kind::POLYGONAL_FACE:
    return "polygonal face";
  case Mesh_defect_kind::ISOLATED_VERTEX:
    return "isolated vertex";
  case Mesh_defect_kind::COINCIDENT_VERTICES:
    return "coincident vertices";
  case Mesh_defect_kind::DEGENERATE_FACE:
    return "degenerate face";
  case Mesh_defect_kind::DUPLICATE_FACE:
    return "duplicate face";
  case Mesh_defect_kind::OPEN_BOUNDARY:
    return "open boundary";
  case Mesh_defect_kind::NON_MANIFOLD_EDGE:
    return "non-manifold edge";
  case Mesh_defect_kind::NON_MANIFOLD_VERTEX:
    return "non-manifold vertex";
  case Mesh_defect_kind::SELF_INTERSECTION:
    return "self-intersection";
  case Mesh_defect_kind::ZERO_VOLUME:
    return "zero volume";
  case Mesh_defect_kind::MIXED_ORIENTATION:
    return "mixed orientation";
  case Mesh_defect_kind::INVERTED_ORIENTATION:
    return "inverted orientation";
  case Mesh_defect_kind::MISSING_PROPERTY:
    return "missing property";
  case Mesh_defect_kind::BAD_VALUE:
    return "bad value";
  case Mesh_defect_kind::WRONG_VALUE_COUNT:
    return "wrong value count";
  case Mesh_defect_kind::AMBIGUOUS_SHELLS:
    return "ambiguous shells";
  }
  return "";
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief returns the line that a compiler would print:
 * `FILE:LINE: error|warning: KIND: message (vertices i j) (faces k l)`.
 *
 * An unknown line is left out, and of many vertices or faces only the first ten are listed.
 */
inline std::string to_string(const Mesh_defect& defect, const std::string& filename)
{
  const auto list = [](const char* one, const char* many, const std::vector<std::size_t>& numbers) {
    const std::size_t max_listed = 10;
    if(numbers.empty()) return std::string();
    std::string text = std::string(" (") + (numbers.size() == 1 ? one : many);
    const std::size_t listed = (std::min)(numbers.size(), max_listed);
    for(std::size_t i = 0; i < listed; ++i) text += " " + std::to_string(numbers[i]);
    return text + (listed < numbers.size() ? " ...)" : ")");
  };
  return filename + ":" + (defect.line > 0 ? std::to_string(defect.line) + ":" : "") +
         (is_error(defect.kind) ? " error: " : " warning: ") + to_string(defect.kind) + ": " +
         defect.message + list("vertex", "vertices", defect.vertices) +
         list("face", "faces", defect.faces);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_MESH_DEFECT_H
