// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Mends arbitrary triangles between the points of a small lattice, where faces overlap, touch and
// cross in every way. The result must be sound, unless no face has an area. Build with
// clang++ -fsanitize=fuzzer,address,undefined.

#include "meshes/examine_mesh.h"
#include "repair/repair_mesh.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

// Each byte is a point, four to a side; three bytes are a face.
constexpr std::size_t max_faces = 40;

vfc::Mesh_soup::Point lattice_point(std::size_t number)
{
  return {static_cast<double>(number % 4), static_cast<double>(number / 4 % 4),
          static_cast<double>(number / 16)};
}

vfc::Mesh_soup lattice_faces(const std::uint8_t* data, std::size_t size)
{
  vfc::Mesh_soup soup;
  for(std::size_t v = 0; v < 64; ++v) soup.points.push_back(lattice_point(v));
  for(std::size_t f = 0; f < std::min(size / 3, max_faces); ++f) {
    const std::uint8_t* corners = data + 3 * f;
    soup.faces.push_back({corners[0] % 64u, corners[1] % 64u, corners[2] % 64u});
    soup.face_numbers.push_back(f + 1);
  }
  return soup;
}

bool has_area(const vfc::Mesh_soup& soup)
{
  return std::any_of(soup.faces.begin(), soup.faces.end(), [&](const vfc::Mesh_soup::Face& face) {
    return !CGAL::collinear(soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]);
  });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const vfc::Mesh_soup soup = lattice_faces(data, size);
  vfc::Mesh mesh;
  vfc::Work_watch watch;
  const double alpha = 1; // the lattice has a side of 3; wrapping finer than this takes seconds
  vfc::repair_mesh(soup, alpha, mesh, watch);
  if(has_area(soup) && !vfc::is_sound(mesh, watch)) std::abort();
  return 0;
}
