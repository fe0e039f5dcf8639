// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_DOMAIN_TEST_SUPPORT_H
#define VFC_TEST_DOMAIN_TEST_SUPPORT_H

#include "support/mesh_test_support.h"

#include <CGAL/Volume_filling_curves/Triangle_mesh_domain_3.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>

#include <cstddef>
#include <limits>

// Random points in and around domains.
namespace domain_test {

using namespace CGAL::Volume_filling_curves;
using meshes::Mesh;
using meshes::Point;
using meshes::Soup;
using Mesh_domain = Triangle_mesh_domain_3<>;
using Random = internal::Random_source;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Point random_point(Random& random, const CGAL::Bbox_3& box)
{
  const double x = random.real(), y = random.real(), z = random.real();
  return {box.xmin() + x * box.x_span(), box.ymin() + y * box.y_span(),
          box.zmin() + z * box.z_span()};
}

inline Point lattice_point(Random& random, std::size_t n)
{
  const auto x = static_cast<double>(random.index(n)), y = static_cast<double>(random.index(n));
  return {x, y, static_cast<double>(random.index(n))};
}

} // namespace domain_test

#endif // VFC_TEST_DOMAIN_TEST_SUPPORT_H
