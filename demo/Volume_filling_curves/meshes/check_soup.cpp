// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace rules = CGAL::Volume_filling_curves::internal;

void check_coordinates(const Mesh_soup& soup, Mesh_findings& findings)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(const auto fault = rules::coordinate_fault(soup.points[v]))
      findings.add_error(*fault, {0, {v + 1}});
}

// Whether a negative index of an OBJ file, which counts backwards, was too small.
bool is_before_the_first(std::size_t v)
{
  return static_cast<std::ptrdiff_t>(v) < 0;
}

void check_indices(const Mesh_soup& soup, Mesh_findings& findings)
{
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    for(const std::size_t v : soup.faces[f])
      if(v >= soup.points.size())
        findings.add_error("bad index",
                           is_before_the_first(v)
                               ? "a face refers to a vertex before the first"
                               : "a face refers to vertex " + std::to_string(v + 1) + " of " +
                                     std::to_string(soup.points.size()),
                           {0, {}, {soup.face_numbers[f]}});
}

void merge_equal_points(Mesh_soup& soup, Mesh_findings& findings)
{
  std::vector<std::size_t> copies;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(soup.file_index(v) != v) copies.push_back(v + 1);
  if(copies.empty()) return;
  PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.faces);
  findings.add_warning("coincident vertices",
                       counted(copies.size(), "vertex repeats another one and was merged with it",
                               "vertices repeat others and were merged with them"),
                       {0, copies});
}

void remove_degenerate_faces(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch)
{
  std::size_t kept = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    watch.check();
    const auto [a, b, c] = soup.faces[f];
    if(!CGAL::collinear(soup.points[a], soup.points[b], soup.points[c])) {
      soup.faces[kept] = soup.faces[f];
      soup.face_numbers[kept++] = soup.face_numbers[f];
      continue;
    }
    const bool is_repeated = a == b || b == c || c == a;
    findings.add_error(is_repeated
                           ? rules::Mesh_fault{"degenerate face", "a face uses a vertex twice" +
                                                                      near_text(soup.points[a])}
                           : rules::flat_face_fault(soup.points[a], soup.points[b], soup.points[c]),
                       {0, soup.numbers({a, b, c}), {soup.face_numbers[f]}});
  }
  soup.faces.resize(kept);
  soup.face_numbers.resize(kept);
}

void remove_isolated_points(Mesh_soup& soup, Mesh_findings& findings)
{
  std::vector<bool> is_used(soup.points.size(), false);
  for(const auto& face : soup.faces)
    for(const std::size_t v : face) is_used[v] = true;
  std::vector<std::size_t> isolated;
  for(std::size_t v = 0; v < is_used.size(); ++v)
    if(!is_used[v]) isolated.push_back(v);
  if(isolated.empty()) return;
  findings.add_warning("isolated vertex",
                       counted(isolated.size(), "vertex has", "vertices have") + " no face",
                       {0, soup.numbers(isolated)});
  PMP::remove_isolated_points_in_polygon_soup(soup.points, soup.faces);
}

void find_repeated_faces(const Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch)
{
  std::map<Mesh_soup::Face, std::size_t> first;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    watch.check();
    Mesh_soup::Face corners = soup.faces[f];
    std::sort(corners.begin(), corners.end());
    const auto [it, is_new] = first.insert({corners, f});
    if(!is_new)
      findings.add_error("duplicate face",
                         "two faces have the same corners" + near_text(soup.points[corners[0]]),
                         {0,
                          soup.numbers({corners[0], corners[1], corners[2]}),
                          {soup.face_numbers[it->second], soup.face_numbers[f]}});
  }
}

} // namespace

void check_soup(Mesh_soup& soup, Mesh_findings& findings, Work_watch& watch)
{
  if(soup.points.empty() || soup.faces.empty())
    return findings.add_error("no geometry",
                              soup.points.empty() ? "there are no vertices" : "there are no faces");
  check_coordinates(soup, findings);
  check_indices(soup, findings);
  if(findings.has_error()) return;
  soup.record_file_indices();
  watch.check();
  if(const auto fault = rules::size_fault(soup.points)) findings.add_error(*fault);
  merge_equal_points(soup, findings);
  remove_degenerate_faces(soup, findings, watch);
  remove_isolated_points(soup, findings);
  find_repeated_faces(soup, findings, watch);
}

} // namespace vfc
