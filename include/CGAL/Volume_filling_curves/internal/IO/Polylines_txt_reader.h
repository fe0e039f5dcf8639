// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TXT_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TXT_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/IO/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/IO/Curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Polylines_to_curve_file.h>
#include <CGAL/Volume_filling_curves/internal/IO/Text_scanner.h>

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads CGAL's `.polylines.txt`: per line a polyline `n x0 y0 z0 x1 y1 z1 ...`. The numbers may
// continue on the next lines, as readers that use stream operators allow. Linear time.
class Polylines_txt_reader
{
public:
  Polylines_txt_reader(std::string_view text, Junctions junctions)
      : m_readable(text), m_scanner(m_readable.text()), m_polylines(junctions)
  {}

  Curve_file run()
  {
    for(; !m_scanner.is_at_end(); m_scanner.next_record()) {
      const std::string_view word = m_scanner.next_word();
      if(!word.empty()) read_polyline(word);
    }
    Curve_file& file = m_polylines.file();
    file.is_complete = m_readable.is_complete();
    if(!file.is_complete)
      add_defect(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
    else if(file.points.empty() && !file.defects.has_error())
      add_defect(Curve_defect_kind::NO_GEOMETRY, "there are no points");
    return std::move(file);
  }

private:
  void read_polyline(std::string_view count_word)
  {
    const std::size_t line = m_scanner.line();
    std::size_t count = 0;
    if(!parse_integer(count_word, count))
      return add_defect(Curve_defect_kind::UNPARSABLE_NUMBER,
                        quoted(count_word) + " is not a number of points");
    m_points.clear();
    while(m_points.size() < count && read_point()) {
    }
    if(m_points.size() < count)
      add_defect(Curve_defect_kind::WRONG_POINT_COUNT,
                 "the polyline of line " + std::to_string(line) + " announces " +
                     std::to_string(count) + " points, the file ends after " +
                     std::to_string(m_points.size()));
    else if(!m_scanner.next_word().empty())
      add_defect(Curve_defect_kind::WRONG_POINT_COUNT,
                 "the polyline of line " + std::to_string(line) + " has more than the " +
                     std::to_string(count) + " points that it announces");
    m_polylines.add(m_points, line);
  }

  // Returns whether the file has three more words.
  bool read_point()
  {
    Polylines_to_curve_file::Point point;
    for(double& x : point.point) {
      const std::string_view word = next_word_of_file();
      if(word.empty()) return false;
      point.line = m_scanner.line();
      if(parse_number(word, x)) continue;
      point.unparsable_word = word;
      x = std::numeric_limits<double>::quiet_NaN();
    }
    m_points.push_back(point);
    return true;
  }

  std::string_view next_word_of_file()
  {
    std::string_view word = m_scanner.next_word();
    while(word.empty() && !m_scanner.is_at_end()) {
      m_scanner.next_record();
      word = m_scanner.next_word();
    }
    return word;
  }

  void add_defect(Curve_defect_kind kind, std::string message)
  {
    m_polylines.file().defects.add({kind, std::move(message), m_scanner.line()});
  }

  Readable_text m_readable;
  Text_scanner m_scanner;
  Polylines_to_curve_file m_polylines;
  std::vector<Polylines_to_curve_file::Point> m_points;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_IO_POLYLINES_TXT_READER_H
