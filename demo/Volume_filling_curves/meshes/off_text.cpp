// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/mesh_text.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace vfc {
namespace {

template <typename Number>
bool parse_word(std::string_view word, Number& number)
{
  const std::size_t start = !word.empty() && word[0] == '+' ? 1 : 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data() + start, last, number);
  return error == std::errc() && end == last;
}

// The words of one line after the other, without comments and empty lines.
class Lines
{
public:
  explicit Lines(std::string_view text) : m_text(text) {}

  // returns whether there is another line
  bool next()
  {
    m_words.clear();
    while(m_words.empty() && m_place < m_text.size()) {
      const std::size_t end = (std::min)(m_text.find('\n', m_place), m_text.size());
      split(m_text.substr(m_place, end - m_place));
      m_place = end + 1;
      ++m_number;
    }
    return !m_words.empty();
  }

  std::size_t number() const { return m_number; }

  // returns a word of the line, which is empty if there is none
  std::string_view word(std::size_t i) const
  {
    return i < m_words.size() ? m_words[i] : std::string_view();
  }

private:
  void split(std::string_view line)
  {
    const char* const blanks = " \t\r\v\f";
    line = line.substr(0, line.find('#'));
    for(std::size_t end = 0;;) {
      const std::size_t first = line.find_first_not_of(blanks, end);
      if(first == std::string_view::npos) return;
      end = (std::min)(line.find_first_of(blanks, first), line.size());
      m_words.push_back(line.substr(first, end - first));
    }
  }

  std::string_view m_text;
  std::size_t m_place = 0, m_number = 0;
  std::vector<std::string_view> m_words;
};

class Off_text
{
public:
  explicit Off_text(std::string_view text) : m_size(text.size()), m_lines(text) {}

  std::vector<Text_problem> problems()
  {
    if(!read_header()) return {};
    if(m_vertices > m_size || m_faces > m_size)
      complain("truncated file", "more vertices or faces are announced than the file can hold",
               true);
    for(std::size_t i = 0; i < m_vertices && can_go_on("vertices", i, m_vertices); ++i)
      read_vertex();
    for(std::size_t i = 0; i < m_faces && can_go_on("faces", i, m_faces); ++i) read_face();
    return std::move(m_problems);
  }

private:
  // returns whether this is an OFF file in text form
  bool read_header()
  {
    if(!m_lines.next()) return false;
    const std::string_view keyword = m_lines.word(0);
    if(keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF") return false;
    std::size_t first = 1;
    if(m_lines.word(1).empty()) first = m_lines.next() ? 0 : 1;
    return parse_word(m_lines.word(first), m_vertices) &&
           parse_word(m_lines.word(first + 1), m_faces);
  }

  // goes to the line of item i
  bool can_go_on(const char* items, std::size_t i, std::size_t announced)
  {
    if(m_has_ended) return false;
    if(m_lines.next()) return true;
    complain("truncated file", "the file ends after " + std::to_string(i) + " of " +
                                   std::to_string(announced) + ' ' + items);
    m_has_ended = true;
    return false;
  }

  void read_vertex()
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      double x = 0;
      if(!parse_word(m_lines.word(axis), x))
        return complain("unparsable number", in_quotes(m_lines.word(axis)) + " is no coordinate");
      if(!std::isfinite(x)) return complain("non-finite coordinate", "a coordinate is not finite");
    }
  }

  void read_face()
  {
    std::size_t corners = 0;
    if(!parse_word(m_lines.word(0), corners))
      return complain("unparsable number", in_quotes(m_lines.word(0)) + " is no number of corners");
    if(corners > m_size)
      return complain("bad index", "a face has " + std::to_string(corners) + " corners", true);
    for(std::size_t i = 1; i <= corners; ++i) {
      const std::string_view word = m_lines.word(i);
      long long index = 0;
      if(!parse_word(word, index))
        return complain("bad index", word.empty() ? "a corner is missing"
                                                  : in_quotes(word) + " is no vertex index");
      if(index < 0 || static_cast<std::size_t>(index) >= m_vertices)
        complain("bad index",
                 "there is no vertex " + std::to_string(index) + " (they count from 0)");
    }
  }

  void complain(const std::string& kind, const std::string& message, bool is_about_amounts = false)
  {
    m_problems.push_back({kind, message, m_lines.number(), is_about_amounts});
    m_has_ended = m_has_ended || is_about_amounts;
  }

  std::size_t m_size;
  Lines m_lines;
  std::size_t m_vertices = 0, m_faces = 0;
  bool m_has_ended = false;
  std::vector<Text_problem> m_problems;
};

} // namespace

std::vector<Text_problem> problems_of_off(std::string_view text)
{
  return Off_text(text).problems();
}

} // namespace vfc
