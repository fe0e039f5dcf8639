// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_REPAIR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_REPAIR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/IO/Mesh_file.h>
#include <CGAL/Volume_filling_curves/internal/split_touching_vertices.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The repairs of a triangle soup that shall bound a domain, and their warnings: equal vertices, unused
// ones, and such in which the surface touches itself. Degenerate triangles are errors, but are taken
// out for the checks that come next. O(n log n).
class Mesh_repair
{
public:
  explicit Mesh_repair(Mesh_file& file) : m_file(file) {}

  void merge_equal_points()
  {
    Indices order(m_file.points.size()), first(m_file.points.size()), merged;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t v, std::size_t w) {
      return m_file.points[v] < m_file.points[w];
    });
    for(std::size_t i = 0; i < order.size(); ++i) {
      const bool is_new = i == 0 || m_file.points[order[i - 1]] != m_file.points[order[i]];
      first[order[i]] = is_new ? order[i] : first[order[i - 1]];
      if(!is_new) merged.push_back(order[i]);
    }
    if(merged.empty()) return;
    for(auto& face : m_file.faces)
      for(std::size_t& v : face) v = first[v];
    std::sort(merged.begin(), merged.end());
    m_is_merged.assign(m_file.points.size(), false);
    for(const std::size_t v : merged) m_is_merged[v] = true;
    m_file.add(Mesh_defect_kind::COINCIDENT_VERTICES,
               std::to_string(merged.size()) + " vertices repeat others and were merged with them",
               merged);
  }

  // The other checks want triangles.
  void remove_degenerate_faces()
  {
    std::vector<bool> is_degenerate(m_file.faces.size(), false);
    for(std::size_t f = 0; f < m_file.faces.size(); ++f) {
      const auto& [a, b, c] = m_file.faces[f];
      is_degenerate[f] = CGAL::collinear(m_file.points[a], m_file.points[b], m_file.points[c]);
      if(!is_degenerate[f]) continue;
      const bool is_repeated = a == b || b == c || c == a;
      m_file.add(Mesh_defect_kind::DEGENERATE_FACE,
                 is_repeated ? "a face uses a vertex twice" : "the corners of a face lie on a line",
                 {a, b, c}, {f});
    }
    std::size_t kept = 0;
    for(std::size_t f = 0; f < is_degenerate.size(); ++f) {
      if(is_degenerate[f]) continue;
      m_file.faces[kept] = m_file.faces[f];
      m_file.face_numbers[kept++] = m_file.face_numbers[f];
    }
    m_file.faces.resize(kept);
    m_file.face_numbers.resize(kept);
  }

  void report_isolated_points()
  {
    const std::vector<bool> is_used = used_points();
    Indices isolated;
    for(std::size_t v = 0; v < is_used.size(); ++v)
      if(!is_used[v] && !(!m_is_merged.empty() && m_is_merged[v])) isolated.push_back(v);
    if(!isolated.empty())
      m_file.add(Mesh_defect_kind::ISOLATED_VERTEX,
                 std::to_string(isolated.size()) + " vertices have no face", isolated);
  }

  void leave_out_isolated_points()
  {
    const std::vector<bool> is_used = used_points();
    Indices place(m_file.points.size());
    std::vector<Point> points;
    for(std::size_t v = 0; v < is_used.size(); ++v) {
      place[v] = points.size();
      if(!is_used[v]) continue;
      points.push_back(m_file.points[v]);
      m_file.origins.push_back(v);
    }
    for(auto& face : m_file.faces)
      for(std::size_t& v : face) v = place[v];
    m_file.points = std::move(points);
  }

  // \pre every edge has exactly two triangles
  void split_touching_vertices()
  {
    const std::size_t before = m_file.points.size();
    const Indices touching =
        internal::split_touching_vertices(m_file.points, m_file.faces, m_file.origins);
    if(m_file.points.size() == before) return;
    m_file.add(Mesh_defect_kind::NON_MANIFOLD_VERTEX,
               "the surface touches itself in " + std::to_string(touching.size()) + " vertices",
               touching);
  }

private:
  using Indices = Mesh_file::Indices;
  using Point = Mesh_file::Point;

  std::vector<bool> used_points() const
  {
    std::vector<bool> is_used(m_file.points.size(), false);
    for(const auto& face : m_file.faces)
      for(const std::size_t v : face) is_used[v] = true;
    return is_used;
  }

  Mesh_file& m_file;
  std::vector<bool> m_is_merged; // the points that are others' copies
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MESH_REPAIR_H
