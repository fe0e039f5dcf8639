// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Mesh_shells.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>
#include <CGAL/Volume_filling_curves/internal/domain/shell_nesting.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Shell of a closed surface. A shell within an odd number of others bounds a cavity and should be
// oriented inward, all others outward.
template <typename Mesh>
struct Nested_shell
{
  std::vector<typename Mesh::Face_index> faces;
  std::optional<std::size_t> parent = {}; // the shell directly around, if there is one
  bool is_right = true;                   // whether its orientation suits its depth
};

// Returns the shells in the order of their first faces.
// \pre the mesh is closed, has no garbage, and its faces do not intersect
template <typename Mesh>
std::vector<Nested_shell<Mesh>> nested_shells(const Mesh& mesh)
{
  const Mesh_shells<Mesh> components(mesh);
  std::vector<std::vector<typename Mesh::Face_index>> faces(components.number());
  for(const auto f : mesh.faces()) faces[components.shell(f)].push_back(f);
  const std::vector<Shell_nesting> nestings = Shell_nesting_search<Mesh>::find(mesh, faces);
  const auto depth = [&](std::size_t shell) { return nestings[shell].around.size(); };
  std::vector<Nested_shell<Mesh>> shells;
  for(std::size_t i = 0; i < faces.size(); ++i) {
    shells.push_back({faces[i]});
    shells[i].is_right = nestings[i].is_outward == (depth(i) % 2 == 0);
    for(const std::size_t outer : nestings[i].around)
      if(depth(outer) + 1 == depth(i)) shells[i].parent = outer;
  }
  return shells;
}

// Whether a shell has the orientation of the one around it: its author may have meant two solids or
// a cavity. A nest whose shells all have the wrong orientation is not ambiguous.
template <typename Mesh>
bool is_ambiguous(const std::vector<Nested_shell<Mesh>>& shells, std::size_t i)
{
  return shells[i].parent && shells[i].is_right != shells[*shells[i].parent].is_right;
}

// \pre the shell is ambiguous
template <typename Mesh>
Mesh_fault ambiguity_fault(const std::vector<Nested_shell<Mesh>>& shells, std::size_t i)
{
  return {"ambiguous shells", "shell " + std::to_string(i + 1) + " lies within shell " +
                                  std::to_string(*shells[i].parent + 1) +
                                  " and has the same orientation"};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H
