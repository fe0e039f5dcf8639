// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TXT_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TXT_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Polyline_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reader of CGAL's `.polylines.txt` files: one polyline `n x0 y0 z0 x1 y1 z1 ...` per line. The
// numbers may continue on the next lines, as in readers based on stream operators. Linear time.
class Polylines_txt_reader
{
public:
  Polylines_txt_reader(std::string_view text, Junctions junctions) : m_file(text, junctions) {}

  Curve_draft run()
  {
    Text_scanner& words = m_file.words();
    for(; !words.is_at_end(); words.next_record()) {
      const std::string_view word = words.next_word();
      if(!word.empty()) read_polyline(word);
    }
    return m_file.finish();
  }

private:
  void read_polyline(std::string_view count_word)
  {
    const std::size_t line = m_file.words().line();
    std::size_t count = 0;
    if(!parse_integer(count_word, count))
      return m_file.add_defect(Curve_defect_kind::UNPARSABLE_NUMBER,
                               quoted(count_word) + " is not a number of points");
    std::vector<Polyline_scanner::Point> points;
    Polyline_scanner::Point point;
    for(; points.size() < count && m_file.read_point(point); point = {}) points.push_back(point);
    const std::string announcement =
        "the polyline of line " + std::to_string(line) +
        (points.size() < count
             ? " announces " + std::to_string(count) + " points, the file ends after " +
                   std::to_string(points.size())
             : " has more than the " + std::to_string(count) + " points that it announces");
    if(points.size() < count || !m_file.words().next_word().empty())
      m_file.add_defect(Curve_defect_kind::WRONG_POINT_COUNT, announcement);
    m_file.polylines().add(points, line);
  }

  Polyline_scanner m_file;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINES_TXT_READER_H
