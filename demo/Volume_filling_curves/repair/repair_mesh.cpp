// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_mesh.h"

#include "meshes/examine_mesh.h"
#include "meshes/mesh_size.h"
#include "repair/repair_steps.h"
#include "repair/surface_distance.h"

#include <exception>

namespace vfc {
namespace {

// Closing a hole may let faces intersect, and cutting these out may leave flat ones.
constexpr int most_rounds = 3;
constexpr double default_alpha = 0.02; // of the diagonal

// Makes one round through the steps, but for the last resort.
void mend_by_parts(Mesh& mesh, std::vector<std::string>& steps)
{
  for(const auto step : {merge_near_vertices, drop_sheets, remove_flat_faces, close_holes,
                         remove_self_intersections, unite_shells}) {
    const Mesh before = mesh;
    try {
      const std::string done = step(mesh);
      if(!done.empty()) steps.push_back(done);
    } catch(const std::exception&) { // of CGAL; the next steps may know better
      mesh = before;
    }
  }
}

} // namespace

Mending repair_mesh(const Mesh_soup& soup, double alpha, Mesh& mesh)
{
  Mending mending;
  const auto note = [&](const std::string& done) {
    if(!done.empty()) mending.steps.push_back(done);
  };
  note(assemble_faces(soup, mesh));
  const Mesh assembled = mesh;
  for(int round = 0; round < most_rounds && !is_sound(mesh); ++round) {
    const std::size_t number_of_steps = mending.steps.size();
    mend_by_parts(mesh, mending.steps);
    if(mending.steps.size() == number_of_steps) break;
  }
  if(!is_sound(mesh)) {
    mesh = assembled;
    mending.steps.clear();
    note(close_holes(mesh)); // or the wrap goes in and leaves a skin
    note(wrap_faces(alpha > 0 ? alpha : default_alpha * diagonal(assembled), mesh));
  }
  mending.from_file = surface_distance(mesh, assembled);
  mending.to_mended = surface_distance(assembled, mesh);
  return mending;
}

} // namespace vfc
