// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/Vtk_encoding.h"
#include "formats/Xml_scanner.h"
#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

// The most bytes that an array of a file is believed to have. Coordinates shrink to a third,
// indices in order to a twentieth; zeros to a thousandth, but there are few more than points.
std::size_t max_inflated(std::size_t size_of_file)
{
  constexpr std::size_t max_times = 100, free = 1 << 20;
  return free + max_times * size_of_file;
}

std::string without_blanks(std::string_view text)
{
  std::string result;
  for(const char c : text)
    if(!std::isspace(static_cast<unsigned char>(c))) result += c;
  return result;
}

// Reads a file of VTK's XML format for polygonal data: pieces with points and cells, the latter as
// `connectivity`, the points of all of them, and `offsets`, where each ends. Lines are the cells of
// a curve, polygons and strips of triangles those of a surface. Of the point data only `pinned`
// matters. Arrays that are not in ASCII become text, which has the line of their tag; appended ones
// stand behind all tags, and may look like tags. Linear time.
class Vtp_reader
{
public:
  // Reads a curve if `polygons` is null.
  Vtp_reader(std::string_view text, Polygons* polygons)
      : m_text(text),
        m_readable(text.substr(0, text.find(appended_tag))),
        m_tags(m_readable.text()),
        m_polygons(polygons)
  {}

  Curve_draft run()
  {
    m_file.is_complete = read();
    if(m_file.is_complete && m_polygons == nullptr && !m_has_lines)
      m_file.take_without_lines(m_line_of_face, m_tags.line());
    for(const auto& strip : m_strips) add_strip(strip, *m_polygons);
    return std::move(m_file);
  }

private:
  static constexpr std::string_view appended_tag = "<AppendedData";

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

  bool refuse(Kind kind, const std::string& message, std::size_t line = 0)
  {
    m_file.defects.add({kind, message, line > 0 ? line : m_tags.line()});
    return false;
  }

  bool read()
  {
    try {
      const bool is_read = read_tags();
      return m_readable.is_complete() ? is_read : refuse(Kind::BINARY_DATA, m_readable.complaint());
    } catch(const Encoding_error& error) {
      return refuse(Kind::BINARY_DATA, error.what());
    }
  }

  bool read_tags()
  {
    if(!m_tags.next_tag() || m_tags.name() != "VTKFile" || m_tags.attribute("type") != "PolyData")
      return refuse(Kind::UNKNOWN_FORMAT, "the first tag is not <VTKFile type=\"PolyData\">");
    m_file_tag = m_tags;
    while(m_tags.next_tag()) {
      const std::string_view name = m_tags.name();
      if(m_tags.is_end() && name == "VTKFile") return true;
      if(name == "Piece" && m_tags.is_end() && !end_piece()) return false;
      if(name == "Piece" && !m_tags.is_end()) m_piece = {};
      if(name == "DataArray" && !m_tags.is_end() && !read_array()) return false;
      if(is_section(name)) m_section = m_tags.is_end() || m_tags.is_empty() ? "" : name;
    }
    return has_appended_data() ||
           (m_readable.is_complete() &&
            refuse(Kind::WRONG_POINT_COUNT, "the file ends before </VTKFile>"));
  }

  bool has_appended_data() const { return m_text.find(appended_tag) != std::string_view::npos; }

  static bool is_section(std::string_view name)
  {
    return name == "Points" || name == "Lines" || name == "Polys" || name == "Strips" ||
           name == "PointData";
  }

  bool read_array()
  {
    const bool is_of_faces = m_section == "Polys" || m_section == "Strips";
    Words* const array = wanted_array(m_tags.attribute("Name"));
    if(array == nullptr && (!is_of_faces || m_line_of_face > 0)) return true;
    const std::string_view format = m_tags.attribute("format");
    if(!format.empty() && format != "ascii" && format != "binary" && format != "appended")
      return refuse(Kind::BINARY_DATA,
                    "an array has the format " + files::quoted(format) + ", which is not read");
    Words content = words(format);
    if(is_of_faces && m_line_of_face == 0 && !content.empty()) m_line_of_face = m_tags.line();
    if(array != nullptr) *array = std::move(content);
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

  // Returns those of the section, if they form the requested curve or surface.
  Cells* wanted_cells()
  {
    if(m_polygons == nullptr) return m_section == "Lines" ? &m_piece.lines : nullptr;
    if(m_section == "Polys") return &m_piece.polygons;
    return m_section == "Strips" ? &m_piece.strips : nullptr;
  }

  // returns the words of the array whose tag was the last
  Words words(std::string_view format)
  {
    Words result;
    const bool is_encoded = format == "binary" || format == "appended";
    if(m_tags.is_empty() && format != "appended") return result;
    files::Text_scanner scanner(is_encoded ? decoded(format == "binary") : m_tags.content());
    for(; !scanner.is_at_end(); scanner.next_record())
      for(auto word = scanner.next_word(); !word.empty(); word = scanner.next_word())
        result.push_back({word, m_tags.line() + scanner.line() - 1});
    return result;
  }

  // \throws Encoding_error
  std::string_view decoded(bool is_inline)
  {
    if(!m_encoding) read_encoding();
    const std::string bytes =
        is_inline ? m_encoding->bytes(without_blanks(m_tags.content()), true) : appended_bytes();
    m_decoded.emplace_back();
    m_encoding->append_numbers(m_decoded.back(), bytes, m_tags.attribute("type"));
    return m_decoded.back();
  }

  // Its errors are reported for the first line, whichever array needs it.
  void read_encoding()
  {
    const Xml_scanner array = std::exchange(m_tags, m_file_tag);
    m_encoding.emplace(m_tags.attribute("header_type"), m_tags.attribute("byte_order"),
                       m_tags.attribute("compressor"), max_inflated(m_text.size()));
    m_tags = array;
  }

  // The array that the tag points to. \throws Encoding_error
  std::string appended_bytes() const
  {
    const std::size_t start = (std::min)(m_text.find(appended_tag), m_text.size());
    Xml_scanner tag(m_text.substr(start));
    tag.next_tag();
    const bool is_base64 = tag.attribute("encoding") != "raw";
    std::string_view data = tag.content(); // up to the next tag, or what looks like one
    data = m_text.substr(static_cast<std::size_t>(data.data() - m_text.data()));
    data.remove_prefix((std::min)(data.find_first_not_of(" \t\r\n"), data.size()));
    if(data.empty() || data[0] != '_')
      throw Encoding_error("the appended data do not begin with '_'");
    data.remove_prefix(1);
    std::size_t offset = 0;
    if(!files::parse_integer(m_tags.attribute("offset"), offset) || offset >= data.size())
      throw Encoding_error("an array is not where its offset points to");
    data.remove_prefix(offset);
    if(is_base64) data = data.substr(0, data.find_first_of(" \t\r\n<"));
    return m_encoding->bytes(data, is_base64);
  }

  bool end_piece()
  {
    const std::size_t first = m_file.points.size();
    if(m_piece.points.size() % 3 != 0)
      return refuse(Kind::MISSING_COORDINATES, "the number of coordinates is no multiple of 3",
                    m_piece.points.back().line);
    for(std::size_t i = 0; i < m_piece.points.size(); i += 3) add_point(&m_piece.points[i]);
    for(std::size_t i = 0; i < m_piece.pinned.size() && first + i < m_file.points.size(); ++i)
      if(is_set(m_piece.pinned[i])) m_file.pinned.push_back(first + i);
    if(m_polygons != nullptr)
      return add_faces(first, m_piece.polygons, *m_polygons) &&
             add_faces(first, m_piece.strips, m_strips);
    return add_lines(first);
  }

  bool is_set(const Word& word)
  {
    double number = 0;
    if(!files::parse_number(word.text, number) || std::isnan(number))
      m_file.defects.add({Kind::UNPARSABLE_NUMBER,
                          files::quoted(word.text) + " is not a number for pinned",
                          word.line,
                          {}});
    return number != 0;
  }

  void add_point(const Word* words)
  {
    Curve_draft::Point point;
    for(std::size_t k = 0; k < 3; ++k)
      if(!files::parse_number(words[k].text, point[k]))
        return m_file.add_unreadable_point({Kind::UNPARSABLE_NUMBER,
                                            files::quoted(words[k].text) + " is not a number",
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
            m_file.defects.add({Kind::SHORT_LINE, "a line needs two indices", line});
          for(std::size_t i = 1; i < points.size(); ++i)
            m_file.add_edge(points[i - 1], points[i], line);
        });
  }

  bool add_faces(std::size_t first_point, const Cells& cells, Polygons& faces)
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
      if(!files::parse_integer(offset.text, end) || end < begin || end > size)
        return refuse(Kind::BAD_INDEX,
                      files::quoted(offset.text) + " is no place where a line of " +
                          std::to_string(size) + " indices can end",
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
    if(!files::parse_integer(word.text, v) || v >= number_of_points)
      return refuse(Kind::BAD_INDEX,
                    files::quoted(word.text) + " is not the index of one of " +
                        std::to_string(number_of_points) + " points",
                    word.line);
    points.push_back(first_point + v);
    return true;
  }

  std::string_view m_text;
  files::Readable_text m_readable; // all tags but those of appended data
  Xml_scanner m_tags;
  Xml_scanner m_file_tag{""};             // which stands at <VTKFile>
  std::optional<Vtk_encoding> m_encoding; // as soon as an array needs it
  std::list<std::string> m_decoded;       // arrays
  Curve_draft m_file;
  Piece m_piece;
  Polygons* m_polygons; // null if lines are read
  Polygons m_strips;
  std::string_view m_section; // what the next array belongs to, empty if that does not matter
  std::size_t m_line_of_face = 0;
  bool m_has_lines = false;
};

} // namespace

Curve_draft read_vtp(std::string_view text, Junctions)
{
  return Vtp_reader(text, nullptr).run();
}

Curve_draft read_vtp_surface(std::string_view text, Polygons& polygons)
{
  return Vtp_reader(text, &polygons).run();
}

} // namespace vfc
