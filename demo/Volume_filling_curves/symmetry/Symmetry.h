// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Mirror images in a plane, and rotations about an axis.

#ifndef VFC_SYMMETRY_H
#define VFC_SYMMETRY_H

#include "files/mesh_files.h"

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

class Symmetry
{
public:
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

  // A half-space: the points p with (p - origin) * normal > 0, for a unit vector.
  struct Side
  {
    Point origin;
    Vector normal;
  };

  // Reads "mirror" or "rotation:K", followed by ":X,Y,Z,NX,NY,NZ" or not: a point of the plane and
  // its normal, or a point of the axis and its direction. Without them the plane is normal to the x
  // axis, the axis parallel to the z axis, and both pass through the middle of the box.
  // \throws Usage_error with the name of the option
  Symmetry(const std::string& text, const CGAL::Bbox_3& box);

  bool is_mirror() const { return m_is_mirror; }
  std::size_t order() const { return m_order; }

  // The k-th image, of order() ones; the 0-th is p itself.
  Point image(const Point& p, std::size_t k) const;

  // The sides of the one or two planes that bound a sector. Its images fill space.
  std::vector<Side> sides() const;

  // The point of the plane, or of the half-plane where a sector begins, with these coordinates; the
  // first one is the distance from the axis.
  Point point_of_cut(double s, double t) const;

private:
  Vector rotated(const Vector& v, double angle) const;
  double angle_of_sector() const;

  bool m_is_mirror = false;
  std::size_t m_order = 2;
  Point m_origin;
  Vector m_direction;          // a unit vector
  Vector m_across, m_sideways; // with it an orthonormal basis
};

} // namespace vfc

#endif // VFC_SYMMETRY_H
