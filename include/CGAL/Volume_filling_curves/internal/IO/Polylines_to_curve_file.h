// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TO_CURVE_FILE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TO_CURVE_FILE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Text_scanner.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Turns polylines into vertices and edges. By CGAL's habit a polyline is closed if its last point
// repeats the first; the repeated point is no new vertex. Where junctions are allowed, equal end
// points of polylines are one vertex as well. Vertices are numbered as they appear first, which is
// the numbering of an OBJ file with the same curves. O(n + k log k) for k polylines with n points.
class Polylines_to_curve_file
{
public:
  explicit Polylines_to_curve_file(Junctions junctions)
      : m_has_common_ends(junctions == Junctions::ALLOWED)
  {}

  struct Point
  {
    Curve_file::Point point;
    std::size_t line = 0;
    std::string_view unparsable_word = {}; // what stands in the file in place of a number
  };

  // Adds a polyline whose record starts in the given line.
  void add(const std::vector<Point>& polyline, std::size_t line)
  {
    if(polyline.empty()) return;
    const bool is_closed = polyline.size() > 1 && polyline.front().point == polyline.back().point;
    const std::size_t first = add_end(polyline.front());
    std::size_t v = first;
    for(std::size_t i = 1; i < polyline.size(); ++i) {
      const bool is_end = i + 1 == polyline.size();
      const std::size_t w =
          is_end ? (is_closed ? first : add_end(polyline[i])) : add_point(polyline[i]);
      m_file.add_edge(v, w, line);
      v = w;
    }
  }

  Curve_file& file() { return m_file; }

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
                                   {Curve_file::number(v)}});
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

  Curve_file m_file;
  std::map<Curve_file::Point, std::size_t> m_ends;
  bool m_has_common_ends;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TO_CURVE_FILE_H
