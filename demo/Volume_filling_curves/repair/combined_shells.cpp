// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "repair/combined_shells.h"

#include <CGAL/Volume_filling_curves/internal/support/cgal_compatibility.h>

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace vfc {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

auto watched(const Mesh& mesh, Work_watch& watch)
{
  return CGAL::parameters::vertex_point_map(Watched_points(mesh, watch))
      .throw_on_self_intersection(true);
}

// Replaces `a` by its union, intersection or difference with `b`. CGAL has a function for each, and
// each is a template of its own: five took 147 s to compile, and this one takes 113.
void combine(PMP::Corefinement::Boolean_operation_type kind, Mesh& a, Mesh& b, Work_watch& watch)
{
  Mesh result;
  std::array<CGAL::Volume_filling_curves::internal::Optional<Mesh*>, 4> results;
  results[kind] = &result;
  const auto output = watched(result, watch);
  const bool is_manifold = PMP::corefine_and_compute_boolean_operations(
      a, b, results, watched(a, watch), watched(b, watch),
      std::make_tuple(output, output, output, output))[kind];
  // CGAL may wrongly report success if a shell touches itself in a vertex.
  if(!is_manifold || !CGAL::is_closed(result) || !result.is_valid(false))
    throw std::runtime_error("the result is no closed manifold");
  a = std::move(result);
}

std::optional<Mesh> combined_or_nothing(PMP::Corefinement::Boolean_operation_type kind,
                                        Mesh& a,
                                        Mesh& b,
                                        Work_watch& watch)
{
  try {
    combine(kind, a, b, watch);
    a.collect_garbage();
    return std::move(a);
  } catch(const std::exception&) {
    return std::nullopt;
  }
}

// Unites them in pairs: no shell takes part in more than log2(n) unions.
Mesh united(std::vector<Mesh> shells, Work_watch& watch)
{
  for(; shells.size() > 1; shells.resize((shells.size() + 1) / 2))
    for(std::size_t i = 0; i < shells.size() / 2; ++i)
      combine(PMP::Corefinement::UNION, shells[i], shells[shells.size() - 1 - i], watch);
  return std::move(shells[0]);
}

bool is_smaller(const Mesh& a, const Mesh& b)
{
  return std::abs(PMP::volume(a)) < std::abs(PMP::volume(b));
}

Combined_shells combined_or_throw(std::vector<Mesh> shells, Work_watch& watch)
{
  const bool is_outward =
      PMP::is_outward_oriented(*std::max_element(shells.begin(), shells.end(), is_smaller));
  const auto first_cavity =
      std::stable_partition(shells.begin(), shells.end(), [&](const Mesh& shell) {
        return PMP::is_outward_oriented(shell) == is_outward;
      });
  for(Mesh& shell : shells)
    if(!PMP::is_outward_oriented(shell)) PMP::reverse_face_orientations(shell);
  std::vector<Mesh> cavities(std::make_move_iterator(first_cavity),
                             std::make_move_iterator(shells.end()));
  shells.erase(first_cavity, shells.end());
  const std::size_t number = cavities.size();
  Mesh surface = united(std::move(shells), watch);
  if(number > 0) {
    Mesh hollow = united(std::move(cavities), watch);
    combine(PMP::Corefinement::TM1_MINUS_TM2, surface, hollow, watch);
  }
  surface.collect_garbage();
  if(!is_outward) PMP::reverse_face_orientations(surface);
  return {std::move(surface), number};
}

} // namespace

std::optional<Mesh> difference(Mesh mesh, Mesh other, Work_watch& watch)
{
  return combined_or_nothing(PMP::Corefinement::TM1_MINUS_TM2, mesh, other, watch);
}

std::optional<Mesh> intersection(Mesh mesh, Mesh other, Work_watch& watch)
{
  return combined_or_nothing(PMP::Corefinement::INTERSECTION, mesh, other, watch);
}

Combined_shells combined(std::vector<Mesh> shells, Work_watch& watch)
{
  try {
    return combined_or_throw(std::move(shells), watch);
  } catch(const std::exception&) {
    return {};
  }
}

} // namespace vfc
