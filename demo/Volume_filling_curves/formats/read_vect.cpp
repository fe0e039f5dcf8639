// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/curve_files/Polyline_scanner.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using CGAL::Volume_filling_curves::Closure;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// Reads Geomview's VECT, the format of KnotPlot, plCurve and Ridgerunner: the numbers of polylines,
// vertices and colors; of each polyline the number of its vertices, negative if it is closed, and
// the number of its colors; all vertices; all colors, which are only read to check that the file is
// complete. It ends with its last color; anything after it is not read. Braces may stand around it,
// as Geomview writes them. Linear time.
class Vect_reader
{
public:
  Vect_reader(std::string_view text, Junctions junctions)
      : m_text(without_braces(text)), m_file(m_text, junctions)
  {}

  Curve_draft run()
  {
    if(read_counts() && read_vertices()) read_colors();
    return m_file.finish();
  }

private:
  using Integer = long long;
  static constexpr Integer largest = 4294967295; // nodes of a network

  struct Header
  {
    Integer polylines = 0, vertices = 0, colors = 0;
  };

  // Blanks replace braces around everything but comments.
  static std::string without_braces(std::string_view text)
  {
    std::string result(text);
    files::Text_scanner words(text);
    std::string_view first = words.next_word();
    while(first.empty() && !words.is_at_end()) {
      words.next_record();
      first = words.next_word();
    }
    const std::size_t close = result.rfind('}');
    if(first.empty() || first[0] != '{' || close == std::string::npos) return result;
    result[static_cast<std::size_t>(first.data() - text.data())] = ' ';
    result[close] = ' ';
    return result;
  }

  bool read_counts()
  {
    const std::string_view keyword = m_file.next_word();
    if(keyword != "VECT") return refuse(files::quoted(keyword) + " is not VECT, the first word");
    return read_integer(m_header.polylines, 0) && read_integer(m_header.vertices, 0) &&
           read_integer(m_header.colors, 0) &&
           read_counts(m_vertex_counts, -largest, m_header.vertices, "vertices") &&
           read_counts(m_color_counts, 0, m_header.colors, "colors");
  }

  // Reads the counts of all polylines, which must add up.
  bool read_counts(std::vector<Integer>& counts,
                   Integer least,
                   Integer announced,
                   const std::string& name)
  {
    Integer sum = 0;
    for(Integer i = 0; i < m_header.polylines; ++i) {
      Integer count = 0;
      if(!read_integer(count, least)) return false;
      counts.push_back(count);
      sum += std::abs(count);
      if(sum > announced) break;
    }
    if(sum == announced) return true;
    return refuse("the polylines have " + std::string(sum > announced ? "more" : "fewer") +
                  " than the " + std::to_string(announced) + " " + name + " announced");
  }

  bool read_vertices()
  {
    for(const Integer count : m_vertex_counts) {
      const std::size_t line = m_file.words().line();
      std::vector<files::Polyline_scanner::Point> points;
      files::Polyline_scanner::Point point;
      for(Integer i = 0; i < std::abs(count); ++i, point = {}) {
        if(!m_file.read_point(point)) return refuse_end("vertices");
        points.push_back(point);
      }
      m_file.polylines().add(points, line, count < 0 ? Closure::CLOSED : Closure::IF_REPEATED);
    }
    return true;
  }

  bool read_colors()
  {
    for(Integer i = 0; i < 4 * m_header.colors; ++i) {
      const std::string_view word = m_file.next_word();
      double channel = 0;
      if(word.empty()) return refuse_end("colors");
      if(!files::parse_number(word, channel))
        return refuse(files::quoted(word) + " is not a number");
    }
    return true;
  }

  bool read_integer(Integer& number, Integer least)
  {
    const std::string_view word = m_file.next_word();
    if(word.empty()) return refuse_end("counts");
    if(files::parse_integer(word, number) && least <= number && number <= largest) return true;
    return refuse(files::quoted(word) + " is not a count");
  }

  bool refuse_end(const std::string& name)
  {
    return refuse("the file ends before its last " + name);
  }

  bool refuse(const std::string& message)
  {
    m_file.add_defect(Kind::WRONG_POINT_COUNT, message);
    return false;
  }

  std::string m_text;
  files::Polyline_scanner m_file;
  Header m_header;
  std::vector<Integer> m_vertex_counts, m_color_counts;
};

} // namespace

Curve_draft read_vect(std::string_view text, Junctions junctions)
{
  return Vect_reader(text, junctions).run();
}

} // namespace vfc
