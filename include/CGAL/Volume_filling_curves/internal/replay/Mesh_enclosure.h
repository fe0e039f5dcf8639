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
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

using Triangle = std::array<Position, 3>;

// The inside of a closed triangle mesh, by an implementation that shares nothing with
// Triangle_mesh_domain_3: CGAL's AABB tree finds the faces near a box, and what arithmetic with
// double cannot prove is decided with rational numbers. Logarithmic time per triangle.
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

  // By a segment to a point outside, which crosses the surface an odd number of times. Where it
  // meets an edge or a vertex another one is taken.
  bool is_inside(const Position& p) const override
  {
    for(std::size_t k = 0; is_in_extent(p); ++k)
      if(const auto is_odd = is_crossed_oddly(p, point_outside(k))) return *is_odd;
    return false;
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

  // beyond the largest x, each in another direction
  Position point_outside(std::size_t k) const
  {
    constexpr double golden_ratio = 0.6180339887498949;
    Position q = m_extent.upper;
    const double size = q[0] - m_extent.lower[0];
    q[0] += size;
    for(std::size_t i = 1; i < 3; ++i) {
      const double x = golden_ratio * static_cast<double>(3 * k + i);
      q[i] -= (x - std::floor(x)) * (q[i] - m_extent.lower[i]);
    }
    return q;
  }

  // Returns none if that cannot be told, false if p is on the surface.
  std::optional<bool> is_crossed_oddly(const Position& p, const Position& q) const
  {
    const std::array<Position, 2> segment = {p, q};
    bool is_odd = false, is_on_surface = false;
    const bool is_undecided = finds_near(box_of(segment), [&](const Triangle& face) {
      if(are_surely_apart(segment, face) || !do_meet_exactly(p, q, face)) return false;
      is_on_surface = is_on_surface || do_meet_exactly(p, p, face);
      is_odd = !is_odd;
      return !is_on_surface && !is_crossing_proper(p, q, face);
    });
    if(is_on_surface) return false;
    return is_undecided ? std::nullopt : std::optional<bool>(is_odd);
  }

  // Whether a segment that meets a face meets neither its edges nor its plane in an end.
  static bool is_crossing_proper(const Position& p, const Position& q, const Triangle& face)
  {
    return is_volume_nonzero(face[0], face[1], face[2], p) &&
           is_volume_nonzero(face[0], face[1], p, q) && is_volume_nonzero(face[1], face[2], p, q) &&
           is_volume_nonzero(face[2], face[0], p, q);
  }

  static bool is_volume_nonzero(const Position& a,
                                const Position& b,
                                const Position& c,
                                const Position& d)
  {
    const Rational_vector o = rational(a);
    return dot(cross(rational(b) - o, rational(c) - o), rational(d) - o) != 0;
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
