// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/shells_apart.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <cstddef>

namespace vfc {

std::vector<Mesh> shells_apart(const Mesh& mesh)
{
  std::vector<Mesh> shells;
  CGAL::Polygon_mesh_processing::split_connected_components(mesh, shells);
  return shells;
}

Mesh shells_together(const std::vector<Mesh>& shells)
{
  Mesh mesh;
  for(const Mesh& shell : shells) mesh += shell;
  mesh.collect_garbage();
  return mesh;
}

} // namespace vfc
