// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/off_text.h"

#include "meshes/Off_items.h"

#include <array>
#include <cmath>
#include <utility>

namespace vfc {
namespace {

class Off_reader
{
public:
  Off_reader(std::string_view text, Off_text& result)
      : m_size(text.size()), m_items(text), m_result(result)
  {}

  void read()
  {
    m_result.is_plain = m_items.is_plain();
    m_result.has_extras = m_items.has_extras();
    if(!m_items.has_header()) return;
    const std::size_t vertices = m_items.number_of_vertices(), faces = m_items.number_of_faces();
    if(vertices > m_size || faces > m_size)
      complain("truncated file", "more vertices or faces are announced than the file can hold",
               true);
    for(std::size_t i = 0; i < vertices && !m_has_ended; ++i)
      if(is_there(m_items.next_vertex(), "vertices", i, vertices)) read_vertex();
    for(std::size_t i = 0; i < faces && !m_has_ended; ++i)
      if(is_there(m_items.next_face(), "faces", i, faces)) read_face();
  }

private:
  bool is_there(bool is_item, const char* items, std::size_t i, std::size_t announced)
  {
    if(is_item) return true;
    complain("truncated file", "the file ends after " + std::to_string(i) + " of " +
                                   std::to_string(announced) + ' ' + items);
    m_has_ended = true;
    return false;
  }

  void read_vertex()
  {
    std::array<double, 3> x;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      if(!parse_off_word(m_items.word(axis), x[axis]))
        return complain("unparsable number", in_quotes(m_items.word(axis)) + " is no coordinate");
      if(!std::isfinite(x[axis]))
        return complain("non-finite coordinate", "a coordinate is not finite");
    }
    m_result.points.emplace_back(x[0], x[1], x[2]);
  }

  void read_face()
  {
    std::size_t corners = 0;
    if(!parse_off_word(m_items.word(0), corners))
      return complain("unparsable number", in_quotes(m_items.word(0)) + " is no number of corners");
    if(corners > m_size)
      return complain("bad index", "a face has " + std::to_string(corners) + " corners", true);
    m_corners.clear();
    for(std::size_t i = 1; i <= corners; ++i) {
      const std::string_view word = m_items.word(i);
      long long index = 0;
      if(!parse_off_word(word, index))
        return complain("bad index", word.empty() ? "a corner is missing"
                                                  : in_quotes(word) + " is no vertex index");
      if(index < 0 || static_cast<std::size_t>(index) >= m_items.number_of_vertices())
        complain("bad index",
                 "there is no vertex " + std::to_string(index) + " (they count from 0)");
      m_corners.push_back(static_cast<std::size_t>(index));
    }
    m_result.polygons.push_back(m_corners);
  }

  void complain(const std::string& kind, const std::string& message, bool is_about_amounts = false)
  {
    m_result.problems.push_back({kind, message, m_items.line(), is_about_amounts});
    m_has_ended = m_has_ended || is_about_amounts;
  }

  std::size_t m_size;
  Off_items m_items;
  Off_text& m_result;
  std::vector<std::size_t> m_corners; // of a face
  bool m_has_ended = false;
};

} // namespace

Off_text::Off_text(std::string_view text)
{
  Off_reader(text, *this).read();
}

std::string off_with_lines(const std::string& text)
{
  Off_items items(text);
  if(!items.are_vertices_free()) return text;
  const std::size_t vertices = items.number_of_vertices(), faces = items.number_of_faces();
  std::string lines = "OFF\n" + std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n";
  const auto append = [&] {
    for(std::size_t i = 0; !items.word(i).empty(); ++i) (lines += items.word(i)) += ' ';
    lines += '\n';
  };
  for(std::size_t i = 0; i < vertices && items.next_vertex(); ++i) append();
  for(std::size_t i = 0; i < faces && items.next_face(); ++i) append();
  return lines;
}

} // namespace vfc
