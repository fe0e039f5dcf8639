// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_MESH_ENCLOSURE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_MESH_ENCLOSURE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/replay/Enclosure.h>
#include <CGAL/Volume_filling_curves/internal/replay/rational_geometry.h>
#include <CGAL/Volume_filling_curves/internal/replay/separating_directions.h>
#include <CGAL/Volume_filling_curves/internal/support/cgal_compatibility.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Exact count of the crossings of a ray in direction x with triangles. A ray that meets an edge or
// a vertex, or runs along a face, counts as moved by (0, e, e^2) with an infinitesimal e, which
// misses all edges: comparisons of coordinates count equality as "not above", and a zero
// determinant gets the sign of its change (Edelsbrunner and Muecke 1990). Hence every ray is valid.
// Trying rays until one misses all edges could fail: among coordinates of 2^52 times the size of a
// mesh, few points lie beyond it.

// returns whether the moved source lies, seen along x, where z is less than that of the edge ab
// with the same y, and the edge has a point with that y
inline bool is_below_edge(const Rational_vector& source,
                          const Rational_vector& a,
                          const Rational_vector& b)
{
  const bool is_rising = b[1] > source[1];
  if((a[1] > source[1]) == is_rising) return false;
  const Rational_vector along = b - a, to_source = source - a;
  Rational turn = along[1] * to_source[2] - along[2] * to_source[1];
  if(turn == 0) turn = along[2] != 0 ? -along[2] : along[1]; // of the infinitely small move
  return (turn < 0) == is_rising;
}

// returns whether the moved ray in direction x crosses a triangle.
// \pre the source is not on the triangle
inline bool does_ray_cross(const Position& source, const std::array<Position, 3>& triangle)
{
  const Rational_vector p = rational(source);
  const std::array<Rational_vector, 3> corners = {rational(triangle[0]), rational(triangle[1]),
                                                  rational(triangle[2])};
  bool is_hit = false; // by the line of the ray
  for(std::size_t k = 0; k < 3; ++k)
    is_hit = is_hit != is_below_edge(p, corners[k], corners[(k + 1) % 3]);
  if(!is_hit) return false;
  const Rational_vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return (dot(normal, corners[0] - p) > 0) == (normal[0] > 0);
}

using Triangle = std::array<Position, 3>;

// Inside of a closed triangle mesh, by an implementation that shares no code with
// Triangle_mesh_domain_3: CGAL's AABB tree finds the faces near a box, and questions that double
// arithmetic cannot settle are decided with rational numbers. Logarithmic time per triangle.
class Mesh_enclosure final : public Enclosure
{
public:
  // \pre the faces are those of a closed mesh
  explicit Mesh_enclosure(std::vector<Triangle> faces) : m_faces(std::move(faces))
  {
    for(const Triangle& face : m_faces) {
      m_triangles.emplace_back(point(face[0]), point(face[1]), point(face[2]));
      for(const Position& p : face) m_extent.add(p);
    }
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
  }

  // A ray from a point inside crosses the surface an odd number of times.
  bool is_inside(const Position& p) const override
  {
    if(!is_in_extent(p)) return false;
    const std::array<Position, 2> ray = {p, {m_extent.upper[0], p[1], p[2]}};
    bool is_odd = false;
    const bool is_on_surface = finds_near(box_of(ray), [&](const Triangle& face) {
      is_odd = is_odd != does_ray_cross(p, face);
      return !are_surely_apart({p, p}, face) && do_meet_exactly(p, p, face);
    });
    return is_odd && !is_on_surface;
  }

  bool is_triangle_inside(const Triangle& triangle) const override
  {
    return !finds_near(box_of(triangle),
                       [&](const Triangle& face) { return do_meet(triangle, face); });
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = Aabb_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>>;

  // Looks for a face of which `predicate` holds, among those whose boxes meet a given one.
  template <typename Predicate>
  struct Search
  {
    const Mesh_enclosure& mesh;
    const Predicate& predicate;
    bool has_found = false;

    bool go_further() const { return !has_found; }

    void intersection(const Bbox_3& box, const Primitive& primitive)
    {
      const auto i = primitive.id() - mesh.m_triangles.begin();
      has_found = CGAL::do_overlap(primitive.id()->bbox(), box) &&
                  predicate(mesh.m_faces[static_cast<std::size_t>(i)]);
    }

    template <typename Node>
    bool do_intersect(const Bbox_3& box, const Node& node) const
    {
      return CGAL::do_overlap(node.bbox(), box);
    }
  };

  template <typename Predicate>
  bool finds_near(const Bbox_3& box, const Predicate& predicate) const
  {
    Search<Predicate> search{*this, predicate};
    m_tree.traversal(box, search);
    return search.has_found;
  }

  static Kernel::Point_3 point(const Position& p) { return {p[0], p[1], p[2]}; }

  template <typename Points>
  static Bbox_3 box_of(const Points& points)
  {
    Bbox_3 box;
    for(const Position& p : points) box += point(p).bbox();
    return box;
  }

  bool is_in_extent(const Position& p) const
  {
    Extent extent;
    extent.add(p);
    return m_extent.meets(extent);
  }

  // Triangles meet if and only if an edge of one of them meets the other.
  static bool do_meet(const Triangle& s, const Triangle& t)
  {
    for(const Triangle* triangle : {&s, &t}) {
      const auto& [a, b, c] = *triangle;
      if(are_apart_in_direction(s, t, cross(difference(b, a), difference(c, a)))) return false;
    }
    return does_edge_meet(s, t) || does_edge_meet(t, s);
  }

  static bool does_edge_meet(const Triangle& s, const Triangle& t)
  {
    for(std::size_t k = 0; k < 3; ++k) {
      const std::array<Position, 2> edge = {s[k], s[(k + 1) % 3]};
      if(!are_surely_apart(edge, t) && do_meet_exactly(edge[0], edge[1], t)) return true;
    }
    return false;
  }

  std::vector<Triangle> m_faces;
  Triangles m_triangles;
  Extent m_extent;
  Tree m_tree;
};

// Returns the faces of a mesh, a model of FaceListGraph.
// \throws std::invalid_argument if it is no closed triangle mesh, or a coordinate is not finite
template <typename TriangleMesh>
std::vector<Triangle> faces_of_closed_mesh(const TriangleMesh& mesh)
{
  if(faces(mesh).begin() == faces(mesh).end() || !CGAL::is_triangle_mesh(mesh) ||
     !CGAL::is_closed(mesh))
    throw std::invalid_argument("the domain is no closed triangle mesh");
  const auto points = CGAL::get_const_property_map(CGAL::vertex_point, mesh);
  std::vector<Triangle> result;
  for(const auto f : faces(mesh)) {
    Triangle triangle;
    auto corner = triangle.begin();
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      *corner++ = to_position(get(points, v));
    for(const Position& p : triangle)
      if(!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
        throw std::invalid_argument("a coordinate of the domain is not finite");
    result.push_back(triangle);
  }
  return result;
}

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_MESH_ENCLOSURE_H
