// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/Mesh_soup.h"

namespace vfc {

void Mesh_soup::record_file_indices()
{
  file_indices.clear();
  for(std::size_t v = 0; v < points.size(); ++v) file_indices.insert({points[v], v});
}

std::vector<std::size_t> Mesh_soup::numbers(const std::vector<std::size_t>& vertices) const
{
  std::vector<std::size_t> result;
  for(const std::size_t v : vertices) result.push_back(file_index(v) + 1);
  return result;
}

} // namespace vfc
