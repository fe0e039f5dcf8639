// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Corners.h>
#include <CGAL/Volume_filling_curves/internal/cgal_compatibility.h>
#include <CGAL/Volume_filling_curves/internal/nearest_first_descent.h>
#include <CGAL/Volume_filling_curves/internal/triangle_intersection.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Default.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The faces of a closed surface in a CGAL AABB tree. Whether a triangle meets the surface is decided
// exactly; distances are computed in double. For both the corners of the faces are kept in the order
// of the tree's leaves, since a query spends most of its time waiting for memory. Logarithmic time
// per query near the surface, more near the medial axis, where many faces are equally far.
template <typename Kernel>
class Face_tree
{
public:
  using Point_3 = typename Kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point_3>;
  using Face = typename Mesh::Face_index;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh,
                                                             CGAL::Default,
                                                             CGAL::Tag_true,
                                                             CGAL::Tag_true>; // keeps its triangle
  using Tree = CGAL::AABB_tree<Aabb_traits<Kernel, Primitive>>;

  struct Nearest_face
  {
    Face face; // null if none is nearer than the bound
    double squared_distance;
  };

  // \pre the mesh has at least two faces, all of them triangles, none degenerate, and no garbage
  explicit Face_tree(Mesh mesh)
      : m_mesh(std::move(mesh)), m_tree(faces(m_mesh).begin(), faces(m_mesh).end(), m_mesh)
  {
    m_tree.build(); // or the first queries would build it, one of many threads at a time
    m_faces.reserve(m_mesh.number_of_faces());
    Listing_query query{m_faces};
    Nearest_first_descent<Tree, Listing_query>(query).run(m_tree);
    for(const Face f : m_faces) {
      m_triangles.push_back(triangle(f));
      const auto& [p, q, r] = m_triangles.back();
      m_corners.push_back({to_vector(p), to_vector(q), to_vector(r)});
    }
    const Bbox_3 box = m_tree.bbox();
    for(int i = 0; i < 3; ++i)
      m_largest = (std::max)({m_largest, std::abs(box.min(i)), std::abs(box.max(i))});
  }

  Face_tree(const Face_tree&) = delete; // the tree points at the mesh
  Face_tree& operator=(const Face_tree&) = delete;

  const Mesh& mesh() const { return m_mesh; }

  const Tree& tree() const { return m_tree; }

  // returns whether the closed triangle, which may be degenerate, meets the surface; exact
  bool does_meet(const std::array<Point_3, 3>& triangle) const
  {
    Meeting_query query{*this, triangle, box_of(triangle), false};
    Nearest_first_descent<Tree, Meeting_query>(query).run(m_tree);
    return query.has_met;
  }

  // returns the nearest face and its squared distance if that is less than `bound`, and `bound` else
  Nearest_face nearest(const Vector& p,
                       double bound = std::numeric_limits<double>::infinity()) const
  {
    Distance_query query{*this, p, {Mesh::null_face(), bound}};
    Nearest_first_descent<Tree, Distance_query>(query).run(m_tree);
    return query.nearest;
  }

  // returns the least t <= limit for which p + t u lies on the surface, or `limit`
  double distance_along(const Vector& p, const Vector& u, double limit) const
  {
    Ray_query query(*this, p, u, limit);
    Nearest_first_descent<Tree, Ray_query>(query).run(m_tree);
    return query.bound();
  }

private:
  using Triangle = std::array<Point_3, 3>;

  struct Listing_query
  {
    std::vector<Face>& faces;

    double bound() const { return 1; }
    double entry(const Bbox_3&) const { return 0; }
    void visit(const Primitive& primitive, std::size_t) { faces.push_back(primitive.id()); }
  };

  struct Meeting_query
  {
    const Face_tree& faces;
    const Triangle& triangle;
    Bbox_3 box;
    bool has_met;

    double bound() const { return has_met ? 0 : 1; }

    double entry(const Bbox_3& other) const { return CGAL::do_overlap(box, other) ? 0 : 1; }

    void visit(const Primitive&, std::size_t i)
    {
      const Triangle& face = faces.m_triangles[i];
      if(has_met || !CGAL::do_overlap(box, box_of(face))) return;
      has_met = Triangle_intersection<Kernel>().do_intersect(face, triangle);
    }
  };

  struct Distance_query
  {
    const Face_tree& faces;
    Vector p;
    Nearest_face nearest;

    double bound() const { return nearest.squared_distance; }

    double entry(const Bbox_3& box) const { return squared_distance_to_box(p, box); }

    void visit(const Primitive&, std::size_t i)
    {
      const double d2 = squared_distance_to_triangle(p, faces.m_corners[i], bound());
      if(d2 < bound()) nearest = {faces.m_faces[i], d2};
    }
  };

  class Ray_query
  {
  public:
    Ray_query(const Face_tree& faces, const Vector& p, const Vector& u, double limit)
        : m_faces(faces),
          m_p(p),
          m_u(u),
          m_margin(8 * std::numeric_limits<double>::epsilon() *
                   (std::max)(faces.m_largest, p.cwiseAbs().maxCoeff())),
          m_bound(limit)
    {
      for(int i = 0; i < 3; ++i) m_inverse[i] = 1 / (std::abs(u[i]) > tiny ? u[i] : tiny);
    }

    double bound() const { return m_bound; }

    // where the ray enters the box, widened by the error of this computation
    double entry(const Bbox_3& box) const
    {
      double first = 0, last = m_bound;
      clip(box.xmin(), box.xmax(), 0, first, last);
      clip(box.ymin(), box.ymax(), 1, first, last);
      clip(box.zmin(), box.zmax(), 2, first, last);
      return first <= last ? first : std::numeric_limits<double>::infinity();
    }

    void visit(const Primitive&, std::size_t i)
    {
      m_bound = (std::min)(m_bound, distance_along_to_triangle(m_p, m_u, m_faces.m_corners[i]));
    }

  private:
    static constexpr double tiny = 1e-150; // components of the direction below count as zero

    void clip(double low, double high, int axis, double& first, double& last) const
    {
      const double to_low = (low - m_margin - m_p[axis]) * m_inverse[axis];
      const double to_high = (high + m_margin - m_p[axis]) * m_inverse[axis];
      first = (std::max)(first, (std::min)(to_low, to_high));
      last = (std::min)(last, (std::max)(to_low, to_high));
    }

    const Face_tree& m_faces;
    Vector m_p, m_u, m_inverse;
    double m_margin, m_bound;
  };

  Triangle triangle(Face f) const
  {
    const auto h = m_mesh.halfedge(f);
    return {m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
            m_mesh.point(m_mesh.target(m_mesh.next(h)))};
  }

  static Bbox_3 box_of(const Triangle& t) { return t[0].bbox() + t[1].bbox() + t[2].bbox(); }

  Mesh m_mesh;
  Tree m_tree;
  double m_largest = 0; // absolute value of a coordinate
  // in the order of the leaves
  std::vector<Face> m_faces;
  std::vector<Triangle> m_triangles;
  std::vector<Corners> m_corners;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FACE_TREE_H
