// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SPACE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SPACE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The set that a domain is a part of: space, or the plane z = 0. Its content is volume or area.
template <int dimension_>
struct Space
{
  static_assert(dimension_ == 2 || dimension_ == 3, "a domain has dimension 2 or 3");

  static constexpr int dimension = dimension_;
  static constexpr bool is_plane = dimension == 2;

  // of a cube, or a square, with sides of that length
  static double content(double side) { return is_plane ? side * side : side * side * side; }

  static double content(const Bbox_3& box)
  {
    return is_plane ? box.x_span() * box.y_span() : box.x_span() * box.y_span() * box.z_span();
  }

  // the side of the cube, or the square, with that content
  static double side(double content) { return is_plane ? std::sqrt(content) : cube_root(content); }

  // the corner of the unit cube, or the unit square, that is opposite to the origin
  static Vector ones() { return {1, 1, is_plane ? 0. : 1.}; }

  // a point of the unit cube, or the unit square
  static Vector random_point(Random_source& random)
  {
    const double x = random.real(), y = random.real(), z = is_plane ? 0 : random.real();
    return {x, y, z};
  }

  static Vector random_point(const Bbox_3& box, Random_source& random)
  {
    const Vector p = random_point(random);
    return {box.xmin() + p.x() * box.x_span(), box.ymin() + p.y() * box.y_span(),
            box.zmin() + p.z() * box.z_span()};
  }
};

// The dimension of a domain: 2 of one that lies in the plane z = 0, otherwise 3.
template <typename Domain, typename = void>
constexpr int dimension_of = 3;

template <typename Domain>
constexpr int dimension_of<Domain, std::void_t<decltype(Domain::dimension)>> = Domain::dimension;

template <typename Domain>
using Space_of = Space<dimension_of<Domain>>;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GEOMETRY_SPACE_H
