// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/without_lines.h>
#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>
#include <CGAL/Volume_filling_curves/internal/text/Xml_scanner.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The faces of a VTP file, as indices of points.
struct Vtp_faces
{
  std::vector<std::vector<std::size_t>> polygons, strips;
};

// Reads a file of VTK's XML format for polygonal data: pieces with points and cells, the latter as
// `connectivity`, the points of all of them, and `offsets`, where each ends. Lines are the cells of
// a curve, polygons and strips of triangles those of a surface. Of the point data only `pinned`
// matters. Arrays must be in ASCII. Linear time.
class Vtp_reader
{
public:
  explicit Vtp_reader(std::string_view text) : m_readable(text), m_tags(m_readable.text()) {}

  Curve_draft run()
  {
    read();
    if(m_file.is_complete && !m_has_lines)
      take_without_lines(m_file, m_line_of_face, m_tags.line());
    return std::move(m_file);
  }

  // Reads the faces in place of the lines. Returns the points, and what is wrong.
  Curve_draft read_surface(Vtp_faces& faces)
  {
    m_faces = &faces;
    read();
    return std::move(m_file);
  }

private:
  struct Word
  {
    std::string_view text;
    std::size_t line;
  };

  using Words = std::vector<Word>;

  struct Cells
  {
    Words connectivity, offsets;
  };

  // the arrays of a piece
  struct Piece
  {
    Words points, pinned;
    Cells lines, polygons, strips;
  };

  bool refuse(Curve_defect_kind kind, const std::string& message, std::size_t line = 0)
  {
    m_file.defects.add({kind, message, line > 0 ? line : m_tags.line()});
    return false;
  }

  void read()
  {
    m_file.is_complete = read_tags();
    if(m_readable.is_complete()) return;
    m_file.is_complete = false;
    refuse(Curve_defect_kind::BINARY_DATA, m_readable.complaint());
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
    return name == "Points" || name == "Lines" || name == "Polys" || name == "Strips" ||
           name == "PointData";
  }

  bool read_array()
  {
    const bool is_of_faces = m_section == "Polys" || m_section == "Strips";
    if(is_of_faces && m_line_of_face == 0 && !words().empty()) m_line_of_face = m_tags.line();
    Words* const array = wanted_array(m_tags.attribute("Name"));
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
    if(m_section == "PointData") return name == "pinned" ? &m_piece.pinned : nullptr;
    Cells* const cells = wanted_cells();
    if(cells == nullptr) return nullptr;
    if(name == "connectivity") return &cells->connectivity;
    return name == "offsets" ? &cells->offsets : nullptr;
  }

  // returns those of the section, if they are a curve or a surface, as is asked for
  Cells* wanted_cells()
  {
    if(m_faces == nullptr) return m_section == "Lines" ? &m_piece.lines : nullptr;
    if(m_section == "Polys") return &m_piece.polygons;
    return m_section == "Strips" ? &m_piece.strips : nullptr;
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
    if(m_faces != nullptr)
      return add_faces(first, m_piece.polygons, m_faces->polygons) &&
             add_faces(first, m_piece.strips, m_faces->strips);
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
    return for_each_cell(
        m_piece.lines, first_point, [&](const std::vector<std::size_t>& points, std::size_t line) {
          m_has_lines = true;
          if(points.size() == 1)
            m_file.defects.add({Curve_defect_kind::SHORT_LINE, "a line needs two indices", line});
          for(std::size_t i = 1; i < points.size(); ++i)
            m_file.add_edge(points[i - 1], points[i], line);
        });
  }

  bool add_faces(std::size_t first_point,
                 const Cells& cells,
                 std::vector<std::vector<std::size_t>>& faces)
  {
    return for_each_cell(
        cells, first_point,
        [&](const std::vector<std::size_t>& points, std::size_t) { faces.push_back(points); });
  }

  // Hands the points of each cell to a function, and the line where they begin. Returns whether all
  // numbers make sense.
  template <typename Function>
  bool for_each_cell(const Cells& cells, std::size_t first_point, const Function& function)
  {
    const std::size_t size = cells.connectivity.size();
    std::size_t begin = 0;
    std::vector<std::size_t> points;
    for(const Word& offset : cells.offsets) {
      std::size_t end = 0;
      if(!parse_integer(offset.text, end) || end < begin || end > size)
        return refuse(Curve_defect_kind::BAD_INDEX,
                      quoted(offset.text) + " is no place where a line of " + std::to_string(size) +
                          " indices can end",
                      offset.line);
      points.clear();
      for(std::size_t i = begin; i < end; ++i)
        if(!read_index(cells.connectivity[i], first_point, points)) return false;
      function(points, begin < end ? cells.connectivity[begin].line : offset.line);
      begin = end;
    }
    return true;
  }

  bool read_index(const Word& word, std::size_t first_point, std::vector<std::size_t>& points)
  {
    const std::size_t number_of_points = m_file.points.size() - first_point;
    std::size_t v = 0;
    if(!parse_integer(word.text, v) || v >= number_of_points)
      return refuse(Curve_defect_kind::BAD_INDEX,
                    quoted(word.text) + " is not the index of one of " +
                        std::to_string(number_of_points) + " points",
                    word.line);
    points.push_back(first_point + v);
    return true;
  }

  Readable_text m_readable;
  Xml_scanner m_tags;
  Curve_draft m_file;
  Piece m_piece;
  Vtp_faces* m_faces = nullptr; // null if lines are read
  std::string_view m_section;   // what the next array belongs to, empty if that does not matter
  std::size_t m_line_of_face = 0;
  bool m_has_lines = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_FILES_VTP_READER_H
