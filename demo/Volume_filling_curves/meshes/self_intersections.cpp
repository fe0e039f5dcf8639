// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/self_intersections.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Corners = std::array<Mesh::Vertex_index, 3>;

constexpr std::size_t most_pairs = Mesh_findings::most_counted; // can be quadratically many

struct Enough_pairs
{};

Corners corners_of(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

// Where a surface touches itself in a vertex, faces of a mesh meet in a point but not in a vertex.
// Such a pair is tried once more as a mesh of its own, in which they do. \pre no vertex is shared
bool do_only_touch(const Mesh& mesh, const Face_pair& pair)
{
  Mesh both;
  Corners first = corners_of(mesh, pair.first), second = corners_of(mesh, pair.second);
  const Corners before = first;
  for(auto& v : first) v = both.add_vertex(mesh.point(v));
  std::size_t common = 0;
  for(auto& v : second) {
    std::size_t i = 0;
    while(i < 3 && mesh.point(before[i]) != mesh.point(v)) ++i;
    v = i < 3 ? first[i] : both.add_vertex(mesh.point(v));
    if(i < 3) ++common;
  }
  if(common == 0 || common == 3) return false;
  both.add_face(first[0], first[1], first[2]);
  // with a common edge only one of the two orientations fits
  if(both.add_face(second[0], second[1], second[2]) == Mesh::null_face())
    both.add_face(second[0], second[2], second[1]);
  return !PMP::does_self_intersect(both);
}

bool share_a_vertex(const Mesh& mesh, const Face_pair& pair)
{
  const Corners first = corners_of(mesh, pair.first), second = corners_of(mesh, pair.second);
  return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) !=
         first.end();
}

} // namespace

std::vector<Face_pair> intersecting_faces(const Mesh& mesh)
{
  std::vector<Face_pair> pairs;
  const auto add = [&](const Face_pair& pair) {
    if(!share_a_vertex(mesh, pair) && do_only_touch(mesh, pair)) return;
    pairs.push_back(std::minmax(pair.first, pair.second));
    if(pairs.size() == most_pairs) throw Enough_pairs();
  };
  try {
    PMP::self_intersections(mesh, boost::make_function_output_iterator(add));
  } catch(const Enough_pairs&) {
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void report_self_intersections(const Mesh& mesh, const Mesh_soup& soup, Mesh_findings& findings)
{
  for(const auto& [f, g] : intersecting_faces(mesh))
    findings.add_error("self-intersection",
                       "two faces intersect" + near(mesh.point(corners_of(mesh, f)[0])),
                       {0, {}, {soup.face_numbers[f], soup.face_numbers[g]}});
}

} // namespace vfc
