// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TO_CURVE_DRAFT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TO_CURVE_DRAFT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of polylines to vertices and edges. In a closed polyline, a last point that repeats
// the first is not a new vertex. If junctions are allowed, equal end points of polylines are also
// one vertex. Vertices are numbered by first occurrence, as in an OBJ file with the same curves.
// O(n + k log k) for k polylines with n points.
class Polylines_to_curve_draft
{
public:
  explicit Polylines_to_curve_draft(Junctions junctions, Closure closure = Closure::IF_REPEATED)
      : m_closure(closure), m_has_common_ends(junctions == Junctions::ALLOWED)
  {}

  struct Point
  {
    Curve_draft::Point point;
    std::size_t line = 0;
    std::string_view unparsable_word = {}; // the word in the file instead of a number
  };

  // Adds a polyline whose record starts in line `line`.
  void add(const std::vector<Point>& polyline, std::size_t line) { add(polyline, line, m_closure); }

  void add(const std::vector<Point>& polyline, std::size_t line, Closure closure)
  {
    if(polyline.empty()) return;
    const bool is_repeated = closure != Closure::OPEN && polyline.size() > 1 &&
                             polyline.front().point == polyline.back().point;
    const bool is_closed = is_repeated || closure == Closure::CLOSED;
    const std::size_t n = polyline.size() - (is_repeated ? 1 : 0);
    const std::size_t first = add_end(polyline.front());
    std::size_t v = first;
    for(std::size_t i = 1; i < n; ++i) {
      const bool is_end = !is_closed && i + 1 == n;
      const std::size_t w = is_end ? add_end(polyline[i]) : add_point(polyline[i]);
      m_file.add_edge(v, w, line);
      v = w;
    }
    if(is_closed) m_file.add_edge(v, first, line);
  }

  Curve_draft& draft() { return m_file; }

private:
  std::size_t add_point(const Point& point)
  {
    const std::size_t v = m_file.points.size();
    if(point.unparsable_word.empty()) {
      m_file.add_point(point.point, point.line);
    } else {
      m_file.add_unreadable_point({Curve_defect_kind::UNPARSABLE_NUMBER,
                                   quoted(point.unparsable_word) + " is not a number",
                                   point.line,
                                   {Curve_draft::number(v)}});
    }
    return v;
  }

  std::size_t add_end(const Point& point)
  {
    const auto is_nan = [](double x) { return std::isnan(x); };
    const bool has_nan = std::any_of(point.point.begin(), point.point.end(), is_nan);
    if(!m_has_common_ends || has_nan) return add_point(point);
    const auto [end, is_new] = m_ends.emplace(point.point, m_file.points.size());
    return is_new ? add_point(point) : end->second;
  }

  Curve_draft m_file;
  std::map<Curve_draft::Point, std::size_t> m_ends;
  Closure m_closure;
  bool m_has_common_ends;
};

// Adds one polyline, or those of a range; the line of a polyline is its number, from 1.
template <typename PolylineRange, typename PointMap>
void add_polylines(const PolylineRange& polylines,
                   const PointMap& point_map,
                   Polylines_to_curve_draft& converter,
                   std::size_t line = 1)
{
  if constexpr(is_range_of_ranges<PolylineRange>) {
    for(const auto& polyline : polylines) add_polylines(polyline, point_map, converter, line++);
  } else {
    std::vector<Polylines_to_curve_draft::Point> points;
    for(const auto& item : polylines) {
      const Vector p = to_vector(get(point_map, item));
      points.push_back({{p.x(), p.y(), p.z()}, line});
    }
    converter.add(points, line);
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TO_CURVE_DRAFT_H
