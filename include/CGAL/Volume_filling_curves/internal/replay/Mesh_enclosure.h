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
#include <CGAL/Volume_filling_curves/internal/replay/ray_crossing.h>
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
