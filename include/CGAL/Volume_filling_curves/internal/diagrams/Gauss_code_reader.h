// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GAUSS_CODE_READER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GAUSS_CODE_READER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_codes.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reader of the codes that gauss_code() writes; crossings may have any numbers.
class Gauss_code_reader
{
public:
  explicit Gauss_code_reader(const std::string& text) : m_text(text) {}

  // \throws std::invalid_argument with the reason
  Planar_diagram operator()()
  {
    bool has_component = false;
    while(m_position < m_text.size()) {
      const char c = m_text[m_position];
      if(!std::isspace(static_cast<unsigned char>(c))) {
        has_component = true;
        read_item(c);
      } else
        ++m_position;
    }
    if(has_component) end_component();
    check();
    return m_diagram;
  }

private:
  struct Pass
  {
    std::size_t crossing;
    bool is_over;
  };

  void read_item(char c)
  {
    const bool is_pass = c == 'O' || c == 'U';
    if((is_pass && m_is_loop) || (c == '-' && (m_is_loop || !m_passes.empty())))
      throw std::invalid_argument("component " + std::to_string(m_component) +
                                  " has passes or a second '-' beside the '-' of a component "
                                  "without crossings");
    if(is_pass) {
      read_pass();
      return;
    }
    ++m_position;
    if(c == '-')
      m_is_loop = true;
    else if(c == '/')
      end_component();
    else
      throw std::invalid_argument(std::string("'") + c + "' is not part of a Gauss code");
  }

  // The crossing with its level and sign, like "O1+"
  void read_pass()
  {
    const std::size_t start = m_position;
    const bool is_over = m_text[m_position++] == 'O';
    const std::uint32_t name = read_number(m_text, m_position);
    const char sign = m_position < m_text.size() ? m_text[m_position] : ' ';
    if(m_position == start + 1 || (sign != '+' && sign != '-'))
      throw std::invalid_argument("'" + m_text.substr(start, m_position - start) +
                                  "' is not a pass with a sign, like O1+");
    ++m_position;
    const std::size_t c = m_numbers.emplace(name, m_signs.size()).first->second;
    if(c == m_signs.size()) {
      m_signs.push_back(sign);
      m_is_seen.push_back({false, false});
      m_diagram.crossings.emplace_back();
    }
    if(m_signs[c] != sign) fail(name, "has two signs");
    if(m_is_seen[c][is_over]) fail(name, "has two passes on the same level");
    m_is_seen[c][is_over] = true;
    m_passes.push_back({c, is_over});
  }

  [[noreturn]] static void fail(std::uint32_t name, const std::string& reason)
  {
    throw std::invalid_argument("crossing " + std::to_string(name) + ' ' + reason);
  }

  void end_component()
  {
    const auto n = static_cast<std::uint32_t>(m_passes.size());
    if(n == 0 && !m_is_loop)
      throw std::invalid_argument("component " + std::to_string(m_component) +
                                  " of the Gauss code is empty");
    if(m_is_loop) ++m_diagram.number_of_free_loops;
    // a component of two arcs above all others begins at the smaller crossing, see Diagram_strands
    if(n == 2 && m_passes[0].is_over && m_passes[1].is_over &&
       m_passes[0].crossing > m_passes[1].crossing)
      std::swap(m_passes[0], m_passes[1]);
    for(std::uint32_t k = 0; k < n; ++k) {
      const Pass& pass = m_passes[k];
      auto& x = m_diagram.crossings[pass.crossing];
      const std::size_t in = !pass.is_over ? 0 : m_signs[pass.crossing] == '+' ? 3 : 1;
      x[in] = m_arc + k;
      x[(in + 2) % 4] = m_arc + (k + 1) % n;
    }
    m_arc += n;
    m_passes.clear();
    m_is_loop = false;
    ++m_component;
  }

  void check() const
  {
    for(const auto& [name, c] : m_numbers)
      if(!m_is_seen[c][0] || !m_is_seen[c][1]) fail(name, "has one pass only");
    if(!is_planar_diagram(m_diagram))
      throw std::invalid_argument("the Gauss code is that of a virtual link, not of a diagram in "
                                  "the plane");
  }

  const std::string& m_text;
  std::size_t m_position = 0;
  std::size_t m_component = 1; // its number
  bool m_is_loop = false;      // whether the component is a '-'
  Planar_diagram m_diagram;
  std::map<std::uint32_t, std::size_t> m_numbers; // of the crossings, by their names
  std::vector<char> m_signs;
  std::vector<std::array<bool, 2>> m_is_seen; // the lower and the upper pass of each crossing
  std::vector<Pass> m_passes;                 // of the component
  std::uint32_t m_arc = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_GAUSS_CODE_READER_H
