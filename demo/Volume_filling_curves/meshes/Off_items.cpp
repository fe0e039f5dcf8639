// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "meshes/Off_items.h"

#include <algorithm>

namespace vfc {

Off_items::Off_items(std::string_view text) : m_text(text)
{
  m_has_header = read_header();
  const std::string_view keyword = m_keyword;
  for(const std::string_view known :
      {"OFF", "NOFF", "COFF", "CNOFF", "STOFF", "STNOFF", "STCOFF", "STCNOFF"})
    m_is_plain = m_is_plain || (m_has_header && keyword == known);
  if(m_is_plain && keyword == "OFF") m_are_vertices_free = must_free_vertices();
}

bool Off_items::next_vertex()
{
  return m_are_vertices_free ? take_words(3) : take_line();
}

bool Off_items::next_face()
{
  if(!m_are_vertices_free) return take_line();
  if(!take_words(1)) return false;
  std::size_t corners = 0;
  if(parse_off_word(word(0), corners) && corners <= m_text.size()) {
    const std::string_view number = word(0);
    const std::size_t line = m_line;
    if(!take_words(corners)) return false;
    m_item.insert(m_item.begin(), number);
    m_line = line;
  }
  m_taken = m_words.size(); // the color
  return true;
}

bool Off_items::read_header()
{
  if(!next_line()) return false;
  m_keyword = m_words[0];
  m_is_binary = m_words.size() > 1 && m_words[1] == "BINARY";
  if(m_keyword.size() < 3 || m_keyword.substr(m_keyword.size() - 3) != "OFF") return false;
  const bool has_numbers = m_words.size() > 1;
  if(!has_numbers && !next_line()) return false;
  const std::size_t first = has_numbers ? 1 : 0;
  m_taken = m_words.size();
  m_line = m_number;
  return m_words.size() > first + 1 && parse_off_word(m_words[first], m_number_of_vertices) &&
         parse_off_word(m_words[first + 1], m_number_of_faces);
}

bool Off_items::must_free_vertices() const
{
  if(m_number_of_vertices > m_text.size() || m_number_of_faces > m_text.size()) return false;
  Off_items rest = *this;
  std::size_t lines = 0, words = 0, first = 0;
  for(; rest.next_line(); ++lines) {
    words += rest.m_words.size();
    if(lines == 0) first = words;
  }
  constexpr std::size_t least_for_vertex = 3, least_for_face = 4;
  const bool has_words =
      words >= least_for_vertex * m_number_of_vertices + least_for_face * m_number_of_faces;
  return has_words &&
         (lines < m_number_of_vertices + m_number_of_faces || first < least_for_vertex);
}

// Goes to the next line that has words, without comments.
bool Off_items::next_line()
{
  m_words.clear();
  m_taken = 0;
  while(m_words.empty() && m_place < m_text.size()) {
    const std::size_t line_end = (std::min)(m_text.find('\n', m_place), m_text.size());
    const std::string_view line = m_text.substr(m_place, line_end - m_place);
    add_words(line.substr(0, line.find('#')));
    m_place = line_end + 1;
    ++m_number;
  }
  return !m_words.empty();
}

void Off_items::add_words(std::string_view line)
{
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  for(std::size_t i = 0; i < line.size();) {
    const std::size_t first = i;
    while(i < line.size() && !is_blank(line[i])) ++i;
    if(i > first) m_words.push_back(line.substr(first, i - first));
    while(i < line.size() && is_blank(line[i])) ++i;
  }
}

bool Off_items::take_line()
{
  const bool is_there = next_line();
  m_item = m_words;
  m_line = m_number;
  return is_there;
}

// Takes the next words, of as many lines as that needs. Returns whether there are so many.
bool Off_items::take_words(std::size_t number)
{
  m_item.clear();
  while(m_item.size() < number) {
    const bool is_there = m_taken < m_words.size() || next_line();
    if(m_item.empty()) m_line = m_number;
    if(!is_there) return false;
    m_item.push_back(m_words[m_taken++]);
  }
  return true;
}

} // namespace vfc
