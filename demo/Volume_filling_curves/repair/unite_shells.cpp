// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/mesh_checks.h"
#include "options/numbers.h"
#include "repair/Groups.h"
#include "repair/combined_shells.h"
#include "repair/shells_apart.h"

#include <CGAL/Volume_filling_curves/internal/domain/nested_shells.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace rules = CGAL::Volume_filling_curves::internal;

// The shells of a mesh, and which of them can be united.
struct Shells
{
  explicit Shells(const Mesh& mesh) : shells(shells_apart(mesh)), are_sound(shells.size(), true)
  {
    for(std::size_t i = 0; i < shells.size(); ++i) {
      of_face.insert(of_face.end(), shells[i].number_of_faces(), i);
      are_sound[i] = CGAL::is_closed(shells[i]);
    }
  }

  std::vector<Mesh> shells;
  std::vector<bool> are_sound;      // closed and without self-intersections
  std::vector<std::size_t> of_face; // in the mesh of all shells together
};

// Unites the sets of shells that intersect.
void group_intersecting(const Mesh& mesh, Shells& shells, Groups& groups, Work_watch& watch)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for(const auto& [f, g] : intersecting_faces(mesh, watch)) {
    const std::size_t i = shells.of_face[f], j = shells.of_face[g];
    if(i == j) shells.are_sound[i] = false;
    pairs.emplace_back(i, j);
  }
  for(const auto& [i, j] : pairs)
    if(shells.are_sound[i] && shells.are_sound[j]) groups.unite(i, j);
}

// Unites the sets of shells that are directly nested with the same orientation.
void group_nested(const Mesh& mesh, const Shells& shells, Groups& groups)
{
  if(std::count(shells.are_sound.begin(), shells.are_sound.end(), false) > 0) return;
  std::vector<std::vector<Mesh::Face_index>> faces(shells.shells.size());
  for(const Mesh::Face_index f : mesh.faces()) faces[shells.of_face[f]].push_back(f);
  const auto nestings = rules::Shell_nesting_search<Mesh>::find(mesh, faces);
  for(std::size_t i = 0; i < nestings.size(); ++i)
    for(const std::size_t j : nestings[i].around)
      if(nestings[j].around.size() + 1 == nestings[i].around.size() &&
         nestings[i].is_outward == nestings[j].is_outward)
        groups.unite(i, j);
}

std::string done(std::size_t shells, std::size_t cavities)
{
  std::string text = std::to_string(shells) + " shells united that overlap or are nested";
  if(cavities > 0)
    text +=
        ", but for " + counted(cavities, "that is oriented inward and was subtracted as a cavity",
                               "that are oriented inward and were subtracted as cavities");
  return text;
}

} // namespace

std::string unite_shells(Mesh& mesh, Work_watch& watch)
{
  Shells shells(mesh);
  const Mesh together = shells_together(shells.shells);
  Groups groups(shells.shells.size());
  group_intersecting(together, shells, groups, watch);
  group_nested(together, shells, groups);

  std::vector<std::vector<Mesh>> members(shells.shells.size());
  for(std::size_t i = 0; i < members.size(); ++i)
    members[groups.of(i)].push_back(std::move(shells.shells[i]));
  std::vector<Mesh> results;
  std::size_t number = 0, cavities = 0;
  for(const std::vector<Mesh>& group : members) {
    const Combined_shells one = group.size() > 1 ? combined(group, watch) : Combined_shells();
    if(one.surface.is_empty()) {
      results.insert(results.end(), group.begin(), group.end());
      continue;
    }
    results.push_back(one.surface);
    number += group.size();
    cavities += one.cavities;
  }
  if(number == 0) return "";
  mesh = shells_together(results);
  return done(number, cavities);
}

} // namespace vfc
