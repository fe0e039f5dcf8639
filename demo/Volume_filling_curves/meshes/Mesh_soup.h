// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_SOUP_H
#define VFC_MESH_SOUP_H

#include "files/mesh_files.h"

#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace vfc {

// Triangles of a mesh file, and the positions of triangles and corners in the file. Points may be
// merged, omitted and duplicated; their coordinates identify them in the file.
struct Mesh_soup
{
  using Point = Kernel::Point_3;
  using Face = std::array<std::size_t, 3>;

  // Records the points as those of the file; the first of equal points counts. Comes before
  // `file_index()` and `numbers()`. \pre the coordinates are finite
  void record_file_indices();

  // the index of a point in the file, from 0
  std::size_t file_index(std::size_t v) const { return file_indices.at(points[v]); }

  // the numbers of vertices in the file, from 1
  std::vector<std::size_t> numbers(const std::vector<std::size_t>& vertices) const;

  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<std::size_t> face_numbers; // in the file, from 1; polygons become several triangles
  std::map<Point, std::size_t> file_indices;
};

using CGAL::Volume_filling_curves::internal::near_text;

} // namespace vfc

#endif // VFC_MESH_SOUP_H
