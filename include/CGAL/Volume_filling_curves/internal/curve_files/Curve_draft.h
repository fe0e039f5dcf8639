// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_DRAFT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_DRAFT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// List of defects. It keeps the first 1000 of each kind and counts the others, since a wrong file
// tends to be wrong in every line.
class Defect_list
{
public:
  static constexpr std::size_t max_listed = 1000;

  void add(Curve_defect defect)
  {
    if(is_error(defect.kind)) m_has_error = true;
    if(m_counts[defect.kind]++ < max_listed) m_defects.push_back(std::move(defect));
  }

  // adds a note to a kind that is listed, even beyond max_listed
  void add_note(Curve_defect defect) { m_defects.push_back(std::move(defect)); }

  bool has_error() const { return m_has_error; }

  // returns the defects, and the totals of the kinds that are listed in part
  std::vector<Curve_defect> listed() const
  {
    std::vector<Curve_defect> defects = m_defects;
    for(const auto& [kind, count] : m_counts)
      if(count > max_listed)
        defects.push_back({kind, std::to_string(count) + " of this kind in total, the first " +
                                     std::to_string(max_listed) + " are listed"});
    return defects;
  }

private:
  std::vector<Curve_defect> m_defects;
  std::map<Curve_defect_kind, std::size_t> m_counts;
  bool m_has_error = false;
};

// Content of a curve file before any checks: all vertices in the order of the file, edges as pairs
// of vertex indices from 0, and their lines. All readers produce a draft, whatever their format;
// `draft_to_network()` converts it to a curve or reports its defects. An unreadable vertex keeps
// its index, so that the indices of the others remain valid.
struct Curve_draft
{
  using Point = std::array<double, 3>;
  using Edge = std::array<std::size_t, 2>;

  // Users see vertex numbers from 1.
  static std::size_t number(std::size_t v) { return v + 1; }

  bool is_readable(std::size_t v) const { return !std::isnan(points[v][0]); }

  // A point with a coordinate unfit for computation becomes unreadable.
  void add_point(const Point& point, std::size_t line)
  {
    for(const double x : point) {
      if(std::abs(x) <= max_coordinate) continue;
      const bool is_finite = std::isfinite(x);
      return add_unreadable_point(
          {is_finite ? Curve_defect_kind::COORDINATE_TOO_LARGE
                     : Curve_defect_kind::NON_FINITE_COORDINATE,
           is_finite ? "a coordinate is beyond 1e150" : "a coordinate is not finite",
           line,
           {number(points.size())}});
    }
    points.push_back(point);
    point_lines.push_back(line);
  }

  void add_unreadable_point(Curve_defect defect)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    points.push_back({nan, nan, nan});
    point_lines.push_back(defect.line);
    defects.add(std::move(defect));
  }

  // Node numbers are from 0 here.
  void add_defect(Curve_defect_kind kind,
                  std::string message,
                  std::size_t line,
                  const std::vector<std::size_t>& nodes,
                  std::size_t component)
  {
    Curve_defect defect{kind, std::move(message), line, nodes, component};
    for(std::size_t& v : defect.nodes) v = number(v);
    defects.add(std::move(defect));
  }

  void add_edge(std::size_t v, std::size_t w, std::size_t line)
  {
    edges.push_back({v, w});
    edge_lines.push_back(line);
  }

  // Calls is_dropped(e) for each edge in order; meanwhile, the edges from e on are unchanged.
  template <typename Is_dropped>
  void remove_edges_if(const Is_dropped& is_dropped)
  {
    std::size_t kept = 0;
    for(std::size_t e = 0; e < edges.size(); ++e) {
      if(is_dropped(e)) continue;
      edges[kept] = edges[e];
      edge_lines[kept++] = edge_lines[e];
    }
    edges.resize(kept);
    edge_lines.resize(kept);
  }

  // Returns for each edge the first one between the same two nodes; for a loop itself. O(n log n).
  std::vector<std::size_t> first_equal_edges() const
  {
    std::vector<std::array<std::size_t, 3>> keys;
    keys.reserve(edges.size());
    check_run();
    for(std::size_t e = 0; e < edges.size(); ++e) {
      const auto [lower, upper] = std::minmax(edges[e][0], edges[e][1]);
      if(lower != upper) keys.push_back({lower, upper, e});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::size_t> firsts(edges.size());
    std::iota(firsts.begin(), firsts.end(), std::size_t(0));
    for(std::size_t i = 1; i < keys.size(); ++i)
      if(keys[i][0] == keys[i - 1][0] && keys[i][1] == keys[i - 1][1])
        firsts[keys[i][2]] = firsts[keys[i - 1][2]];
    return firsts;
  }

  // Returns for each edge whether it runs straight back over the edge before it, loops left out.
  // Such an edge repeats none: there the line turns back.
  std::vector<bool> turns() const
  {
    std::vector<bool> are_turns(edges.size(), false);
    std::size_t previous = 0;
    for(std::size_t e = 0; e < edges.size(); ++e) {
      const auto [v, w] = edges[e];
      if(v == w) continue;
      are_turns[e] = edge_lines[previous] == edge_lines[e] && edges[previous] == Edge{w, v};
      previous = e;
    }
    return are_turns;
  }

  // Interprets a file without lines, in a format that has them: faces or no vertices are an error;
  // otherwise all vertices form one closed curve. `line_of_face` is 0 if the file has no face.
  void take_without_lines(std::size_t line_of_face, std::size_t last_line)
  {
    if(line_of_face > 0)
      return defects.add(
          {Curve_defect_kind::FACES_ONLY, "there are faces but no lines", line_of_face});
    if(points.empty())
      return defects.add({Curve_defect_kind::NO_GEOMETRY, "there are no vertices", last_line});
    defects.add({Curve_defect_kind::NO_LINES,
                 "there are no lines; all vertices are read as one closed curve", last_line});
    for(std::size_t v = 0; v < points.size(); ++v)
      add_edge(v, (v + 1) % points.size(), point_lines[0]);
  }

  std::vector<Point> points;
  std::vector<std::size_t> point_lines;
  std::vector<Edge> edges;
  std::vector<std::size_t> edge_lines; // where the record of the edge starts
  std::vector<std::size_t> pinned;
  Defect_list defects;
  bool says_what_is_closed = true; // whether the format or the user says so
  bool is_complete = true;         // whether the reader reached the end of the file
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_CURVE_DRAFT_H
