// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_OFF_ITEMS_H
#define VFC_OFF_ITEMS_H

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// The vertices and faces of an OFF file in text form, one after the other. Usually each of them has
// a line, and what else stands there, such as colors, does not matter. Geomview, whose format this
// is, takes three words for a vertex wherever lines end; a face ends its line, since a color may
// follow. Files whose vertices must be read like that have not enough lines, but enough words, or
// their first line is too short for a vertex.
class Off_items
{
public:
  explicit Off_items(std::string_view text);

  // returns whether there is a header; its numbers are those that the file announces
  bool has_header() const { return m_has_header; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  std::size_t number_of_faces() const { return m_number_of_faces; }

  // returns whether a vertex begins with its three coordinates, behind which there may be a normal,
  // a color and a place in a texture; other keywords announce a fourth one, or another number
  bool is_plain() const { return m_is_plain; }

  // returns whether the keyword announces textures, colors or normals in text form, be it right or
  // wrong
  bool has_extras() const { return m_keyword.find_first_of("SCN") == 0 && !m_is_binary; }

  // returns whether vertices do not have a line each
  bool are_vertices_free() const { return m_are_vertices_free; }

  // Goes to the next vertex or face. Returns whether there is one.
  bool next_vertex();
  bool next_face();

  // the number of the line where the item begins
  std::size_t line() const { return m_line; }

  // a word of the item, which is empty if there is none
  std::string_view word(std::size_t i) const
  {
    return i < m_item.size() ? m_item[i] : std::string_view();
  }

private:
  using Words = std::vector<std::string_view>;

  bool read_header();
  bool must_free_vertices() const;
  bool next_line();
  void add_words(std::string_view line);
  bool take_line();
  bool take_words(std::size_t number);

  std::string_view m_text, m_keyword;
  std::size_t m_place = 0, m_number = 0; // behind the last line, and its number
  Words m_words;                         // of the last line
  std::size_t m_taken = 0;               // of them
  Words m_item;
  std::size_t m_line = 0;
  bool m_has_header = false, m_is_plain = false, m_are_vertices_free = false;
  bool m_is_binary = false;
  std::size_t m_number_of_vertices = 0, m_number_of_faces = 0;
};

// Reads a number; the whole word has to be one.
template <typename Number>
bool parse_off_word(std::string_view word, Number& number)
{
  const bool has_plus = !word.empty() && word[0] == '+';
  return CGAL::Volume_filling_curves::internal::parse_all(word.substr(has_plus ? 1 : 0), number);
}

} // namespace vfc

#endif // VFC_OFF_ITEMS_H
