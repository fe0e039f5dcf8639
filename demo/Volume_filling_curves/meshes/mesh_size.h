// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MESH_SIZE_H
#define VFC_MESH_SIZE_H

#include "files/mesh_files.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>

namespace vfc {

inline CGAL::Bbox_3 box_of(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const auto& p : mesh.points()) box += p.bbox();
  return box;
}

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = box_of(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// the longest side of a box
inline double width(const CGAL::Bbox_3& box)
{
  return (std::max)({box.x_span(), box.y_span(), box.z_span()});
}

} // namespace vfc

#endif // VFC_MESH_SIZE_H
