// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_BRAID_DIAGRAMS_H
#define VFC_TEST_BRAID_DIAGRAMS_H

#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Test support: diagrams of closed braids. Letter i is a positive crossing of strands i and i + 1,
// -i its inverse.
namespace knot_test {

using CGAL::Volume_filling_curves::Planar_diagram;
using Braid_word = std::vector<int>;

struct Braid
{
  std::size_t strands;
  Braid_word word;
};

inline Braid braid(Braid_word word)
{
  int strands = 1;
  for(int letter : word) strands = (std::max)(strands, std::abs(letter) + 1);
  return {static_cast<std::size_t>(strands), std::move(word)};
}

inline Braid mirrored(Braid braid)
{
  for(int& letter : braid.word) letter = -letter;
  return braid;
}

// The braid in which other strands follow, joined by a crossing: its closure is a connected sum.
inline Braid connected_sum(Braid first, const Braid& second)
{
  const auto shift = static_cast<int>(first.strands) - 1;
  for(int letter : second.word) first.word.push_back(letter > 0 ? letter + shift : letter - shift);
  first.strands += second.strands - 1;
  return first;
}

// Strands run upwards, and a positive letter takes the left one over the right one.
inline Planar_diagram closure(const Braid& braid)
{
  std::vector<std::uint32_t> ends(braid.strands); // the arcs that have come up so far
  std::iota(ends.begin(), ends.end(), 0u);
  auto count = static_cast<std::uint32_t>(braid.strands);
  Planar_diagram diagram;
  for(int letter : braid.word) {
    const auto i = static_cast<std::size_t>(std::abs(letter) - 1);
    const std::uint32_t left = count++, right = count++;
    if(letter > 0)
      diagram.crossings.push_back({ends[i + 1], right, left, ends[i]});
    else
      diagram.crossings.push_back({ends[i], ends[i + 1], right, left});
    ends[i] = left;
    ends[i + 1] = right;
  }
  std::vector<std::uint32_t> next(count, 0), number(count, count);
  for(std::size_t c = 0; c < diagram.crossings.size(); ++c) {
    auto& x = diagram.crossings[c];
    for(std::uint32_t& arc : x)
      for(std::uint32_t i = 0; i < braid.strands; ++i)
        if(arc == ends[i]) arc = i;
    const bool is_positive = braid.word[c] > 0;
    next[x[0]] = x[2];
    next[x[is_positive ? 3 : 1]] = x[is_positive ? 1 : 3];
  }
  for(std::uint32_t i = 0; i < braid.strands; ++i) diagram.number_of_free_loops += ends[i] == i;
  std::uint32_t arcs = 0;
  for(const auto& x : diagram.crossings)
    for(std::uint32_t arc : x)
      for(; number[arc] == count; arc = next[arc]) number[arc] = arcs++;
  for(auto& x : diagram.crossings)
    for(std::uint32_t& arc : x) arc = number[arc];
  return diagram;
}

inline Braid random_braid(std::size_t strands, std::size_t letters, std::mt19937& random)
{
  Braid braid{strands, {}};
  for(std::size_t i = 0; i < letters; ++i) {
    const int letter = static_cast<int>(1 + random() % (strands - 1));
    braid.word.push_back(random() % 2 == 0 ? letter : -letter);
  }
  return braid;
}

// The braid after moves of Markov that keep its closure: conjugations, stabilizations, pairs of
// inverse letters, which are moves of Reidemeister in the diagram.
inline Braid with_random_moves(Braid braid, int moves, std::mt19937& random)
{
  for(; moves > 0; --moves) {
    const auto strands = static_cast<int>(braid.strands);
    const auto place = braid.word.begin() + static_cast<int>(random() % (braid.word.size() + 1));
    const int letter = static_cast<int>(1 + random() % (braid.strands - 1));
    if(random() % 3 == 0) {
      braid.word.insert(place, random() % 2 == 0 ? strands : -strands);
      ++braid.strands;
    } else if(random() % 2 == 0) {
      braid.word.insert(place, {letter, -letter});
    } else {
      std::rotate(braid.word.begin(), place, braid.word.end());
    }
  }
  return braid;
}

struct Named_braid
{
  std::string name;
  Braid braid;
};

// The prime knots of up to 10 crossings, in the order of Rolfsen's table.
inline std::vector<Named_braid> prime_knots(const std::string& file)
{
  std::ifstream in(file);
  if(!in) throw std::runtime_error("cannot read " + file);
  std::vector<Named_braid> knots;
  for(std::string line; std::getline(in, line);) {
    if(line.empty() || line.front() == '#') continue;
    std::istringstream words(line.substr(line.find(':') + 1));
    Braid_word word;
    for(int letter; words >> letter;) word.push_back(letter);
    knots.push_back({line.substr(0, line.find(':')), braid(std::move(word))});
  }
  return knots;
}

// The knot of a name of Link_identity that is prime: "5_2", or "5_2*" for the mirror image.
inline Braid prime_knot(const std::vector<Named_braid>& knots, const std::string& name)
{
  const bool is_mirror = name.back() == '*';
  for(const Named_braid& k : knots)
    if(k.name == name.substr(0, name.size() - (is_mirror ? 1 : 0)))
      return is_mirror ? mirrored(k.braid) : k.braid;
  throw std::invalid_argument("there is no knot " + name);
}

} // namespace knot_test

#endif // VFC_TEST_BRAID_DIAGRAMS_H
