// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_ARC_CHECKER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_ARC_CHECKER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_traits_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Check for arcs that were probably meant to be closed. Rings in lists of points often do not
// repeat their first point, and the format has no other mark for them. Read as an arc, a ring would
// untangle to a segment. In such formats nearly closed arcs are errors; in other formats arcs whose
// ends are as close as neighboring nodes get a warning. Linear time for each arc with close ends.
class Arc_checker
{
  using Traits = Curve_flow_traits_3<>;

public:
  explicit Arc_checker(Curve_draft& file)
      : m_file(file), m_numbers(component_numbers(file.points.size(), file.edges))
  {}

  void run()
  {
    collect_arcs();
    for(const Arc& arc : m_arcs) {
      if(arc.ends.size() != 2) continue;
      if(!m_file.says_what_is_closed && may_be_ring(arc) && may_be_closed(arc))
        add_defect(Curve_defect_kind::UNDECIDED_CLOSURE,
                   "the ends of a curve nearly meet, and the file does not say whether it is closed"
                   " or open",
                   arc);
      else if(has_ends_like_neighbors(arc))
        add_defect(Curve_defect_kind::NEARLY_CLOSED,
                   "the ends of an open curve are as close as neighbors", arc);
    }
  }

private:
  // a component; it is an arc if it has two ends
  struct Arc
  {
    std::vector<std::size_t> ends;
    double length = 0, longest_edge = 0;
    std::size_t number_of_edges = 0;
  };

  // The ends of an unclosed ring are neighbors, and a sampling may omit a few nodes between them.
  static constexpr double max_gap = 3; // in longest edges

  // The largest gap of a ring, in lengths of the arc. It separates the two legs of a right angle
  // (0.71), which are an arc, from two sides of an equilateral triangle (0.5), which may be a ring.
  static constexpr double max_share = 2. / 3;

  static constexpr double closeness = 1.5;    // in mean edge lengths
  static constexpr std::size_t min_edges = 8; // with fewer, the ends are close in any case

  double distance(std::size_t v, std::size_t w) const
  {
    const auto &p = m_file.points[v], &q = m_file.points[w];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  double gap(const Arc& arc) const { return distance(arc.ends[0], arc.ends[1]); }

  void collect_arcs()
  {
    std::vector<std::size_t> degrees(m_file.points.size(), 0);
    for(const auto& [v, w] : m_file.edges) {
      if(m_numbers[v] > m_arcs.size()) m_arcs.resize(m_numbers[v]);
      Arc& arc = m_arcs[m_numbers[v] - 1];
      const double length = distance(v, w);
      arc.length += length;
      arc.longest_edge = (std::max)(arc.longest_edge, length);
      ++arc.number_of_edges;
      ++degrees[v];
      ++degrees[w];
    }
    for(std::size_t v = 0; v < degrees.size(); ++v)
      if(degrees[v] == 1) m_arcs[m_numbers[v] - 1].ends.push_back(v);
  }

  bool may_be_ring(const Arc& arc) const
  {
    return gap(arc) < max_gap * arc.longest_edge && gap(arc) < max_share * arc.length;
  }

  bool has_ends_like_neighbors(const Arc& arc) const
  {
    return arc.number_of_edges >= min_edges &&
           gap(arc) < closeness * arc.length / static_cast<double>(arc.number_of_edges);
  }

  bool may_touch(const Curve_draft::Edge& e, const Curve_draft::Edge& f) const
  {
    for(std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(m_file.points[e[0]][k], m_file.points[e[1]][k]);
      const auto [c, d] = std::minmax(m_file.points[f[0]][k], m_file.points[f[1]][k]);
      if(b < c || d < a) return false;
    }
    return true;
  }

  // Returns whether the edge between the ends meets no other edge, which is decided exactly.
  bool may_be_closed(const Arc& arc)
  {
    if(gap(arc) == 0) return true; // one point, written in two ways
    if(m_points.empty())
      for(const auto& p : m_file.points) m_points.emplace_back(p[0], p[1], p[2]);
    auto edges = m_file.edges;
    edges.push_back({arc.ends[0], arc.ends[1]});
    const Self_contacts<Traits> contacts(m_points, edges);
    for(std::size_t e = 0; e + 1 < edges.size(); ++e)
      if(may_touch(edges[e], edges.back()) && contacts.are_in_contact(e, edges.size() - 1))
        return false;
    return true;
  }

  void add_defect(Curve_defect_kind kind, const char* message, const Arc& arc)
  {
    m_file.add_defect(kind, message, m_file.point_lines[arc.ends[1]], arc.ends,
                      m_numbers[arc.ends[0]]);
  }

  Curve_draft& m_file;
  std::vector<std::size_t> m_numbers;
  std::vector<Arc> m_arcs;
  std::vector<Traits::Point_3> m_points;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_ARC_CHECKER_H
