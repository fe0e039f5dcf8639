// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_CODES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_CODES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The planar diagram code that KnotTheory reads, with arcs from 1 on:
// "PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]". A component without crossings is "Loop[7]".
inline std::string pd_code(const Planar_diagram& diagram)
{
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for(const auto& x : diagram.crossings) {
    std::string arcs;
    for(const std::uint32_t arc : x) arcs += (arcs.empty() ? "" : ", ") + std::to_string(arc + 1);
    add("X[" + arcs + ']');
  }
  for(std::size_t k = 1; k <= diagram.number_of_free_loops; ++k)
    add("Loop[" + std::to_string(2 * diagram.crossings.size() + k) + ']');
  return "PD[" + text + ']';
}

// Signed Gauss code: the passes of each component in order, as the crossing with its level and
// sign: "O1+U2+O3+U1+O2+U3+". Crossings are numbered by first occurrence. Components are separated
// by " / "; one without crossings is "-". It determines the diagram on the sphere.
inline std::string gauss_code(const Planar_diagram& diagram)
{
  const Diagram_strands strands(diagram);
  std::vector<std::size_t> numbers(diagram.crossings.size(), 0);
  std::size_t number = 0;
  std::string text;
  for(std::size_t c = 0; c < strands.number_of_components(); ++c) {
    if(c > 0) text += " / ";
    for(std::size_t arc = strands.first_arc(c); arc < strands.first_arc(c + 1); ++arc) {
      const auto pass = strands.target(arc);
      if(numbers[pass.crossing] == 0) numbers[pass.crossing] = ++number;
      text += (pass.k == 0 ? 'U' : 'O') + std::to_string(numbers[pass.crossing]) +
              (strands.sign(pass.crossing) > 0 ? '+' : '-');
    }
  }
  for(std::size_t k = 0; k < diagram.number_of_free_loops; ++k) text += text.empty() ? "-" : " / -";
  return text;
}

// Code of Dowker and Thistlethwaite (1983) of a knot: passes are numbered from 1, and each odd one
// contributes the number of the even one at the same crossing, with a minus if that is the upper
// one: "4 6 2". It does not distinguish a knot from its mirror image.
// \throws std::invalid_argument unless there is one component
inline std::string dt_code(const Planar_diagram& diagram)
{
  if(number_of_components(diagram) != 1)
    throw std::invalid_argument("only a knot has a Dowker-Thistlethwaite code");
  const Diagram_strands strands(diagram);
  std::vector<int> codes(diagram.crossings.size());
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    const auto& x = diagram.crossings[c];
    const std::size_t lower = x[0], upper = strands.sign(c) > 0 ? x[3] : x[1];
    const std::size_t odd = lower % 2 == 0 ? lower : upper, even = lower + upper - odd;
    codes[odd / 2] = static_cast<int>(even + 1) * (even == upper ? -1 : 1);
  }
  std::string text;
  for(const int code : codes) text += (text.empty() ? "" : " ") + std::to_string(code);
  return text;
}

// Reads the number that begins at a position, which moves behind it.
inline std::uint32_t read_number(const std::string& text, std::size_t& position)
{
  constexpr std::uint32_t max_number = 100000000;
  std::uint32_t number = 0;
  for(; position < text.size() && std::isdigit(static_cast<unsigned char>(text[position]));
      ++position) {
    number = 10 * number + static_cast<std::uint32_t>(text[position] - '0');
    if(number > max_number)
      throw std::invalid_argument("the code has a number above 10^8, which begins with " +
                                  std::to_string(number));
  }
  return number;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_DIAGRAM_CODES_H
