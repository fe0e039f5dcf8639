// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_COMPUTED_LINK_KEYS_H
#define VFC_TEST_COMPUTED_LINK_KEYS_H

#include "support/braid_diagrams.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Gauss_code_reader.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_codes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Test support: keys of links with all orientations of their components.
namespace knot_test {

// The diagram after some of its components were reversed: their passes come in the opposite order,
// and crossings with other components change their sign. Bit i stands for component i.
inline Planar_diagram reversed(const Planar_diagram& diagram, std::size_t components)
{
  std::istringstream code(CGAL::Volume_filling_curves::internal::gauss_code(diagram));
  std::vector<std::vector<std::string>> passes(1); // of each component, such as "O12+"
  for(std::string word; code >> word;) {
    if(word == "/") {
      passes.emplace_back();
      continue;
    }
    for(std::size_t i = 0, end = 0; i < word.size(); i = end) {
      end = word.find_first_of("+-", i) + 1;
      passes.back().push_back(word.substr(i, end - i));
    }
  }
  const auto is_reversed = [&](std::size_t c) { return (components >> c & 1) != 0; };
  std::map<std::string, bool> changes_sign; // of each crossing
  for(std::size_t c = 0; c < passes.size(); ++c)
    for(const std::string& pass : passes[c])
      changes_sign[pass.substr(1, pass.size() - 2)] ^= is_reversed(c);
  std::string text;
  for(std::size_t c = 0; c < passes.size(); ++c) {
    if(is_reversed(c)) std::reverse(passes[c].begin(), passes[c].end());
    text += c > 0 ? " / " : "";
    for(std::string pass : passes[c]) {
      char& sign = pass.back();
      if(changes_sign[pass.substr(1, pass.size() - 2)]) sign = sign == '+' ? '-' : '+';
      text += pass;
    }
  }
  return CGAL::Volume_filling_curves::internal::Gauss_code_reader(text)();
}

// The keys of the HOMFLY-PT polynomials of a link without free loops, for all orientations.
inline std::set<std::uint64_t> computed_link_keys(const Planar_diagram& diagram)
{
  namespace internal = CGAL::Volume_filling_curves::internal;
  const std::size_t components = internal::number_of_components(diagram);
  std::set<std::uint64_t> keys;
  for(std::size_t turned = 0; turned < std::size_t(1) << (components - 1); ++turned) {
    const auto polynomial = internal::homfly_polynomial(reversed(diagram, turned));
    keys.insert(internal::Knot_key::of(polynomial.value()).bits());
  }
  return keys;
}

} // namespace knot_test

#endif // VFC_TEST_COMPUTED_LINK_KEYS_H
