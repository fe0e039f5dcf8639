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

#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace vfc {
namespace {

// Closing a hole may let faces intersect, and cutting these out may leave flat ones.
constexpr int max_rounds = 3;
constexpr double default_alpha = 0.02; // of the diagonal

struct Step
{
  const char* name;
  std::string (*run)(Mesh&, Work_watch&);
};

constexpr Step mild_steps[] = {
    {"merging vertices", merge_near_vertices},
    {"dropping sheets", drop_sheets},
    {"removing flat faces", remove_flat_faces},
    {"closing holes", close_holes},
    {"removing self-intersections", remove_self_intersections},
    {"uniting shells", unite_shells},
};

// Makes one round through them.
void mend_by_parts(Mesh& mesh, std::vector<std::string>& steps, Work_watch& watch)
{
  for(const Step& step : mild_steps) {
    watch.begin(step.name);
    const Mesh before = mesh;
    try {
      const std::string done = step.run(mesh, watch);
      if(!CGAL::is_valid_polygon_mesh(mesh)) throw std::runtime_error("no mesh any more");
      if(!done.empty()) steps.push_back(done);
    } catch(const std::exception&) { // of CGAL; the next steps may know better
      mesh = before;
    }
  }
}

bool has_area(const Mesh& mesh)
{
  const auto faces = mesh.faces();
  return !std::all_of(faces.begin(), faces.end(), [&](Mesh::Face_index f) {
    return CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, mesh);
  });
}

} // namespace

Mending repair_mesh(const Mesh_soup& soup, double alpha, Mesh& mesh, Work_watch& watch)
{
  Mending mending;
  const auto note = [&](const std::string& done) {
    if(!done.empty()) mending.steps.push_back(done);
  };
  const auto is_mended = [&] {
    watch.begin("checking");
    return is_sound(mesh, watch);
  };
  watch.begin("assembling faces");
  note(assemble_faces(soup, mesh, watch));
  if(!has_area(mesh)) return mending;
  const Mesh assembled = mesh;
  for(int round = 0; round < max_rounds && !is_mended(); ++round) {
    const std::size_t number_of_steps = mending.steps.size();
    mend_by_parts(mesh, mending.steps, watch);
    if(mending.steps.size() == number_of_steps) break;
  }
  if(!is_mended()) {
    watch.begin("wrapping");
    mesh = assembled;
    mending.steps.clear();
    note(close_holes(mesh, watch)); // or the wrap goes in and leaves a skin
    note(wrap_faces(alpha > 0 ? alpha : default_alpha * diagonal(assembled), mesh, watch));
  }
  watch.begin("measuring");
  mending.from_file = surface_distance(mesh, assembled, watch);
  mending.to_mended = surface_distance(assembled, mesh, watch);
  return mending;
}

} // namespace vfc
