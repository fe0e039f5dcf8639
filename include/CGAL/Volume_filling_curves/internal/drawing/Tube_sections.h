// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_SECTIONS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_SECTIONS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Sections of a tube around a curve without junctions: at each node a regular polygon in the plane
// that bisects the corner, with its corners on the circle of the tube's radius around the node. Two
// cylinders would meet in ellipses. With circles instead, the whole tube stays within its radius r
// of the curve, even outside a corner, and away from other strands. The discs at the ends of an
// edge of length l do not meet if r tan(a/2) < l/2 at both, where a is the turning angle: if r is
// below the bend radius (Rawdon's MinRad).
//
// Parallel transport carries the polygon from section to section by the least rotation. Once around
// a closed curve, the polygon has turned. This rotation, modulo whole sides of the polygon, is
// distributed evenly over the length. Linear time.
class Tube_sections
{
public:
  // Takes the nodes in the order of the curve; a closed curve does not repeat its first node.
  Tube_sections(std::vector<Vector> nodes, bool is_closed, std::size_t number_of_sides)
      : m_nodes(std::move(nodes)), m_is_closed(is_closed), m_number_of_sides(number_of_sides)
  {
    for(std::size_t l = 0; l < number_of_sides; ++l)
      m_corners.push_back(cos_sin(static_cast<double>(l) / static_cast<double>(number_of_sides)));
    find_directions();
    carry_first_axis();
    if(is_closed) close();
  }

  std::size_t size() const { return m_nodes.size(); }
  std::size_t number_of_sides() const { return m_number_of_sides; }
  bool is_closed() const { return m_is_closed; }
  const Vector& center(std::size_t i) const { return m_nodes[i]; }

  // The unit vector from the center of section i to corner l. Against the direction of the curve,
  // corners are seen in counterclockwise order.
  Vector arm(std::size_t i, std::size_t l) const
  {
    return m_corners[l][0] * m_axes[i] + m_corners[l][1] * m_normals[i].cross(m_axes[i]);
  }

  // In a closed curve, corner l of the last section continues as corner l + shift() of the first.
  std::size_t shift() const { return m_shift; }

private:
  void find_directions()
  {
    const std::size_t n = m_nodes.size(), number_of_edges = m_is_closed ? n : n - 1;
    for(std::size_t i = 0; i < number_of_edges; ++i)
      m_tangents.push_back(in_own_units(m_nodes[(i + 1) % n] - m_nodes[i]).normalized());
    for(std::size_t i = 0; i < n; ++i) {
      const bool is_start = !m_is_closed && i == 0, is_end = !m_is_closed && i + 1 == n;
      const Vector& out = m_tangents[is_end ? i - 1 : i];
      const Vector& in = is_start ? out : m_tangents[(i + n - 1) % n];
      const bool turns_back = in == -out;
      m_normals.push_back(turns_back ? out.unitOrthogonal() : (in + out).normalized());
    }
  }

  // Applies to v the least rotation that takes the unit vector `from` to `to`. \pre v is orthogonal
  // to `from`
  static Vector carried(const Vector& v, const Vector& from, const Vector& to)
  {
    const Vector mirror = (from + to).normalized();
    return v - 2 * v.dot(mirror) * mirror;
  }

  // Returns the axis carried from section i to the next.
  Vector carried(const Vector& axis, std::size_t i) const
  {
    const Vector& normal = m_normals[(i + 1) % size()];
    const Vector moved = carried(carried(axis, m_normals[i], m_tangents[i]), m_tangents[i], normal);
    return (moved - moved.dot(normal) * normal).normalized(); // rounding would add up
  }

  void carry_first_axis()
  {
    m_axes.push_back(m_normals[0].unitOrthogonal());
    for(std::size_t i = 0; i + 1 < size(); ++i) m_axes.push_back(carried(m_axes[i], i));
  }

  void close()
  {
    const auto sides = static_cast<double>(m_number_of_sides);
    const Vector end = carried(m_axes.back(), size() - 1);
    const double turns =
        std::atan2(end.dot(m_normals[0].cross(m_axes[0])), end.dot(m_axes[0])) / (2 * CGAL_PI);
    const double shift = std::round(turns * sides);
    m_shift = static_cast<std::size_t>(shift < 0 ? shift + sides : shift) % m_number_of_sides;
    spread_twist(turns - shift / sides);
  }

  void spread_twist(double turns)
  {
    std::vector<double> lengths(1, 0.); // from the first section
    for(std::size_t i = 0; i < size(); ++i)
      lengths.push_back(lengths[i] + stable_norm(m_nodes[(i + 1) % size()] - m_nodes[i]));
    for(std::size_t i = 0; i < size(); ++i) {
      const auto [c, s] = cos_sin(-turns * (lengths[i] / lengths.back()));
      m_axes[i] = c * m_axes[i] + s * m_normals[i].cross(m_axes[i]);
    }
  }

  std::vector<Vector> m_nodes;
  bool m_is_closed;
  std::size_t m_number_of_sides, m_shift = 0;
  std::vector<std::array<double, 2>> m_corners; // of the polygon, on the unit circle
  std::vector<Vector> m_tangents;               // of the edges
  std::vector<Vector> m_normals, m_axes;        // of the sections; axes point to the first corners
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_SECTIONS_H
