// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Mesh_shells.h>
#include <CGAL/Volume_filling_curves/internal/domain/mesh_faults.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Nesting of a shell, a component of a closed surface, among the others.
struct Shell_nesting
{
  bool is_outward = false;         // whether its normals point away from what it encloses
  std::vector<std::size_t> around; // the shells that enclose it, ascending
};

template <typename Point_3>
auto from_above(const Point_3& p)
{
  using Point_2 = typename Kernel_traits<Point_3>::Kernel::Point_2;
  return Point_2(p.x(), p.y());
}

// 1 if the face looks up, -1 if down, and 0 if it is vertical
template <typename Point_3>
int upward_sign(const std::array<Point_3, 3>& face)
{
  return CGAL::orientation(from_above(face[0]), from_above(face[1]), from_above(face[2]));
}

// The ray upwards from p + e (q - p) + e^2 (r - p) with an infinitely small e: from a point within
// the face pqr, which is therefore on no other one, even where shells touch in a vertex, and above
// no edge, unless that is vertical. Where p lies on a line or in a plane, q decides, and then r.
// \pre the face is not vertical
template <typename Point_3>
class Ray_from_face
{
  using Triangle = std::array<Point_3, 3>;

public:
  explicit Ray_from_face(const Triangle& face) : m_face(face) {}

  // returns whether the ray crosses a face; not that from which it starts
  bool crosses(const Triangle& face) const
  {
    const int turn = turn_around_ray(face[0], face[1]);
    return turn != 0 && turn_around_ray(face[1], face[2]) == turn &&
           turn_around_ray(face[2], face[0]) == turn && side_of_source(face) == -turn;
  }

private:
  // which way the edge passes the ray, seen from above: 1 counterclockwise, -1 clockwise, and 0 if
  // it is vertical
  int turn_around_ray(const Point_3& a, const Point_3& b) const
  {
    for(const Point_3& p : m_face)
      if(const int turn = CGAL::orientation(from_above(a), from_above(b), from_above(p)))
        return turn;
    return 0;
  }

  int side_of_source(const Triangle& face) const
  {
    for(const Point_3& p : m_face)
      if(const int side = CGAL::orientation(face[0], face[1], face[2], p)) return side;
    return 0;
  }

  Triangle m_face;
};

// Search for the nesting of shells, given by their faces. Exact, from signs only, at any scale; O(n
// log^3 n), plus the faces above one point of each shell.
template <typename Mesh>
class Shell_nesting_search
{
  using Face = typename Mesh::Face_index;
  using Point_3 = typename Mesh::Point;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Face>;

public:
  // \pre the shells are closed and each is oriented; faces meet only in common vertices and edges
  static std::vector<Shell_nesting> find(const Mesh& mesh,
                                         const std::vector<std::vector<Face>>& shells)
  {
    return Shell_nesting_search(mesh, shells).nestings();
  }

private:
  Shell_nesting_search(const Mesh& mesh, const std::vector<std::vector<Face>>& shells)
      : m_mesh(mesh), m_shell_of(mesh.number_of_faces())
  {
    for(std::size_t i = 0; i < shells.size(); ++i) {
      m_rays.push_back(box_of_ray(first_that_is_not_vertical(shells[i])));
      for(const Face f : shells[i]) {
        m_shell_of[f] = i;
        const auto corners = triangle(f);
        m_faces.push_back(Box(CGAL::bbox_3(corners.begin(), corners.end()), f));
      }
    }
  }

  std::vector<Shell_nesting> nestings()
  {
    std::set<std::pair<std::size_t, std::size_t>> odd; // a shell's ray crosses this one so often
    const auto count = [&](const Box& ray, const Box& face) {
      if(!Ray_from_face(triangle(ray.info())).crosses(triangle(face.info()))) return;
      const std::pair crossing(m_shell_of[ray.info()], m_shell_of[face.info()]);
      if(!odd.insert(crossing).second) odd.erase(crossing);
    };
    const auto rays = m_rays; // which are sorted by the search
    CGAL::box_intersection_d(m_rays.begin(), m_rays.end(), m_faces.begin(), m_faces.end(), count);
    std::vector<Shell_nesting> result(rays.size());
    for(const auto& [shell, crossed] : odd)
      if(crossed != shell) result[shell].around.push_back(crossed);
    for(std::size_t i = 0; i < rays.size(); ++i) {
      const bool is_inside_above = odd.count({i, i}) > 0;
      result[i].is_outward = is_inside_above == (upward_sign(triangle(rays[i].info())) < 0);
    }
    return result;
  }

  std::array<Point_3, 3> triangle(Face f) const
  {
    const auto h = m_mesh.halfedge(f);
    return {m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
            m_mesh.point(m_mesh.target(m_mesh.next(h)))};
  }

  // There is one, or the divergence theorem would deny the shell a volume.
  Face first_that_is_not_vertical(const std::vector<Face>& faces) const
  {
    return *std::find_if(faces.begin(), faces.end(),
                         [&](Face f) { return upward_sign(triangle(f)) != 0; });
  }

  Box box_of_ray(Face source) const
  {
    const CGAL::Bbox_3 p = triangle(source)[0].bbox();
    const double top = (std::numeric_limits<double>::max)();
    return Box({p.xmin(), p.ymin(), p.zmin(), p.xmax(), p.ymax(), top}, source);
  }

  const Mesh& m_mesh;
  std::vector<std::size_t> m_shell_of;
  std::vector<Box> m_faces, m_rays;
};

// Shell of a closed surface. A shell within an odd number of others bounds a cavity and should be
// oriented inward, all others outward.
template <typename Mesh>
struct Nested_shell
{
  std::vector<typename Mesh::Face_index> faces;
  std::optional<std::size_t> parent = {}; // the shell directly around, if there is one
  bool is_right = true;                   // whether its orientation suits its depth
};

// Returns the shells in the order of their first faces.
// \pre the mesh is closed, has no garbage, and its faces do not intersect
template <typename Mesh>
std::vector<Nested_shell<Mesh>> nested_shells(const Mesh& mesh)
{
  const Mesh_shells<Mesh> components(mesh);
  std::vector<std::vector<typename Mesh::Face_index>> faces(components.number());
  for(const auto f : mesh.faces()) faces[components.shell(f)].push_back(f);
  const std::vector<Shell_nesting> nestings = Shell_nesting_search<Mesh>::find(mesh, faces);
  const auto depth = [&](std::size_t shell) { return nestings[shell].around.size(); };
  std::vector<Nested_shell<Mesh>> shells;
  for(std::size_t i = 0; i < faces.size(); ++i) {
    shells.push_back({faces[i]});
    shells[i].is_right = nestings[i].is_outward == (depth(i) % 2 == 0);
    for(const std::size_t outer : nestings[i].around)
      if(depth(outer) + 1 == depth(i)) shells[i].parent = outer;
  }
  return shells;
}

// Whether a shell has the orientation of the one around it: its author may have meant two solids or
// a cavity. A nest whose shells all have the wrong orientation is not ambiguous.
template <typename Mesh>
bool is_ambiguous(const std::vector<Nested_shell<Mesh>>& shells, std::size_t i)
{
  return shells[i].parent && shells[i].is_right != shells[*shells[i].parent].is_right;
}

// \pre the shell is ambiguous
template <typename Mesh>
Mesh_fault ambiguity_fault(const std::vector<Nested_shell<Mesh>>& shells, std::size_t i)
{
  return {"ambiguous shells", "shell " + std::to_string(i + 1) + " lies within shell " +
                                  std::to_string(*shells[i].parent + 1) +
                                  " and has the same orientation"};
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_NESTED_SHELLS_H
