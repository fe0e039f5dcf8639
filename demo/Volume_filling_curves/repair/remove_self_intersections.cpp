// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "repair/shells_apart.h"

#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// returns whether the shell has none after this; else it is as it was
bool is_mended(Mesh& shell)
{
  Mesh copy = shell;
  try {
    const auto np = CGAL::parameters::preserve_genus(false);
    if(!PMP::experimental::remove_self_intersections(copy, np) || copy.is_empty()) return false;
  } catch(const std::exception&) { // what CGAL did not expect is left to the next steps
    return false;
  }
  shell = copy;
  return true;
}

} // namespace

std::string remove_self_intersections(Mesh& mesh)
{
  std::vector<Mesh> shells = shells_apart(mesh);
  std::size_t mended = 0;
  for(Mesh& shell : shells)
    if(PMP::does_self_intersect(shell) && is_mended(shell)) ++mended;
  if(mended == 0) return "";
  mesh = shells_together(shells);
  return "self-intersections of " + std::to_string(mended) + " shells cut out";
}

} // namespace vfc
