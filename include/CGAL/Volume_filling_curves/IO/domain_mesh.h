// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IO_DOMAIN_MESH_H
#define CGAL_VOLUME_FILLING_CURVES_IO_DOMAIN_MESH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Mesh_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/read_mesh_file.h>
#include <CGAL/Volume_filling_curves/internal/Mesh_checker.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a closed triangle mesh that bounds a domain, and lists everything that is wrong with
 * it.
 *
 * The extension tells the format, in upper or lower case: `.off`, `.obj`, `.ply`, `.stl`, and `.vtp` if
 * \cgal is used with VTK, as `CGAL::IO::read_polygon_soup()` reads them.
 *
 * What has only one reading is repaired, with a warning: faces with more corners are cut into
 * triangles, equal vertices merged, vertices without faces left out, vertices in which the surface
 * touches itself split, faces reoriented. Afterwards the shells are oriented such that the normals
 * point out of the domain; a shell within an odd number of others bounds a cavity.
 *
 * The mesh is constructed only if it is closed, without degenerate faces, and no two faces meet
 * elsewhere than in a common vertex or edge, as `Triangle_mesh_domain_3` needs it. All of this is
 * decided exactly. The time is \cgalBigO{n \log^2 n} for `n` faces unless many faces have
 * intersecting bounding boxes.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph` whose points are those of
 * `CGAL::Exact_predicates_inexact_constructions_kernel`
 *
 * \param filename the name of the file
 * \param mesh receives the mesh; it does not change if there is an error
 * \param defects receives all errors and warnings, at most 1000 of a kind
 * \param origins receives for every vertex of the mesh, in the order of `vertices(mesh)`, its place
 * among the vertices of the file, from 0
 *
 * \return whether there is no error
 */
template <typename TriangleMesh>
bool read_domain_mesh(const std::string& filename,
                      TriangleMesh& mesh,
                      std::vector<Volume_filling_curves::Mesh_defect>& defects,
                      std::vector<std::size_t>& origins)
{
  namespace internal = Volume_filling_curves::internal;
  internal::Mesh_file file = internal::read_mesh_file(filename);
  internal::Mesh_checker(file).run();
  defects = file.listed();
  if(file.has_error) return false;
  CGAL::clear(mesh);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(file.points, file.faces, mesh);
  origins = std::move(file.origins);
  return true;
}

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief reads a closed triangle mesh that bounds a domain, and lists everything that is wrong with
 * it.
 *
 * As the overload above, for those who need not know the places of the vertices in the file.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph` whose points are those of
 * `CGAL::Exact_predicates_inexact_constructions_kernel`
 *
 * \param filename the name of the file
 * \param mesh receives the mesh; it does not change if there is an error
 * \param defects receives all errors and warnings, at most 1000 of a kind
 *
 * \return whether there is no error
 */
template <typename TriangleMesh>
bool read_domain_mesh(const std::string& filename,
                      TriangleMesh& mesh,
                      std::vector<Volume_filling_curves::Mesh_defect>& defects)
{
  std::vector<std::size_t> origins;
  return read_domain_mesh(filename, mesh, defects, origins);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IO_DOMAIN_MESH_H
