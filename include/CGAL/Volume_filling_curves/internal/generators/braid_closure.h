// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_BRAID_CLOSURE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_BRAID_CLOSURE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

constexpr int max_letter = 1000; // of a braid word

inline bool is_letter(int letter)
{
  return letter != 0 && letter >= -max_letter && letter <= max_letter;
}

/* returns the letters of a braid word such as "1 -2 1 -2": i exchanges the strands i and i + 1, -i
 * does so the other way round.
 * \throws std::invalid_argument if a letter is not an integer other than 0
 */
inline std::vector<int> parse_braid_word(const std::string& text)
{
  std::vector<int> word;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic()); // another locale may group digits by commas
  for(std::string token; stream >> token;) {
    std::istringstream letter_stream(token);
    letter_stream.imbue(stream.getloc());
    int letter = 0;
    if(!(letter_stream >> letter) || !letter_stream.eof() || !is_letter(letter))
      throw std::invalid_argument("letter '" + token + "' of the braid word is not an integer in " +
                                  "1, ..., 1000 or its negative");
    word.push_back(letter);
  }
  return word;
}

// Closure of a braid around the z-axis. Strands run side by side on circles whose radii differ by
// 1. A letter turns two strands around each other by a half turn within its sector; they stay at
// distance 1 from each other and from all others. Letters without a common strand share a sector.
// Positive letters make positive crossings.
class Braid_closure
{
public:
  Braid_closure(std::vector<int> word, std::size_t number_of_strands)
      : m_word(std::move(word)), m_strands(number_of_strands)
  {
    for(int letter : m_word) {
      if(!is_letter(letter))
        throw std::invalid_argument("the letter " + std::to_string(letter) + " of the braid is " +
                                    "not an integer in 1, ..., 1000 or its negative");
      m_strands = (std::max)(m_strands, upper_strand(letter) + 1);
    }
    if(m_strands > max_strands)
      throw std::invalid_argument("a braid has at most " + std::to_string(max_strands) +
                                  " strands, not " + std::to_string(m_strands));
    m_strands = (std::max)(m_strands, std::size_t(1));
    assign_sectors();
  }

  Polygons operator()(std::size_t number_of_nodes, std::uint64_t seed) const
  {
    Polygons curves;
    const std::size_t samples = (std::max)(min_samples, samples_per_node * number_of_nodes /
                                                            (m_strands * m_sectors.size()));
    std::vector<bool> is_used(m_strands, false);
    for(std::size_t strand = 0; strand < m_strands; ++strand) {
      if(is_used[strand]) continue;
      curves.emplace_back();
      for(std::size_t s = strand; !is_used[s]; s = run_around(s, samples, curves.back()))
        is_used[s] = true;
    }
    Polygons result = equally_spaced(curves, number_of_nodes, max_spacing);
    turn_randomly(result, seed);
    return result;
  }

private:
  static constexpr std::size_t max_strands = 10000; // they need hundreds of millions of nodes
  static constexpr std::size_t min_samples = 64;    // per sector
  static constexpr double min_sector_length = 3;    // on the innermost circle, in strand distances
  // With it a chord leaves its strand, of curvature 1.8 at most, by less than 0.25.
  static constexpr double max_spacing = 1;

  static std::size_t upper_strand(int letter) { return static_cast<std::size_t>(std::abs(letter)); }

  // A letter goes into the first sector after all letters before it that share a strand with it.
  void assign_sectors()
  {
    std::vector<std::size_t> next_sector(m_strands, 0);
    for(int letter : m_word) {
      const std::size_t upper = upper_strand(letter), lower = upper - 1;
      const std::size_t sector = (std::max)(next_sector[lower], next_sector[upper]);
      next_sector[lower] = next_sector[upper] = sector + 1;
      if(sector == m_sectors.size()) m_sectors.emplace_back(m_strands, 0);
      m_sectors[sector][lower] = m_sectors[sector][upper] = letter;
    }
    if(m_sectors.empty()) m_sectors.emplace_back(m_strands, 0);
  }

  double inner_radius() const
  {
    const double sectors = static_cast<double>(m_sectors.size());
    return (std::max)(2., sectors * min_sector_length / (2 * CGAL_PI));
  }

  // Appends one turn around the axis; returns the strand at which it ends.
  std::size_t run_around(std::size_t strand, std::size_t samples, Polygon& curve) const
  {
    unsigned calls = 0;
    for(std::size_t sector = 0; sector < m_sectors.size(); ++sector) {
      const int letter = m_sectors[sector][strand];
      for(std::size_t i = 0; i < samples; ++i) {
        check_run_sometimes(calls);
        const double t = static_cast<double>(i) / static_cast<double>(samples);
        curve.push_back(position(strand, letter, sector, t));
      }
      if(letter != 0) strand = upper_strand(letter) == strand ? strand - 1 : strand + 1;
    }
    return strand;
  }

  Vector position(std::size_t strand, int letter, std::size_t sector, double t) const
  {
    double radius = inner_radius() + static_cast<double>(strand), height = 0;
    if(letter != 0) {
      const double side = upper_strand(letter) == strand ? 0.5 : -0.5;
      const auto [x, y] = cos_sin(0.5 * t * t * (3 - 2 * t)); // starts and ends at rest
      radius += side * (x - 1);
      height = (letter > 0 ? -side : side) * y;
    }
    const double sectors = static_cast<double>(m_sectors.size());
    const auto [x, y] = cos_sin((static_cast<double>(sector) + t) / sectors);
    return {radius * x, radius * y, height};
  }

  std::vector<int> m_word;
  std::size_t m_strands;
  std::vector<std::vector<int>> m_sectors; // per sector and strand the letter, 0 if none
};

/* returns the closure of a braid, see `parse_braid_word()` and `Braid_closure`. `number_of_strands`
 * asks for more strands than the word uses: an empty word with n strands is the unlink of n
 * circles.
 * \throws std::invalid_argument if the nodes are too few, or if there are more than 10,000 strands
 */
inline Polygons braid_closure(const std::vector<int>& word,
                              std::size_t number_of_nodes,
                              std::uint64_t seed = 0,
                              std::size_t number_of_strands = 1)
{
  return Braid_closure(word, number_of_strands)(number_of_nodes, seed);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_BRAID_CLOSURE_H
