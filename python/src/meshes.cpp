// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "Run_observer.h"
#include "arrays.h"
#include "bindings.h"

#include "meshes/examine_mesh.h"
#include "repair/repair_mesh.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <pybind11/stl.h>

#include <exception>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The program's check and repair of meshes, of arrays instead of files.

namespace vfc_python {

namespace {

// Calls a function of a watch without the interpreter's lock. The function `progress` receives the
// step and the seconds. What it raises waits until the work has ended, since steps of a repair take
// a std::exception for their own failure.
template <typename Function>
auto watched(const Function& function, const py::object& progress)
{
  require_function(progress);
  std::exception_ptr raised;
  const auto tell = [&](const std::string& step, double seconds) {
    const Interpreter_lock lock;
    try {
      if(PyErr_CheckSignals() != 0) throw py::error_already_set();
      if(progress.is_none()) return true;
      py::dict d;
      d["stage"] = step;
      d["seconds"] = seconds;
      return goes_on(called(progress, d));
    } catch(...) {
      raised = std::current_exception();
      return false;
    }
  };
  vfc::Work_watch watch(vfc::Work_watch::never, tell);
  try {
    const Interpreter_unlock unlock;
    return function(watch);
  } catch(const vfc::Work_stopped&) {
    if(raised) std::rethrow_exception(raised);
    throw VFC::Run_interrupted();
  }
}

vfc::Mesh_soup soup_of(Triangles triangles)
{
  vfc::Mesh_soup soup;
  soup.points = std::move(triangles.points);
  soup.faces = std::move(triangles.faces);
  soup.face_numbers.resize(soup.faces.size());
  std::iota(soup.face_numbers.begin(), soup.face_numbers.end(), std::size_t(1));
  return soup;
}

// The rows of an array that have these numbers from 1.
Integers rows_of(const std::vector<std::size_t>& numbers)
{
  Integers rows(static_cast<py::ssize_t>(numbers.size()));
  for(std::size_t i = 0; i < numbers.size(); ++i)
    rows.mutable_at(static_cast<py::ssize_t>(i)) = static_cast<std::int64_t>(numbers[i]) - 1;
  return rows;
}

vfc::Mesh_findings examined(const vfc::Mesh_soup& soup, const py::object& progress)
{
  return watched(
      [&](vfc::Work_watch& watch) {
        vfc::Mesh_findings findings("");
        watch.begin("checking");
        vfc::examine(soup, findings, watch);
        return findings;
      },
      progress);
}

// What the program mends as it reads a mesh, without a word; here only repair() does.
const std::map<std::string, const char*> mended_in_reading = {
    {"coincident vertices", "merged vertices at the same place"},
    {"mixed orientation", "turned faces"},
    {"non-manifold vertex", "split vertices between surfaces"}};

bool is_closed_surface(const Triangles& triangles)
{
  const Interpreter_unlock unlock;
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(!PMP::is_polygon_soup_a_polygon_mesh(triangles.faces)) return false;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(triangles.points, triangles.faces, mesh);
  return CGAL::is_closed(mesh);
}

py::list check(const Doubles& vertices, const Integers& faces, const py::object& progress)
{
  const Triangles triangles = triangles_of(vertices, faces);
  const vfc::Mesh_findings findings = examined(soup_of(triangles), progress);
  const bool is_taken = is_closed_surface(triangles);
  py::list result;
  for(const vfc::Defect& defect : findings.list()) {
    py::dict d;
    d["kind"] = defect.kind;
    d["is_error"] = defect.is_error || (!is_taken && mended_in_reading.count(defect.kind) > 0);
    d["message"] = defect.message;
    d["vertices"] = rows_of(defect.nodes);
    d["faces"] = rows_of(defect.faces);
    result.append(d);
  }
  return result;
}

// Nothing can be mended of coordinates that are no numbers, for example.
void require_mendable(const vfc::Mesh_findings& findings)
{
  if(!findings.has_error() || findings.is_mendable()) return;
  for(const vfc::Defect& defect : findings.list())
    if(defect.is_error)
      throw std::invalid_argument(
          defect.kind + ": " + defect.message +
          (defect.nodes.empty() ? "" : ", vertex " + std::to_string(defect.nodes[0] - 1)));
}

py::dict repair(const Doubles& vertices,
                const Integers& faces,
                double alpha,
                const py::object& progress)
{
  if(!(alpha >= 0)) throw std::invalid_argument("alpha must not be negative");
  const Triangles triangles = triangles_of(vertices, faces);
  const vfc::Mesh_soup soup = soup_of(triangles);
  const vfc::Mesh_findings findings = examined(soup, progress);
  require_mendable(findings);
  std::vector<std::string> steps;
  if(!is_closed_surface(triangles))
    for(const vfc::Defect& defect : findings.list())
      if(const auto found = mended_in_reading.find(defect.kind); found != mended_in_reading.end())
        steps.emplace_back(found->second);
  vfc::Mesh mesh;
  const auto [mending, is_sound] = watched(
      [&](vfc::Work_watch& watch) {
        const vfc::Mending done = vfc::repair_mesh(soup, alpha, mesh, watch);
        return std::pair(done, vfc::is_sound(mesh, watch));
      },
      progress);
  if(!is_sound) throw std::invalid_argument("the mesh cannot be repaired: no face has an area");
  const py::tuple arrays = arrays_of(mesh);
  py::dict d;
  d["vertices"] = arrays[0];
  d["faces"] = arrays[1];
  steps.insert(steps.end(), mending.steps.begin(), mending.steps.end());
  d["steps"] = steps;
  d["distance_from_input"] = mending.from_file;
  d["distance_to_result"] = mending.to_mended;
  return d;
}

} // namespace

void bind_meshes(py::module_& module)
{
  module.def("check_mesh", &check);
  module.def("repair", &repair);
}

} // namespace vfc_python
