// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/obstacles.h"

#include "meshes/examine_mesh.h"
#include "repair/combined_shells.h"
#include "repair/read_mended_mesh.h"
#include "session/Session.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/add_obstacle.h>

#include <CGAL/Polygon_mesh_processing/intersection.h>

#include <optional>
#include <stdexcept>
#include <utility>

namespace vfc {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& why, const char* advice = "")
{
  throw Input_error({Defect("bad obstacle", true, file, {}, why)},
                    std::string("an obstacle of this mesh") + advice);
}

Mesh without_obstacle(const Session& session,
                      const Mesh& mesh,
                      const Mesh& obstacle,
                      const std::string& file,
                      double time_limit)
{
  Work_watch watch(time_limit - session.seconds(),
                   [](const std::string&, double) { return !is_interruption_requested(); });
  try {
    watch.begin("cutting it out of the mesh");
    std::optional<Mesh> rest = difference(mesh, obstacle, watch);
    if(rest && rest->is_empty()) refuse(file, "the obstacle leaves nothing of the mesh");
    if(!rest || !is_sound(*rest, watch))
      refuse(file, "the obstacle crosses or touches the mesh or another obstacle, and what is left "
                   "bounds no domain: it would touch itself");
    return std::move(*rest);
  } catch(const Work_stopped&) {
    throw unfinished(watch, file, time_limit);
  }
}

void add(Mesh& mesh, const Mesh& obstacle, const std::string& file, const char* advice = "")
{
  try {
    CGAL::Volume_filling_curves::add_obstacle(mesh, obstacle);
  } catch(const std::invalid_argument& error) {
    refuse(file, error.what(), advice);
  }
}

} // namespace

void add_obstacles(Session& session, Mesh& mesh, const std::vector<std::string>& files)
{
  for(const std::string& file : files)
    add(mesh, read_mesh(session, file).mesh, file,
        "; what crosses the mesh is cut out by vfc repair MESH --obstacle FILE, or fill with "
        "--repair");
}

void add_or_cut_out_obstacles(Session& session,
                              Mesh& mesh,
                              const std::vector<std::string>& files,
                              double time_limit)
{
  for(const std::string& file : files) {
    const Mesh obstacle = read_mended_mesh(session, file, {0, time_limit}).mesh;
    if(!CGAL::Polygon_mesh_processing::do_intersect(mesh, obstacle)) {
      add(mesh, obstacle, file);
      continue;
    }
    mesh = without_obstacle(session, mesh, obstacle, file, time_limit);
    session.console().note(file + ": cut out of the mesh, since it crosses or touches the surface");
  }
}

} // namespace vfc
