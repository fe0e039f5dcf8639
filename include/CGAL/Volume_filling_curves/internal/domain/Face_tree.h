// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_FACE_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_FACE_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Mesh_shells.h>
#include <CGAL/Volume_filling_curves/internal/domain/Planar_rays_query.h>
#include <CGAL/Volume_filling_curves/internal/domain/Ray_entry.h>
#include <CGAL/Volume_filling_curves/internal/domain/Vertical_ray.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/triangle_distance.h>
#include <CGAL/Volume_filling_curves/internal/search/Box_tree.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/search/Surface_area_order.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tree of the faces of a surface, which must be closed for inside tests. Intersections with
// triangles are decided exactly; distances are computed in double. The corners of the faces are
// stored in the order of the tree's leaves, since queries spend most of their time waiting for
// memory. Logarithmic time per query near the surface, more near the medial axis, where many faces
// are at equal distances.
template <typename Kernel>
class Face_tree
{
public:
  using Point_3 = typename Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point_3>;
  using Face = typename Mesh::Face_index;

  struct Nearest_face
  {
    Face face; // null if none is nearer than the bound
    double squared_distance;
  };

  // \pre the mesh has faces, all of them triangles, none degenerate, and no garbage
  explicit Face_tree(Mesh mesh) : m_mesh(std::move(mesh)), m_shells(m_mesh)
  {
    std::vector<Bbox_3> boxes;
    boxes.reserve(m_mesh.number_of_faces());
    for(const Face f : m_mesh.faces()) boxes.push_back(box_of(triangle(f)));
    const Surface_area_order order(boxes);
    m_tree = Box_tree(order.sorted(boxes), order.run_ends());
    for(const std::uint32_t i : order.numbers()) {
      m_faces.push_back(Face(i));
      m_triangles.push_back(triangle(m_faces.back()));
      const auto& [p, q, r] = m_triangles.back();
      m_corners.push_back({to_vector(p), to_vector(q), to_vector(r)});
    }
    for(int i = 0; i < 3; ++i)
      m_max_coordinate =
          (std::max)({m_max_coordinate, std::abs(bbox().min(i)), std::abs(bbox().max(i))});
  }

  const Mesh& mesh() const { return m_mesh; }

  // the corners of all faces, in the order of the tree
  const std::vector<Corners>& corners() const { return m_corners; }

  const Bbox_3& bbox() const { return m_tree.root().hull(); }

  const Mesh_shells<Mesh>& shells() const { return m_shells; }

  // returns whether the closed triangle, which may be degenerate, meets the surface; exact
  bool does_meet(const std::array<Point_3, 3>& triangle) const
  {
    const Bbox_3 box = box_of(triangle);
    const auto overlaps = [&](const Bbox_3& other) { return CGAL::do_overlap(box, other); };
    return any_leaf(m_tree, overlaps, [&](std::size_t i) {
      const Triangle& face = m_triangles[i];
      return overlaps(box_of(face)) &&
             Triangle_intersection<Curve_flow_traits_3<Kernel>>().do_intersect(face, triangle);
    });
  }

  // returns whether the point lies strictly inside of the surface; exact
  bool encloses(const Point_3& p) const
  {
    Vertical_ray<Kernel> ray(p);
    for_each_face_above(p, [&](std::size_t i) { ray.add(m_triangles[i]); });
    return ray.starts_inside();
  }

  // Returns the innermost shell with the point strictly inside; exact except for shells that
  // enclose the same volume. \pre there is one
  std::size_t innermost_shell(const Point_3& p) const
  {
    if(m_shells.number() == 1) return 0;
    std::map<std::size_t, Vertical_ray<Kernel>> rays; // the same for each shell
    for_each_face_above(p, [&](std::size_t i) {
      rays.try_emplace(m_shells.shell(m_faces[i]), p).first->second.add(m_triangles[i]);
    });
    std::size_t innermost = m_shells.number();
    for(const auto& [shell, ray] : rays)
      if(ray.starts_inside() &&
         (innermost == m_shells.number() || m_shells.volume(shell) < m_shells.volume(innermost)))
        innermost = shell;
    return innermost;
  }

  // returns the nearest face and its squared distance if that is less than `bound`, and `bound`
  // else
  Nearest_face nearest(const Vector& p,
                       double bound = std::numeric_limits<double>::infinity()) const
  {
    Distance_query query{*this, p, {Mesh::null_face(), bound}};
    Nearest_first_descent<Distance_query>(m_tree, query).run();
    return query.nearest;
  }

  // returns the squared distance of the segment ab to the surface, and its position on the segment,
  // from 0 to 1. \pre the segment does not meet the surface
  std::pair<double, double> nearest_to_segment(const Vector& a, const Vector& b) const
  {
    Segment_query query{*this, a, b, to_bbox(Box(a).extend(b)), {nearest(a).squared_distance, 0}};
    Nearest_first_descent<Segment_query>(m_tree, query).run();
    return query.nearest;
  }

  // returns the least t <= limit for which p + t u lies on the surface, or `limit`
  double distance_along(const Vector& p, const Vector& u, double limit) const
  {
    Ray_query query{*this, p, u, Ray_entry(p, u, m_max_coordinate), limit};
    Nearest_first_descent<Ray_query>(m_tree, query).run();
    return query.bound();
  }

  // Shortens rays to their first intersections with the surface. One descent serves all of them.
  void shorten(Planar_rays& rays) const
  {
    Planar_rays_query query(m_corners, rays, m_max_coordinate);
    Nearest_first_descent<Planar_rays_query>(m_tree, query).run();
  }

private:
  using Triangle = std::array<Point_3, 3>;

  // Passes the faces that an upward ray may meet to a function, by their order in the tree.
  template <typename Function>
  void for_each_face_above(const Point_3& p, const Function& function) const
  {
    const Vector source = to_vector(p);
    const auto may_meet = [&](const Bbox_3& box) {
      return box.xmin() <= source.x() && source.x() <= box.xmax() && box.ymin() <= source.y() &&
             source.y() <= box.ymax() && source.z() <= box.zmax();
    };
    any_leaf(m_tree, may_meet, [&](std::size_t i) {
      if(may_meet(box_of(m_triangles[i]))) function(i);
      return false;
    });
  }

  struct Distance_query
  {
    const Face_tree& faces;
    Vector p;
    Nearest_face nearest;

    double bound() const { return nearest.squared_distance; }

    double entry(const Bbox_3& box) const { return squared_distance_to_box(p, box); }

    void visit(std::size_t i)
    {
      const double d2 = squared_distance_to_triangle(p, faces.m_corners[i], bound());
      if(d2 < bound()) nearest = {faces.m_faces[i], d2};
    }
  };

  struct Segment_query
  {
    const Face_tree& faces;
    Vector a, b;
    Bbox_3 box;
    std::pair<double, double> nearest; // the squared distance, and its position on the segment

    double bound() const { return nearest.first; }

    double entry(const Bbox_3& other) const { return squared_distance_of_boxes(box, other); }

    void visit(std::size_t i)
    {
      const auto found = nearest_to_triangle(a, b, faces.m_corners[i], bound());
      if(found.first < bound()) nearest = found;
    }
  };

  struct Ray_query
  {
    const Face_tree& faces;
    Vector p, u;
    Ray_entry ray_entry;
    double nearest;

    double bound() const { return nearest; }

    double entry(const Bbox_3& box) const { return ray_entry(box, nearest); }

    void visit(std::size_t i)
    {
      nearest = (std::min)(nearest, distance_along_to_triangle(p, u, faces.m_corners[i]));
    }
  };

  Triangle triangle(Face f) const
  {
    const auto h = m_mesh.halfedge(f);
    return {m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
            m_mesh.point(m_mesh.target(m_mesh.next(h)))};
  }

  static Bbox_3 box_of(const Triangle& t) { return t[0].bbox() + t[1].bbox() + t[2].bbox(); }

  Mesh m_mesh;
  Mesh_shells<Mesh> m_shells;
  Box_tree m_tree;
  double m_max_coordinate = 0; // absolute value of a coordinate
  // in the order of the leaves
  std::vector<Face> m_faces;
  std::vector<Triangle> m_triangles;
  std::vector<Corners> m_corners;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_FACE_TREE_H
