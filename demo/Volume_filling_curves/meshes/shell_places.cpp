// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/shell_places.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

namespace vfc {
namespace {

using Point = Kernel::Point_3;
using Triangle = std::array<Point, 3>;

Triangle triangle_of(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

Kernel::Point_2 from_above(const Point& p)
{
  return {p.x(), p.y()};
}

// 1 if the face looks up, -1 if down, and 0 if it is vertical
int upward_sign(const Triangle& face)
{
  return CGAL::orientation(from_above(face[0]), from_above(face[1]), from_above(face[2]));
}

// The ray upwards from p + e (q - p) + e^2 (r - p) with an infinitely small e: from a point within
// the face pqr, which is therefore on no other one, even where shells touch in a vertex, and above
// no edge, unless that is vertical. Where p lies on a line or in a plane, q decides, and then r.
// \pre the face is not vertical
class Ray_from_face
{
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
  int turn_around_ray(const Point& a, const Point& b) const
  {
    for(const Point& p : m_face)
      if(const int turn = CGAL::orientation(from_above(a), from_above(b), from_above(p)))
        return turn;
    return 0;
  }

  int side_of_source(const Triangle& face) const
  {
    for(const Point& p : m_face)
      if(const int side = CGAL::orientation(face[0], face[1], face[2], p)) return side;
    return 0;
  }

  Triangle m_face;
};

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Mesh::Face_index>;

Box box_of(const Mesh& mesh, Mesh::Face_index f)
{
  const Triangle t = triangle_of(mesh, f);
  return Box(CGAL::bbox_3(t.begin(), t.end()), f);
}

Box box_of_ray(const Mesh& mesh, Mesh::Face_index source)
{
  const Point p = triangle_of(mesh, source)[0];
  const double top = (std::numeric_limits<double>::max)();
  return Box({p.x(), p.y(), p.z(), p.x(), p.y(), top}, source);
}

// There is one, or the divergence theorem would deny the shell a volume.
Mesh::Face_index first_that_is_not_vertical(const Mesh& mesh,
                                            const std::vector<Mesh::Face_index>& faces)
{
  return *std::find_if(faces.begin(), faces.end(),
                       [&](Mesh::Face_index f) { return upward_sign(triangle_of(mesh, f)) != 0; });
}

} // namespace

std::vector<Shell_place> places_of_shells(const Mesh& mesh,
                                          const std::vector<std::vector<Mesh::Face_index>>& shells)
{
  std::vector<std::size_t> shell_of(mesh.number_of_faces());
  std::vector<Box> faces, rays;
  for(std::size_t i = 0; i < shells.size(); ++i) {
    rays.push_back(box_of_ray(mesh, first_that_is_not_vertical(mesh, shells[i])));
    for(const Mesh::Face_index f : shells[i]) {
      shell_of[f] = i;
      faces.push_back(box_of(mesh, f));
    }
  }

  std::set<std::pair<std::size_t, std::size_t>> odd; // a shell's ray crosses this one so often
  CGAL::box_intersection_d(rays.begin(), rays.end(), faces.begin(), faces.end(),
                           [&](const Box& ray, const Box& face) {
                             const Ray_from_face from_face(triangle_of(mesh, ray.info()));
                             if(!from_face.crosses(triangle_of(mesh, face.info()))) return;
                             const std::pair crossing(shell_of[ray.info()], shell_of[face.info()]);
                             if(!odd.insert(crossing).second) odd.erase(crossing);
                           });

  std::vector<Shell_place> places(shells.size());
  for(const auto& [shell, crossed] : odd)
    if(crossed != shell) places[shell].around.push_back(crossed);
  for(const Box& ray : rays) {
    const std::size_t shell = shell_of[ray.info()];
    const bool is_inside_above = odd.count({shell, shell}) > 0;
    places[shell].is_outward = is_inside_above == (upward_sign(triangle_of(mesh, ray.info())) < 0);
  }
  return places;
}

} // namespace vfc
