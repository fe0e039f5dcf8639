// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PROJECTION_PREDICATES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PROJECTION_PREDICATES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Direction towards the viewer, in integers of at most 2^20; every embedded curve has a generic
// one.
using Viewing_direction = std::array<int, 3>;

// Exact predicates of points projected along an integer direction. A double and its error bound
// nearly always decide; rational numbers decide the remaining cases.
class Projection_predicates
{
public:
  // A double, and a bound of its error.
  struct Approximation
  {
    double value, error;
  };

  Projection_predicates(const std::vector<Vector>& points, const Viewing_direction& direction)
      : m_points(points), m_direction(direction)
  {}

  // whether the image of r is on the left of the line from that of p to that of q, on it, or right
  Sign turn(std::size_t p, std::size_t q, std::size_t r) const
  {
    const Approximation area = approximate_area(p, q, r);
    if(std::abs(area.value) > area.error) return area.value > 0 ? POSITIVE : NEGATIVE;
    return CGAL::sign(exact_area(p, q, r));
  }

  // whether r is seen in the direction of q from p, if the three images are on a line
  Sign direction_on_line(std::size_t p, std::size_t q, std::size_t r) const
  {
    const auto [qx, qy] = exact_image(p, q);
    const auto [rx, ry] = exact_image(p, r);
    return CGAL::sign(qx * rx + qy * ry);
  }

  // The position on the edge pq, from 0 to 1, where its image crosses that of the edge rs.
  Approximation approximate_place(std::size_t p, std::size_t q, std::size_t r, std::size_t s) const
  {
    const Approximation from = approximate_area(r, s, p), to = approximate_area(r, s, q);
    const double total = std::abs(from.value - to.value), error = 2 * (from.error + to.error);
    constexpr double rounding = 1e-15, decided = 0.01; // where the error is small, it is linear
    if(!(error < decided * total)) return {0, 1};
    return {std::abs(from.value) / total, error / total + rounding};
  }

  Exact_rational exact_place(std::size_t p, std::size_t q, std::size_t r, std::size_t s) const
  {
    const Exact_rational from = exact_area(r, s, p), to = exact_area(r, s, q);
    return from / (from - to);
  }

  // The orientation of the tetrahedron of four points.
  Sign orientation(std::size_t p, std::size_t q, std::size_t r, std::size_t s) const
  {
    return CGAL::orientation(point(p), point(q), point(r), point(s));
  }

private:
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;

  Point_3 point(std::size_t v) const
  {
    const Vector& p = m_points[v];
    return {p.x(), p.y(), p.z()};
  }

  // The determinant of pq, pr and the direction. The bound is Shewchuk's (1997) for the orientation
  // of four points, and covers underflow.
  Approximation approximate_area(std::size_t p, std::size_t q, std::size_t r) const
  {
    constexpr double relative_error = 8 * 0x1p-53, underflow = 1e-290;
    const Vector u = m_points[q] - m_points[p], v = m_points[r] - m_points[p];
    double area = 0, size = 0;
    for(int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double plus = u[i] * v[j], minus = u[j] * v[i], d = m_direction[std::size_t(k)];
      area += d * (plus - minus);
      size += std::abs(d) * (std::abs(plus) + std::abs(minus));
    }
    return {area, relative_error * size + underflow};
  }

  Exact_rational exact_difference(std::size_t p, std::size_t q, int k) const
  {
    return Exact_rational(m_points[q][k]) - Exact_rational(m_points[p][k]);
  }

  Exact_rational exact_area(std::size_t p, std::size_t q, std::size_t r) const
  {
    Exact_rational area(0);
    for(int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      area += Exact_rational(m_direction[std::size_t(k)]) *
              (exact_difference(p, q, i) * exact_difference(p, r, j) -
               exact_difference(p, q, j) * exact_difference(p, r, i));
    }
    return area;
  }

  // The image of the vector pq in a plane across the direction, in a basis of that plane that need
  // not be orthonormal.
  std::array<Exact_rational, 2> exact_image(std::size_t p, std::size_t q) const
  {
    const std::size_t k = m_direction[2] != 0 ? 2 : m_direction[1] != 0 ? 1 : 0;
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    // The type matters: an expression of GMP would refer to temporaries.
    const auto coordinate = [&](std::size_t axis) -> Exact_rational {
      return exact_difference(p, q, int(axis)) * Exact_rational(m_direction[k]) -
             exact_difference(p, q, int(k)) * Exact_rational(m_direction[axis]);
    };
    return {coordinate(i), coordinate(j)};
  }

  const std::vector<Vector>& m_points;
  const Viewing_direction m_direction;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PROJECTION_PREDICATES_H
