// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PD_CODE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PD_CODE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_codes.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reader of the planar diagram codes that pd_code() writes, and of other notations: with any
// brackets or none, with the words of KnotTheory or none, with arcs from 0 or 1 on.
class Pd_code_reader
{
public:
  explicit Pd_code_reader(const std::string& text) : m_text(text) {}

  // \throws std::invalid_argument with the reason
  Planar_diagram operator()()
  {
    while(m_position < m_text.size()) read_item();
    if(!m_open.empty()) fail(m_open.back().position, m_open.back().position + 1, "is not closed");
    if(m_is_loop) throw std::invalid_argument("the last 'Loop' has no number");
    if(!m_has_item) throw std::invalid_argument("the planar diagram code is empty");
    if(m_arcs.size() % 4 != 0)
      throw std::invalid_argument(std::to_string(m_arcs.size()) +
                                  " arcs are not four for each crossing");
    add_crossings();
    return m_diagram;
  }

private:
  struct Bracket
  {
    std::size_t position, number_of_arcs; // before it
  };

  void read_item()
  {
    const char c = m_text[m_position];
    if(is_separator(c)) {
      ++m_position;
      return;
    }
    m_has_item = true;
    if(is_letter(c))
      read_word();
    else if(is_digit(c))
      read_arc();
    else if(is_one_of(c, "[({"))
      m_open.push_back({m_position++, m_arcs.size()});
    else if(is_one_of(c, "])}"))
      close_bracket();
    else
      fail(m_position, m_position + 1, "is not part of a planar diagram code");
  }

  static bool is_one_of(char c, const std::string& characters)
  {
    return characters.find(c) != std::string::npos;
  }
  static bool is_separator(char c)
  {
    return std::isspace(static_cast<unsigned char>(c)) || is_one_of(c, ",;_");
  }
  static bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)); }
  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

  // A part of the text is the culprit.
  [[noreturn]] void fail(std::size_t first, std::size_t end, const std::string& reason) const
  {
    throw std::invalid_argument("'" + m_text.substr(first, end - first) + "' " + reason);
  }

  void read_word()
  {
    const std::size_t first = m_position;
    while(m_position < m_text.size() && is_letter(m_text[m_position])) ++m_position;
    const std::string word = m_text.substr(first, m_position - first);
    if(m_is_loop) fail(first, m_position, "stands where a 'Loop' must have its number");
    if(word == "Loop") {
      ++m_diagram.number_of_free_loops;
      m_is_loop = true;
    } else if(word != "PD" && word != "X" && word != "Xp" && word != "Xm")
      fail(first, m_position, "is not part of a planar diagram code");
  }

  // Also reads the number of a component without crossings, which is ignored.
  void read_arc()
  {
    const std::uint32_t arc = read_number(m_text, m_position);
    if(!m_is_loop) m_arcs.push_back(arc);
    m_is_loop = false;
  }

  void close_bracket()
  {
    const char c = m_text[m_position++];
    if(m_open.empty()) fail(m_position - 1, m_position, "closes a bracket that is not open");
    const Bracket bracket = m_open.back();
    m_open.pop_back();
    const std::string pair{m_text[bracket.position], c};
    if((pair != "()" && pair != "[]" && pair != "{}") || m_is_loop ||
       (m_arcs.size() - bracket.number_of_arcs) % 4 != 0)
      fail(bracket.position, m_position, "is not a list of crossings with four arcs each");
  }

  void add_crossings()
  {
    const bool is_from_zero = std::find(m_arcs.begin(), m_arcs.end(), 0u) != m_arcs.end();
    const std::uint32_t first = is_from_zero ? 0 : 1;
    for(std::size_t k = 0; k < m_arcs.size(); k += 4)
      m_diagram.crossings.push_back(
          {m_arcs[k] - first, m_arcs[k + 1] - first, m_arcs[k + 2] - first, m_arcs[k + 3] - first});
    check_planar_diagram(m_diagram, first);
  }

  const std::string& m_text;
  std::size_t m_position = 0;
  Planar_diagram m_diagram;
  std::vector<Bracket> m_open;
  std::vector<std::uint32_t> m_arcs; // as they are numbered in the text
  bool m_is_loop = false; // whether the next number belongs to a component without crossings
  bool m_has_item = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PD_CODE_READER_H
