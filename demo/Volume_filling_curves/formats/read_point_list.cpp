// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Polyline_scanner.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::Closure;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// Reads lists of points, one in a line: three coordinates, which the number of the point or the
// symbol of an atom may precede. An empty line, the word END and a line with nothing but a number
// end a polyline; that number, the count of the points that follow, is checked. These are the text
// files of KymoKnot, KnotProt and spreadsheets, and XYZ, whose second line is a comment. Linear
// time.
class Point_list_reader
{
public:
  Point_list_reader(std::string_view text, Junctions junctions) : m_file(text, junctions)
  {
    m_file.polylines().draft().says_what_is_closed = false;
  }

  Curve_draft run()
  {
    files::Text_scanner& words = m_file.words();
    for(; !words.is_at_end(); words.next_record()) read_line();
    end_polyline();
    return m_file.finish();
  }

private:
  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  // the first words of a line, empty beyond its last one
  using Words = std::array<std::string_view, 5>;

  void read_line()
  {
    Words words;
    for(std::string_view& word : words) word = m_file.words().next_word();
    const bool may_be_comment = m_is_after_count;
    m_is_after_count = false;
    if(words[0].empty() || words[0] == "END")
      end_polyline();
    else if(words[1].empty() && begin_counted(words[0]))
      return;
    else if(!add_point(words) && !may_be_comment)
      m_file.add_defect(Kind::UNPARSABLE_NUMBER,
                        files::quoted(words[0]) + " does not begin three coordinates");
  }

  bool begin_counted(std::string_view word)
  {
    std::size_t count = 0;
    if(!files::parse_integer(word, count)) return false;
    end_polyline();
    m_announced = count;
    m_line_of_count = m_file.words().line();
    m_is_after_count = true;
    return true;
  }

  // Returns whether the line has three coordinates, and at most one word before them.
  bool add_point(const Words& words)
  {
    if(words[2].empty() || !words[4].empty()) return false;
    std::size_t next = words[3].empty() ? 0 : 1;
    files::Polyline_scanner::Point point;
    m_file.read_point(point, [&] { return words[next++]; });
    if(!point.unparsable_word.empty() && m_points.empty()) return false;
    if(m_points.empty()) m_first_line = point.line;
    m_points.push_back(point);
    return true;
  }

  void end_polyline()
  {
    if(m_announced != unknown && m_announced != m_points.size())
      m_file.polylines().draft().defects.add({Kind::WRONG_POINT_COUNT,
                                              std::to_string(m_announced) +
                                                  " points are announced, there are " +
                                                  std::to_string(m_points.size()),
                                              m_line_of_count});
    m_announced = unknown;
    m_file.polylines().add(m_points, m_first_line);
    m_points.clear();
  }

  files::Polyline_scanner m_file;
  std::vector<files::Polyline_scanner::Point> m_points;
  std::size_t m_first_line = 0, m_announced = unknown, m_line_of_count = 0;
  bool m_is_after_count = false;
};

} // namespace

Curve_draft read_point_list(std::string_view text, Junctions junctions)
{
  return Point_list_reader(text, junctions).run();
}

} // namespace vfc
