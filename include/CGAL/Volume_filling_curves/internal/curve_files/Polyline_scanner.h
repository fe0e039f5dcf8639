// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINE_SCANNER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINE_SCANNER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Polylines_to_curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Common base of readers of files that list points, polyline by polyline: the words of the file,
// and the curve read so far.
class Polyline_scanner
{
public:
  using Point = Polylines_to_curve_draft::Point;

  Polyline_scanner(std::string_view text, Junctions junctions)
      : m_readable(text), m_words(m_readable.text()), m_polylines(junctions)
  {}

  Text_scanner& words() { return m_words; }
  Polylines_to_curve_draft& polylines() { return m_polylines; }

  // returns the next word in this or a later line; empty at the end of the file
  std::string_view next_word()
  {
    std::string_view word = m_words.next_word();
    while(word.empty() && !m_words.is_at_end()) {
      m_words.next_record();
      word = m_words.next_word();
    }
    return word;
  }

  // Reads a point from the words that `next()` returns. Returns whether there are three words.
  template <typename NextWord>
  bool read_point(Point& point, const NextWord& next)
  {
    for(double& x : point.point) {
      const std::string_view word = next();
      if(word.empty()) return false;
      point.line = m_words.line();
      if(parse_number(word, x)) continue;
      point.unparsable_word = word;
      x = std::numeric_limits<double>::quiet_NaN();
    }
    return true;
  }

  bool read_point(Point& point)
  {
    return read_point(point, [this] { return next_word(); });
  }

  void add_defect(Curve_defect_kind kind, std::string message)
  {
    m_polylines.draft().defects.add({kind, std::move(message), m_words.line()});
  }

  // Returns the curve, at the end of the file.
  Curve_draft finish()
  {
    Curve_draft& file = m_polylines.draft();
    file.is_complete = m_readable.is_complete();
    if(!file.is_complete)
      add_defect(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
    else if(file.points.empty() && !file.defects.has_error())
      add_defect(Curve_defect_kind::NO_GEOMETRY, "there are no points");
    return std::move(file);
  }

private:
  Readable_text m_readable;
  Text_scanner m_words;
  Polylines_to_curve_draft m_polylines;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_POLYLINE_SCANNER_H
