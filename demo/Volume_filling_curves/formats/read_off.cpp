// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/binary_numbers.h"
#include "formats/readers.h"

#include <CGAL/Volume_filling_curves/internal/text/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace vfc {
namespace {

namespace files = CGAL::Volume_filling_curves::internal;
using Kind = CGAL::Volume_filling_curves::Curve_defect_kind;

constexpr char too_much[] = "more vertices or faces are announced than the file can hold";

std::string without_comments(std::string_view text)
{
  std::string result(text);
  for(std::size_t i = result.find('#'); i < result.size(); i = result.find('#', i))
    for(; i < result.size() && result[i] != '\n'; ++i) result[i] = ' ';
  return result;
}

// Reads Geomview's OFF in text form, with or without textures, colors, normals and a fourth
// coordinate, all of which but the last are passed over. CGAL's reader takes three times as long
// (0.65 s instead of 0.2 s for 320,000 triangles), refuses files without a reason, reads beyond
// lines that lack a texture or color, and allocates whatever a file announces.
//
// Usually each vertex and face has a line. Geomview takes three words for a vertex wherever lines
// end; a face ends its line, since a color may follow. Files whose vertices must be read like that
// have not enough lines, but enough words, or their first line is too short for a vertex.
class Off_reader
{
public:
  Off_reader(std::string_view text, Polygons& polygons)
      : m_text(without_comments(text)), m_words(m_text), m_polygons(polygons)
  {}

  Curve_draft run()
  {
    m_draft.is_complete = read_header();
    if(m_draft.is_complete) m_are_vertices_free = m_keyword == "OFF" && must_free_vertices();
    for(std::size_t i = 0; i < m_vertices && m_draft.is_complete; ++i)
      m_draft.is_complete = begin(i, m_vertices, " vertices") && read_vertex();
    for(std::size_t i = 0; i < m_faces && m_draft.is_complete; ++i)
      m_draft.is_complete = begin(i, m_faces, " faces") && read_face();
    return std::move(m_draft);
  }

private:
  bool refuse(Kind kind, const std::string& message)
  {
    m_draft.defects.add({kind, message, m_line});
    return false;
  }

  // returns the next word, in whatever line, or an empty one at the end of the file
  std::string_view next_word()
  {
    std::string_view word = m_words.next_word();
    for(; word.empty() && !m_words.is_at_end(); word = m_words.next_word()) m_words.next_record();
    return word;
  }

  std::string_view next_word_of_item()
  {
    return m_are_vertices_free ? next_word() : m_words.next_word();
  }

  bool read_header()
  {
    m_keyword = next_word();
    m_line = m_words.line();
    std::string_view rest = m_keyword;
    for(const std::string_view part : {"ST", "C", "N", "4"})
      if(rest.substr(0, part.size()) == part) rest.remove_prefix(part.size());
    m_is_homogeneous = m_keyword.find('4') != std::string_view::npos;
    if(rest != "OFF") return refuse(Kind::UNREADABLE_FILE, "the first word is no keyword of OFF");
    if(!files::parse_integer(next_word(), m_vertices) ||
       !files::parse_integer(next_word(), m_faces))
      return refuse(Kind::UNREADABLE_FILE, "the numbers of vertices and faces are missing");
    m_line = m_words.line();
    m_words.next_record();
    return (m_vertices <= m_text.size() && m_faces <= m_text.size()) ||
           refuse(Kind::WRONG_POINT_COUNT, too_much);
  }

  bool must_free_vertices() const
  {
    files::Text_scanner scanner = m_words;
    std::size_t lines = 0, words = 0, first = 0;
    for(; !scanner.is_at_end(); scanner.next_record()) {
      const std::size_t before = words;
      while(!scanner.next_word().empty()) ++words;
      if(words > before && ++lines == 1) first = words;
    }
    return words >= 3 * m_vertices + 4 * m_faces && (lines < m_vertices + m_faces || first < 3);
  }

  // Goes to the first word of an item.
  bool begin(std::size_t i, std::size_t announced, const char* items)
  {
    m_word = next_word();
    if(m_word.empty())
      return refuse(Kind::WRONG_POINT_COUNT, "the file ends after " + std::to_string(i) + " of " +
                                                 std::to_string(announced) + items);
    m_line = m_words.line();
    return true;
  }

  bool read_vertex()
  {
    std::array<double, 4> x = {0, 0, 0, 1};
    std::string_view wrong = "";
    bool is_wrong = false;
    for(std::size_t k = 0; k < (m_is_homogeneous ? 4 : 3); ++k) {
      if(k > 0) m_word = next_word_of_item();
      if(is_wrong || files::parse_number(m_word, x[k])) continue;
      is_wrong = true;
      wrong = m_word;
    }
    if(is_wrong)
      m_draft.add_unreadable_point({Kind::UNPARSABLE_NUMBER,
                                    files::quoted(wrong) + " is no coordinate",
                                    m_line,
                                    {Curve_draft::number(m_draft.points.size())}});
    else
      m_draft.add_point({x[0] / x[3], x[1] / x[3], x[2] / x[3]}, m_line);
    if(!m_are_vertices_free) m_words.next_record();
    return true;
  }

  bool read_face()
  {
    std::size_t corners = 0;
    if(!files::parse_integer(m_word, corners)) {
      refuse(Kind::UNPARSABLE_NUMBER, files::quoted(m_word) + " is no number of corners");
      corners = 0;
    }
    if(corners > m_text.size())
      return refuse(Kind::BAD_INDEX, "a face has " + std::to_string(corners) + " corners");
    m_polygons.emplace_back();
    while(m_polygons.back().size() < corners && read_corner()) continue;
    m_words.next_record();
    return true;
  }

  bool read_corner()
  {
    m_word = next_word_of_item();
    long long index = 0;
    if(!files::parse_integer(m_word, index))
      return refuse(Kind::BAD_INDEX, m_word.empty()
                                         ? "a corner is missing"
                                         : files::quoted(m_word) + " is no vertex index");
    m_polygons.back().push_back(static_cast<std::size_t>(index));
    return (index >= 0 && m_polygons.back().back() < m_vertices) ||
           refuse(Kind::BAD_INDEX,
                  "there is no vertex " + std::to_string(index) + " (numbered from 0)");
  }

  std::string m_text;
  files::Text_scanner m_words;
  Curve_draft m_draft;
  Polygons& m_polygons;
  std::string_view m_keyword, m_word;
  std::size_t m_line = 0; // where the item begins
  std::size_t m_vertices = 0, m_faces = 0;
  bool m_is_homogeneous = false, m_are_vertices_free = false;
};

// Reads OFF in binary form: whole numbers and floats of four bytes, the highest byte first; a face
// has the number of its corners, these, and the number of the values of its color, which are
// skipped. CGAL 5.5 misreads their faces.
class Binary_off_reader
{
public:
  Binary_off_reader(std::string_view bytes, Polygons& polygons)
      : m_size(bytes.size()), m_bytes(bytes), m_polygons(polygons)
  {}

  Curve_draft run()
  {
    m_draft.is_complete = read();
    return std::move(m_draft);
  }

private:
  bool refuse(Kind kind, const std::string& message)
  {
    m_draft.defects.add({kind, message});
    return false;
  }

  bool read()
  {
    const std::size_t vertices = number(), faces = number();
    number(); // edges, which nobody counts
    if(m_has_ended || vertices > m_bytes.size() / 12 || faces > m_bytes.size() / 4)
      return refuse(Kind::WRONG_POINT_COUNT, too_much);
    for(std::size_t v = 0; v < vertices; ++v) {
      const double x = real(), y = real(), z = real();
      m_draft.add_point({x, y, z}, 0);
    }
    for(std::size_t f = 1; f <= faces; ++f)
      if(!read_face(f, faces)) return false;
    return true;
  }

  bool read_face(std::size_t face, std::size_t faces)
  {
    const std::size_t corners = number();
    if(corners > m_size)
      return refuse(Kind::BAD_INDEX, "face " + std::to_string(face) + " has " +
                                         std::to_string(corners) + " corners");
    m_polygons.emplace_back();
    for(std::size_t i = 0; i < corners; ++i) m_polygons.back().push_back(number());
    for(std::size_t i = number(); i > 0 && !m_has_ended; --i) number(); // the color
    return !m_has_ended ||
           refuse(Kind::WRONG_POINT_COUNT, "the file ends within face " + std::to_string(face) +
                                               " of " + std::to_string(faces));
  }

  // Past the end numbers are zero.
  std::uint32_t number()
  {
    m_has_ended = m_has_ended || m_bytes.size() < 4;
    if(m_has_ended) return 0;
    const std::uint64_t bits = bits_of(m_bytes.substr(0, 4), true);
    m_bytes.remove_prefix(4);
    return static_cast<std::uint32_t>(bits);
  }

  double real() { return real_of<float>(number()); }

  std::size_t m_size;
  std::string_view m_bytes;
  Polygons& m_polygons;
  Curve_draft m_draft;
  bool m_has_ended = false;
};

} // namespace

Curve_draft read_off_surface(std::string_view text, Polygons& polygons)
{
  constexpr std::string_view magic = "OFF BINARY\n";
  if(text.substr(0, magic.size()) != magic) return Off_reader(text, polygons).run();
  return Binary_off_reader(text.substr(magic.size()), polygons).run();
}

} // namespace vfc
