// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_FILE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_FILE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Mesh_defect.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What a mesh file says: points, triangles as triples of point indices from 0, and what is wrong with
// them. The reader fills it, `Mesh_checker` completes the list and repairs what can be repaired. Of
// every kind of defects only the first 1000 are kept, the others are counted.
struct Mesh_file
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Face = std::array<std::size_t, 3>;
  using Indices = std::vector<std::size_t>;

  static constexpr std::size_t max_listed = 1000;

  void add(Mesh_defect defect)
  {
    if(is_error(defect.kind)) has_error = true;
    if(++counts[defect.kind] <= max_listed) defects.push_back(std::move(defect));
  }

  // The indices count from 0 here; those of points are the file's, those of faces ours.
  void add(Mesh_defect_kind kind,
           std::string message,
           Indices vertices,
           const Indices& faces_concerned = {},
           std::size_t shell = 0)
  {
    Mesh_defect defect{kind, std::move(message), 0, std::move(vertices), {}, shell};
    for(std::size_t& v : defect.vertices) ++v;
    for(const std::size_t f : faces_concerned) defect.faces.push_back(face_numbers[f]);
    add(std::move(defect));
  }

  // returns the defects, and the total of every kind that is not listed completely
  std::vector<Mesh_defect> listed() const
  {
    std::vector<Mesh_defect> result = defects;
    for(const auto& [kind, count] : counts)
      if(count > max_listed)
        result.push_back({kind, std::to_string(count) + " of this kind in total, the first " +
                                    std::to_string(max_listed) + " are listed"});
    return result;
  }

  std::vector<Point> points;
  std::vector<Face> faces;
  Indices face_numbers; // of the file's faces, from 1, since polygons are cut into triangles
  Indices origins;      // of the points, when some have been left out or split
  std::vector<Mesh_defect> defects;
  std::map<Mesh_defect_kind, std::size_t> counts;
  bool has_error = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_MESH_FILE_H
