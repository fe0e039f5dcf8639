// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_checks.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace vfc {
namespace {

// A corner of a face: its vertex, and the vertices of the face after and before that.
struct Corner
{
  std::size_t vertex, next, last;
};

using Corners = std::vector<Corner>;

bool is_before(const Corner& c, const Corner& d)
{
  return std::tie(c.vertex, c.next) < std::tie(d.vertex, d.next);
}

// Goes from face to face around a vertex. \pre the corners are sorted
bool are_one_circle(Corners::const_iterator first, Corners::const_iterator beyond)
{
  auto corner = first;
  auto left = beyond - first;
  do {
    --left;
    const Corner wanted{first->vertex, corner->last, 0};
    corner = std::lower_bound(first, beyond, wanted, is_before);
    if(corner == beyond || corner->next != wanted.next) return false;
  } while(corner != first && left > 0);
  return corner == first && left == 0;
}

} // namespace

bool is_closed_and_oriented(const Mesh_soup& soup)
{
  Corners corners;
  corners.reserve(3 * soup.faces.size());
  for(const auto& [a, b, c] : soup.faces)
    for(const Corner& corner : {Corner{a, b, c}, Corner{b, c, a}, Corner{c, a, b}})
      corners.push_back(corner);
  std::sort(corners.begin(), corners.end(), is_before);
  for(auto first = corners.cbegin(), beyond = first; first != corners.cend(); first = beyond) {
    const auto is_other = [&](const Corner& c) { return c.vertex != first->vertex; };
    beyond = std::find_if(first, corners.cend(), is_other);
    if(!are_one_circle(first, beyond)) return false;
  }
  return true;
}

} // namespace vfc
