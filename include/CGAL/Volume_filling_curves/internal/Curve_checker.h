// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECKER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECKER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/Edge_repair.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>
#include <CGAL/Volume_filling_curves/internal/Self_contacts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Says everything that keeps the repaired edges of a file from being an embedded curve that can be
// computed with. A curve is embedded if no two edges meet elsewhere than in a common node, which is
// decided exactly; all other tests are comparisons of coordinates. O(n log^2 n) unless many edges
// have intersecting bounding boxes.
class Curve_checker
{
public:
  Curve_checker(Curve_file& file, Junctions junctions)
      : m_file(file),
        m_junctions(junctions),
        m_components(component_numbers(file.points.size(), file.edges))
  {}

  void run()
  {
    if(m_file.edges.empty()) return;
    if(m_junctions == Junctions::FORBIDDEN) check_degrees();
    check_size();
    check_contacts();
  }

private:
  using Traits = Curve_flow_traits_3<>;
  using Point_3 = Traits::Point_3;
  using Edge = Curve_file::Edge;
  using Nodes = std::vector<std::size_t>;

  // Relative to the longest side of the bounding box: of the length of such an edge no more than
  // four digits are certain.
  static constexpr double short_edge = 1e-12;

  static constexpr double min_size = 1e-150; // the squares of lengths do not underflow

  void check_degrees()
  {
    std::vector<std::size_t> degrees(m_file.points.size(), 0);
    Nodes junctions;
    std::vector<std::size_t> lines; // where a node becomes a junction
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
    if(size < min_size)
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

  double length(const Edge& edge) const
  {
    const auto &p = m_file.points[edge[0]], &q = m_file.points[edge[1]];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  void check_contacts()
  {
    std::vector<Point_3> points;
    points.reserve(m_file.points.size());
    for(const auto& p : m_file.points) points.emplace_back(p[0], p[1], p[2]);
    Self_contacts<Traits> contacts(points, m_file.edges);
    contacts.find(Defect_list::max_listed);
    std::set<Nodes> reported; // a coincidence of nodes concerns up to four pairs of edges
    for(const auto& [e, f] : contacts.kept()) {
      const auto [message, nodes] = contacts.describe(e, f);
      if(reported.insert(nodes).second)
        add_defect(Curve_defect_kind::SELF_CONTACT, message, m_file.point_lines[nodes[0]], nodes);
    }
    if(contacts.count() > contacts.kept().size())
      m_file.defects.add_note({Curve_defect_kind::SELF_CONTACT,
                               (contacts.has_all() ? "" : "at least ") +
                                   std::to_string(contacts.count()) +
                                   " pairs of edges meet in total, the first " +
                                   std::to_string(contacts.kept().size()) + " are listed"});
  }

  void add_defect(Curve_defect_kind kind,
                  const std::string& message,
                  std::size_t line,
                  const Nodes& nodes)
  {
    m_file.add_defect(kind, message, line, nodes, nodes.empty() ? 0 : m_components[nodes[0]]);
  }

  Curve_file& m_file;
  Junctions m_junctions;
  std::vector<std::size_t> m_components;
};

// Turns what a file says into an embedded curve, or lists why it is none. If there is no error, the
// edges of the file are those of the curve.
inline void check_curve(Curve_file& file, Junctions junctions)
{
  if(!file.is_complete) return;
  Edge_repair(file).run();
  Curve_checker(file, junctions).run();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CHECKER_H
