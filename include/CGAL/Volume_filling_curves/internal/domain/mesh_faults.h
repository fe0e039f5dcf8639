// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_FAULTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_FAULTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Faults of meshes that bound no domain, with the same wording for the library, which throws the
// first one, and for programs, which list all. This file has the faults of single points and faces;
// mesh_holes.h, intersecting_faces.h and nested_shells.h have those of the surface.
struct Mesh_fault
{
  std::string kind, message;
};

// The volume, a sum of products of three coordinates, stays in the range of double.
constexpr double max_mesh_coordinate = 1e100, min_mesh_size = 1e-100;

template <typename Point_3>
std::string near_text(const Point_3& p)
{
  return " near " + point_text(p);
}

template <typename Point_3>
std::optional<Mesh_fault> coordinate_fault(const Point_3& p)
{
  double largest = 0;
  for(const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}) {
    if(!std::isfinite(x)) return Mesh_fault{"non-finite coordinate", "a coordinate is not finite"};
    largest = (std::max)(largest, std::abs(x));
  }
  if(largest <= max_mesh_coordinate) return std::nullopt;
  return Mesh_fault{"coordinate too large", "a coordinate is beyond 1e100"};
}

template <typename Points>
bool are_coplanar(const Points& points)
{
  const auto first = points.begin();
  const auto& p = *first;
  const auto q = std::find_if(first, points.end(), [&](const auto& x) { return x != p; });
  if(q == points.end()) return true;
  const auto r =
      std::find_if(q, points.end(), [&](const auto& x) { return !CGAL::collinear(p, *q, x); });
  return r == points.end() ||
         std::all_of(r, points.end(), [&](const auto& x) { return CGAL::coplanar(p, *q, *r, x); });
}

// \pre there are points
template <typename Points>
std::optional<Mesh_fault> size_fault(const Points& points)
{
  CGAL::Bbox_3 box;
  for(const auto& p : points) box += p.bbox();
  if((std::max)({box.x_span(), box.y_span(), box.z_span()}) < min_mesh_size)
    return Mesh_fault{"size too small", "the size of the mesh is below 1e-100"};
  if(are_coplanar(points)) return Mesh_fault{"zero volume", "all vertices lie in a plane"};
  return std::nullopt;
}

template <typename Point_3>
Mesh_fault flat_face_fault(const Point_3& p, const Point_3& q, const Point_3& r)
{
  return {"degenerate face",
          "the corners of a face lie on a line" + near_text((std::min)({p, q, r}))};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_MESH_FAULTS_H
