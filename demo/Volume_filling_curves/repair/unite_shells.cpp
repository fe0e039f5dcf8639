// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/repair_steps.h"

#include "meshes/self_intersections.h"
#include "meshes/shell_places.h"
#include "repair/Groups.h"
#include "repair/shells_apart.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

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
void group_intersecting(const Mesh& mesh, Shells& shells, Groups& groups)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for(const auto& [f, g] : intersecting_faces(mesh)) {
    const std::size_t i = shells.of_face[f], j = shells.of_face[g];
    if(i == j) shells.are_sound[i] = false;
    pairs.emplace_back(i, j);
  }
  for(const auto& [i, j] : pairs)
    if(shells.are_sound[i] && shells.are_sound[j]) groups.unite(i, j);
}

// Unites the sets of shells one of which is directly within the other and turned the same way.
void group_nested(const Mesh& mesh, const Shells& shells, Groups& groups)
{
  if(std::count(shells.are_sound.begin(), shells.are_sound.end(), false) > 0) return;
  std::vector<std::vector<Mesh::Face_index>> faces(shells.shells.size());
  for(const Mesh::Face_index f : mesh.faces()) faces[shells.of_face[f]].push_back(f);
  const std::vector<Shell_place> places = places_of_shells(mesh, faces);
  for(std::size_t i = 0; i < places.size(); ++i)
    for(const std::size_t j : places[i].around)
      if(places[j].around.size() + 1 == places[i].around.size() &&
         places[i].is_outward == places[j].is_outward)
        groups.unite(i, j);
}

void turn(Mesh& shell, bool outward)
{
  if(PMP::is_outward_oriented(shell) != outward) PMP::reverse_face_orientations(shell);
}

// The surface of the union, turned as all of the shells were, or outward. \pre they are sound
Mesh united(std::vector<Mesh> shells)
{
  const bool is_cavity = std::none_of(shells.begin(), shells.end(), [](const Mesh& shell) {
    return PMP::is_outward_oriented(shell);
  });
  for(Mesh& shell : shells) turn(shell, true);
  // two by two, so that no shell takes part in more than log2(n) unions
  for(; shells.size() > 1; shells.resize((shells.size() + 1) / 2))
    for(std::size_t i = 0; i < shells.size() / 2; ++i) {
      Mesh& shell = shells[i];
      if(!PMP::corefine_and_compute_union(shell, shells[shells.size() - 1 - i], shell,
                                          CGAL::parameters::throw_on_self_intersection(true)))
        return Mesh();
    }
  if(is_cavity) PMP::reverse_face_orientations(shells[0]);
  return std::move(shells[0]);
}

// returns nothing where CGAL meets what it does not expect
Mesh try_to_unite(const std::vector<Mesh>& shells)
{
  try {
    return united(shells);
  } catch(const std::exception&) {
    return Mesh();
  }
}

} // namespace

std::string unite_shells(Mesh& mesh)
{
  Shells shells(mesh);
  const Mesh together = shells_together(shells.shells);
  Groups groups(shells.shells.size());
  group_intersecting(together, shells, groups);
  group_nested(together, shells, groups);

  std::vector<std::vector<Mesh>> members(shells.shells.size());
  for(std::size_t i = 0; i < members.size(); ++i)
    members[groups.of(i)].push_back(std::move(shells.shells[i]));
  std::vector<Mesh> results;
  std::size_t number = 0;
  for(const std::vector<Mesh>& group : members) {
    const Mesh one = group.size() > 1 ? try_to_unite(group) : Mesh();
    if(one.is_empty())
      results.insert(results.end(), group.begin(), group.end());
    else
      results.push_back(one);
    number += one.is_empty() ? 0 : group.size();
  }
  if(number == 0) return "";
  mesh = shells_together(results);
  return std::to_string(number) + " shells united that overlap or are nested";
}

} // namespace vfc
