// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_BUILDER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_BUILDER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/drawing/Tube_sections.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Builder that adds tubes to a mesh: the polygons of the sections, joined by triangles, and caps at
// open ends. All faces are oriented outward.
template <typename Mesh, typename PointMap>
class Tube_builder
{
public:
  Tube_builder(Mesh& mesh, const PointMap& point_map) : m_mesh(mesh), m_point_map(point_map) {}

  // Adds a tube; `radii` has the radius of each section.
  void add(const Tube_sections& sections, const std::vector<double>& radii)
  {
    m_number_of_sides = sections.number_of_sides();
    const Ring first = add_ring(sections, radii, 0);
    if(!sections.is_closed()) add_cap(first, false);
    Ring last = first;
    for(std::size_t i = 1; i < sections.size(); ++i) {
      check_run();
      Ring ring = add_ring(sections, radii, i);
      add_side(last, ring, 0);
      last = std::move(ring);
    }
    if(sections.is_closed())
      add_side(last, first, sections.shift());
    else
      add_cap(last, true);
  }

private:
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Point_3 = typename boost::property_traits<PointMap>::value_type;

  // The polygon of a section in the mesh.
  struct Ring
  {
    Vector center;
    std::vector<Vector> arms; // from the center to the corners
    std::vector<Vertex> corners;
  };

  Vertex add_point(const Vector& p)
  {
    using boost::put;
    const Vertex v = add_vertex(m_mesh);
    put(m_point_map, v, Point_3(p.x(), p.y(), p.z()));
    return v;
  }

  Ring add_ring(const Tube_sections& sections, const std::vector<double>& radii, std::size_t i)
  {
    Ring ring{sections.center(i), {}, {}};
    for(std::size_t l = 0; l < m_number_of_sides; ++l) {
      ring.arms.push_back(radii[i] * sections.arm(i, l));
      ring.corners.push_back(add_point(ring.center + ring.arms[l]));
    }
    return ring;
  }

  // Joins two rings by triangles; corner l of `a` is opposite corner l + shift of `b`.
  void add_side(const Ring& a, const Ring& b, std::size_t shift)
  {
    for(std::size_t l = 0; l < m_number_of_sides; ++l) {
      const std::array<std::size_t, 2> on_a = {l, (l + 1) % m_number_of_sides};
      const std::array<std::size_t, 2> on_b = {(on_a[0] + shift) % m_number_of_sides,
                                               (on_a[1] + shift) % m_number_of_sides};
      const Vertex a0 = a.corners[on_a[0]], a1 = a.corners[on_a[1]];
      const Vertex b0 = b.corners[on_b[0]], b1 = b.corners[on_b[1]];
      const bool from_a0 = is_cut_from_first(a, on_a, b, on_b);
      add_triangle(a0, a1, from_a0 ? b1 : b0);
      add_triangle(from_a0 ? a0 : a1, b1, b0);
    }
  }

  // Returns whether to cut the quadrangle a0, a1, b1, b0 from a0 to b1, not from a1 to b0. If the
  // tetrahedron between the cut and the center of `a` were inverted, the surface would fold. Sharp
  // corners at both ends can invert it for one cut, but not for both: to first order in the radius,
  // the sum of the two volumes is a mixed discriminant of two positive matrices, which squeeze the
  // circles of the sections as seen along the edge.
  static bool is_cut_from_first(const Ring& a,
                                const std::array<std::size_t, 2>& on_a,
                                const Ring& b,
                                const std::array<std::size_t, 2>& on_b)
  {
    constexpr double much_less = 0.5; // both cuts are equal in straight tubes, up to rounding
    const Vector step = b.center - a.center;
    const Vector face = in_own_units(step + b.arms[on_b[1]])
                            .normalized()
                            .cross(in_own_units(step + b.arms[on_b[0]]).normalized());
    const double first = face.dot(in_own_units(a.arms[on_a[0]]).normalized());
    const double second = face.dot(in_own_units(a.arms[on_a[1]]).normalized());
    return first >= much_less * second;
  }

  void add_cap(const Ring& ring, bool is_end)
  {
    const Vertex center = add_point(ring.center);
    for(std::size_t l = 0; l < m_number_of_sides; ++l) {
      const Vertex here = ring.corners[l], next = ring.corners[(l + 1) % m_number_of_sides];
      add_triangle(center, is_end ? here : next, is_end ? next : here);
    }
  }

  void add_triangle(Vertex a, Vertex b, Vertex c)
  {
    CGAL::Euler::add_face(std::array<Vertex, 3>{a, b, c}, m_mesh);
  }

  Mesh& m_mesh;
  PointMap m_point_map;
  std::size_t m_number_of_sides = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DRAWING_TUBE_BUILDER_H
