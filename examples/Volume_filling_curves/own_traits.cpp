// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Untangles a curve with a user-defined point type. The traits class, a model of CurveFlowTraits_3,
// leaves the exact predicates to a kernel of CGAL.

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/generators.h>
#include <CGAL/Volume_filling_curves/untangle.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdlib>
#include <iostream>

namespace VFC = CGAL::Volume_filling_curves;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The point type of another library
struct Point
{
  double coordinates[3];

  double x() const { return coordinates[0]; }
  double y() const { return coordinates[1]; }
  double z() const { return coordinates[2]; }
};

// Both types have coordinates of type double, so nothing is rounded.
Kernel::Point_3 to_kernel(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

// A predicate of the kernel for our points
template <typename Predicate>
struct Of_own_points
{
  template <typename... Points>
  auto operator()(const Points&... points) const
  {
    return Predicate()(to_kernel(points)...);
  }
};

//! [traits]
struct Own_traits
{
  using Point_3 = Point;
  using Vector_3 = Kernel::Vector_3; // directions in which domains measure distances

  struct Construct_point_3
  {
    Point operator()(double x, double y, double z) const { return {{x, y, z}}; }
  };

  using Orientation_3 = Of_own_points<Kernel::Orientation_3>;
  using Coplanar_orientation_3 = Of_own_points<Kernel::Coplanar_orientation_3>;
  using Less_xyz_3 = Of_own_points<Kernel::Less_xyz_3>;

  Construct_point_3 construct_point_3_object() const { return {}; }
  Orientation_3 orientation_3_object() const { return {}; }
  Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
  Less_xyz_3 less_xyz_3_object() const { return {}; }
};
//! [traits]

int main()
{
  VFC::Curve_network_3<Own_traits> curve = VFC::make_hard_unknot<Own_traits>(100, 2000, 1);
  const double length = VFC::length(curve);
  const VFC::Untangling_result result = VFC::untangle(curve);
  std::cout << result.status << ", from a length of " << length << " to " << VFC::length(curve)
            << '\n';
  return result.status == VFC::Untangling_status::UNKNOTTED ? EXIT_SUCCESS : EXIT_FAILURE;
}
