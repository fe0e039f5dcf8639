// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_defect.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/without_lines.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/Xml_scanner.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads the polylines of a file of VTK's XML format for polygonal data: pieces with points and
// lines, the latter as `connectivity`, the points of all lines, and `offsets`, where each of them
// ends. Of the point data only `pinned` matters. Arrays must be in ASCII. Linear time.
class Vtp_reader
{
public:
  explicit Vtp_reader(std::string_view text) : m_readable(text), m_tags(m_readable.text()) {}

  Curve_draft run()
  {
    m_file.is_complete = read_tags();
    if(!m_readable.is_complete()) {
      m_file.is_complete = false;
      refuse(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
    } else if(m_file.is_complete && !m_has_lines) {
      take_without_lines(m_file, m_line_of_face, m_tags.line());
    }
    return std::move(m_file);
  }

private:
  struct Word
  {
    std::string_view text;
    std::size_t line;
  };

  using Words = std::vector<Word>;

  // the arrays of a piece
  struct Piece
  {
    Words points, connectivity, offsets, pinned;
  };

  bool refuse(Curve_defect_kind kind, const std::string& message, std::size_t line = 0)
  {
    m_file.defects.add({kind, message, line > 0 ? line : m_tags.line()});
    return false;
  }

  bool read_tags()
  {
    if(!m_tags.next_tag() || m_tags.name() != "VTKFile" || m_tags.attribute("type") != "PolyData")
      return refuse(Curve_defect_kind::UNKNOWN_FORMAT,
                    "the first tag is not <VTKFile type=\"PolyData\">");
    while(m_tags.next_tag()) {
      const std::string_view name = m_tags.name();
      if(m_tags.is_end() && name == "VTKFile") return true;
      if(name == "Piece" && m_tags.is_end() && !end_piece()) return false;
      if(name == "Piece" && !m_tags.is_end()) m_piece = {};
      if(name == "DataArray" && !m_tags.is_end() && !read_array()) return false;
      if(is_section(name)) m_section = m_tags.is_end() || m_tags.is_empty() ? "" : name;
    }
    return m_readable.is_complete() &&
           refuse(Curve_defect_kind::WRONG_POINT_COUNT, "the file ends before </VTKFile>");
  }

  static bool is_section(std::string_view name)
  {
    return name == "Points" || name == "Lines" || name == "Polys" || name == "PointData";
  }

  bool read_array()
  {
    Words* const array = wanted_array(m_tags.attribute("Name"));
    if(m_section == "Polys" && m_line_of_face == 0 && !words().empty())
      m_line_of_face = m_tags.line();
    if(array == nullptr) return true;
    const std::string_view format = m_tags.attribute("format");
    if(!format.empty() && format != "ascii")
      return refuse(Curve_defect_kind::BINARY_DATA,
                    "an array has the format " + quoted(format) + ", only ascii is read");
    if(!m_tags.is_empty()) *array = words();
    return true;
  }

  Words* wanted_array(std::string_view name)
  {
    if(m_section == "Points") return &m_piece.points;
    if(m_section == "Lines" && name == "connectivity") return &m_piece.connectivity;
    if(m_section == "Lines" && name == "offsets") return &m_piece.offsets;
    if(m_section == "PointData" && name == "pinned") return &m_piece.pinned;
    return nullptr;
  }

  // returns what stands between the last tag and the next
  Words words() const
  {
    Words result;
    Text_scanner scanner(m_tags.content());
    for(; !scanner.is_at_end(); scanner.next_record())
      for(auto word = scanner.next_word(); !word.empty(); word = scanner.next_word())
        result.push_back({word, m_tags.line() + scanner.line() - 1});
    return result;
  }

  bool end_piece()
  {
    const std::size_t first = m_file.points.size();
    if(m_piece.points.size() % 3 != 0)
      return refuse(Curve_defect_kind::MISSING_COORDINATES,
                    "the number of coordinates is no multiple of 3", m_piece.points.back().line);
    for(std::size_t i = 0; i < m_piece.points.size(); i += 3) add_point(&m_piece.points[i]);
    for(std::size_t i = 0; i < m_piece.pinned.size() && first + i < m_file.points.size(); ++i)
      if(is_set(m_piece.pinned[i].text)) m_file.pinned.push_back(first + i);
    return add_lines(first);
  }

  void add_point(const Word* words)
  {
    Curve_draft::Point point;
    for(std::size_t k = 0; k < 3; ++k)
      if(!parse_number(words[k].text, point[k]))
        return m_file.add_unreadable_point({Curve_defect_kind::UNPARSABLE_NUMBER,
                                            quoted(words[k].text) + " is not a number",
                                            words[k].line,
                                            {Curve_draft::number(m_file.points.size())}});
    m_file.add_point(point, words[0].line);
  }

  bool add_lines(std::size_t first_point)
  {
    std::size_t begin = 0;
    for(const Word& offset : m_piece.offsets) {
      std::size_t end = 0;
      if(!parse_integer(offset.text, end) || end < begin || end > m_piece.connectivity.size())
        return refuse(Curve_defect_kind::BAD_INDEX,
                      quoted(offset.text) + " is no place where a line of " +
                          std::to_string(m_piece.connectivity.size()) + " indices can end",
                      offset.line);
      if(end == begin + 1)
        m_file.defects.add({Curve_defect_kind::SHORT_LINE, "a line needs two indices",
                            m_piece.connectivity[begin].line});
      if(!add_line(first_point, begin, end)) return false;
      begin = end;
      m_has_lines = true;
    }
    return true;
  }

  bool add_line(std::size_t first_point, std::size_t begin, std::size_t end)
  {
    const std::size_t number_of_points = m_file.points.size() - first_point;
    std::size_t last = 0;
    for(std::size_t i = begin; i < end; ++i) {
      const Word& word = m_piece.connectivity[i];
      std::size_t v = 0;
      if(!parse_integer(word.text, v) || v >= number_of_points)
        return refuse(Curve_defect_kind::BAD_INDEX,
                      quoted(word.text) + " is not the index of one of " +
                          std::to_string(number_of_points) + " points",
                      word.line);
      if(i > begin) m_file.add_edge(last, first_point + v, m_piece.connectivity[begin].line);
      last = first_point + v;
    }
    return true;
  }

  Readable_text m_readable;
  Xml_scanner m_tags;
  Curve_draft m_file;
  Piece m_piece;
  std::string_view m_section; // what the next array belongs to, empty if that does not matter
  std::size_t m_line_of_face = 0;
  bool m_has_lines = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H
