// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_CHECKER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_CHECKER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Check of the repaired edges of a file for all defects of a curve except contacts of edges and
// nearly closed arcs, which `Contact_checker` and `Arc_checker` find. Linear time.
class Curve_checker
{
public:
  Curve_checker(Curve_draft& file, Junctions junctions)
      : m_file(file),
        m_junctions(junctions),
        m_components(component_numbers(file.points.size(), file.edges))
  {}

  void run()
  {
    if(m_file.edges.empty()) return;
    if(m_junctions == Junctions::FORBIDDEN) check_degrees();
    check_size();
  }

private:
  using Edge = Curve_draft::Edge;
  using Nodes = std::vector<std::size_t>;

  // In units of the longest side of the bounding box. At most four digits of the length of such an
  // edge are certain.
  static constexpr double short_edge = 1e-12;

  void check_degrees()
  {
    std::vector<std::size_t> degrees(m_file.points.size(), 0);
    Nodes junctions;
    std::vector<std::size_t> lines; // at which a node becomes a junction
    for(std::size_t e = 0; e < m_file.edges.size(); ++e) {
      for(const std::size_t v : m_file.edges[e]) {
        if(++degrees[v] != 3) continue;
        junctions.push_back(v);
        lines.push_back(m_file.edge_lines[e]);
      }
    }
    for(std::size_t i = 0; i < junctions.size(); ++i)
      add_defect(Curve_defect_kind::JUNCTION,
                 "a node has " + std::to_string(degrees[junctions[i]]) + " edges", lines[i],
                 {junctions[i]});
  }

  void check_size()
  {
    const double size = longest_side();
    if(size < min_extent)
      return add_defect(Curve_defect_kind::SIZE_TOO_SMALL, "the size of the curve is below 1e-150",
                        m_file.point_lines[m_file.edges.front()[0]], {});
    for(const Edge& edge : m_file.edges)
      if(length(edge) < short_edge * size)
        add_defect(Curve_defect_kind::NEARLY_COINCIDENT_NODES,
                   "an edge is shorter than 1e-12 of the curve's size", m_file.point_lines[edge[1]],
                   {edge[0], edge[1]});
  }

  double longest_side() const
  {
    double size = 0;
    for(std::size_t k = 0; k < 3; ++k) {
      double lower = std::numeric_limits<double>::infinity(), upper = -lower;
      for(const Edge& edge : m_file.edges) {
        for(const std::size_t v : edge) {
          lower = (std::min)(lower, m_file.points[v][k]);
          upper = (std::max)(upper, m_file.points[v][k]);
        }
      }
      size = (std::max)(size, upper - lower);
    }
    return size;
  }

  static double distance(const Curve_draft& file, std::size_t v, std::size_t w)
  {
    const auto &p = file.points[v], &q = file.points[w];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  double length(const Edge& edge) const { return distance(m_file, edge[0], edge[1]); }

  void add_defect(Curve_defect_kind kind,
                  const std::string& message,
                  std::size_t line,
                  const Nodes& nodes)
  {
    m_file.add_defect(kind, message, line, nodes, nodes.empty() ? 0 : m_components[nodes[0]]);
  }

  Curve_draft& m_file;
  Junctions m_junctions;
  std::vector<std::size_t> m_components;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_CHECKER_H
