// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_CHECKER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_CHECKER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/Face_contacts.h>
#include <CGAL/Volume_filling_curves/internal/Face_edges.h>
#include <CGAL/Volume_filling_curves/internal/IO/Mesh_file.h>
#include <CGAL/Volume_filling_curves/internal/Mesh_orientation.h>
#include <CGAL/Volume_filling_curves/internal/Mesh_repair.h>
#include <CGAL/Volume_filling_curves/internal/Mesh_shells.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Says everything that keeps the triangles of a file from bounding a domain, and repairs what has only
// one reading. All decisions are exact. O(n log^2 n) unless many triangles have intersecting boxes.
class Mesh_checker
{
public:
  explicit Mesh_checker(Mesh_file& file) : m_file(file) {}

  void run()
  {
    if(m_file.has_error) return; // the reader's; there is nothing to go on with
    if(m_file.points.empty() || m_file.faces.empty())
      return m_file.add({Mesh_defect_kind::NO_GEOMETRY,
                         m_file.points.empty() ? "there are no vertices" : "there are no faces"});
    check_numbers();
    if(m_file.has_error) return;
    check_size();
    Mesh_repair repair(m_file);
    repair.merge_equal_points();
    repair.remove_degenerate_faces();
    repair.report_isolated_points();
    check_duplicate_faces();
    check_edges();
    check_contacts();
    if(m_file.has_error) return;
    orient();
    if(m_file.has_error) return;
    repair.leave_out_isolated_points();
    repair.split_touching_vertices();
  }

private:
  using Indices = Mesh_file::Indices;
  using Point = Mesh_file::Point;

  static constexpr double max_coordinate = 1e150; // products of three stay in the range of double
  static constexpr double min_size = 1e-150;      // the squares of lengths do not underflow

  void check_numbers()
  {
    for(std::size_t v = 0; v < m_file.points.size(); ++v) {
      for(int axis = 0; axis < 3; ++axis) {
        const double x = m_file.points[v][axis];
        if(std::abs(x) <= max_coordinate) continue;
        const bool is_finite = std::isfinite(x);
        m_file.add(is_finite ? Mesh_defect_kind::COORDINATE_TOO_LARGE
                             : Mesh_defect_kind::NON_FINITE_COORDINATE,
                   is_finite ? "a coordinate is beyond 1e150" : "a coordinate is not finite", {v});
        break;
      }
    }
    for(std::size_t f = 0; f < m_file.faces.size(); ++f)
      for(const std::size_t v : m_file.faces[f])
        if(v >= m_file.points.size())
          m_file.add(Mesh_defect_kind::BAD_INDEX,
                     "a face asks for vertex " + std::to_string(v + 1) + " of " +
                         std::to_string(m_file.points.size()),
                     {}, {f});
  }

  void check_size()
  {
    CGAL::Bbox_3 box;
    for(const Point& p : m_file.points) box += p.bbox();
    if((std::max)({box.x_span(), box.y_span(), box.z_span()}) < min_size)
      m_file.add(Mesh_defect_kind::SIZE_TOO_SMALL, "the size of the mesh is below 1e-150", {});
    else if(are_coplanar())
      m_file.add(Mesh_defect_kind::ZERO_VOLUME, "all vertices lie in a plane", {});
  }

  bool are_coplanar() const
  {
    const auto& points = m_file.points;
    const auto differs = [&](const Point& p) { return p != points[0]; };
    const auto q = std::find_if(points.begin(), points.end(), differs);
    const auto r = std::find_if(points.begin(), points.end(), [&](const Point& p) {
      return q != points.end() && !CGAL::collinear(points[0], *q, p);
    });
    return r == points.end() || std::all_of(points.begin(), points.end(), [&](const Point& p) {
             return CGAL::coplanar(points[0], *q, *r, p);
           });
  }

  void check_duplicate_faces()
  {
    std::map<Mesh_file::Face, std::size_t> first;
    for(std::size_t f = 0; f < m_file.faces.size(); ++f) {
      Mesh_file::Face face = m_file.faces[f];
      std::sort(face.begin(), face.end());
      const auto [it, is_new] = first.insert({face, f});
      if(!is_new)
        m_file.add(Mesh_defect_kind::DUPLICATE_FACE, "two faces have the same corners",
                   {face[0], face[1], face[2]}, {it->second, f});
    }
  }

  void check_edges()
  {
    Disjoint_sets holes(m_file.points.size());
    std::vector<std::pair<std::size_t, std::size_t>> boundary;
    Face_edges(m_file.faces).for_each_edge([&](auto first, auto last) {
      if(last - first == 1) {
        boundary.push_back({first->low, first->high});
        holes.unite(first->low, first->high);
      }
      if(last - first <= 2) return;
      Indices faces;
      for(auto side = first; side != last; ++side) faces.push_back(side->face);
      m_file.add(Mesh_defect_kind::NON_MANIFOLD_EDGE,
                 "an edge has " + std::to_string(last - first) + " faces",
                 {first->low, first->high}, faces);
    });
    std::map<std::size_t, Indices> ends; // of the edges of every hole
    for(const auto& [v, w] : boundary) {
      Indices& list = ends[holes.find(v)];
      list.push_back(v);
      list.push_back(w);
    }
    for(auto& [hole, list] : ends) report_hole(list);
  }

  void report_hole(Indices& ends)
  {
    const std::size_t edges = ends.size() / 2;
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    m_file.add(Mesh_defect_kind::OPEN_BOUNDARY,
               edges == 1 ? "the surface is not closed: the boundary has an edge of one face only"
                          : "the surface is not closed: a boundary of " + std::to_string(edges) +
                                " edges with one face only",
               ends);
  }

  void check_contacts()
  {
    using Contacts = Face_contacts<Mesh_file::Kernel>;
    const auto pairs = Contacts(m_file.points, m_file.faces).find();
    for(const auto& [f, g] : pairs) {
      m_file.add(Mesh_defect_kind::SELF_INTERSECTION, "two faces intersect", {}, {f, g});
    }
  }

  // \pre there is no error
  void orient()
  {
    const Mesh_orientation orientation(m_file.faces);
    const Indices turned = orientation.turned();
    std::vector<bool> is_mixed(orientation.number_of_shells(), false);
    for(const std::size_t f : turned) is_mixed[orientation.shells()[f]] = true;
    if(!turned.empty())
      m_file.add(Mesh_defect_kind::MIXED_ORIENTATION,
                 std::to_string(turned.size()) +
                     " faces were turned against their neighbors and have been reoriented",
                 {}, turned);
    Mesh_shells(m_file, orientation.shells(), is_mixed).orient();
  }

  Mesh_file& m_file;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_CHECKER_H
