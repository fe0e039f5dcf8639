// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_JONES_POLYNOMIAL_H
#define VFC_TEST_JONES_POLYNOMIAL_H

#include "support/knot_diagram.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

// The Jones polynomial of a diagram, for tests; it tells most knots from their mirror images. The
// Kauffman bracket is summed over states crossing by crossing, states being kept apart only by how
// they join the pieces that are still open. The time grows exponentially with the number of open
// pieces, not of crossings: diagrams of 100 crossings are no trouble if they are narrow.
namespace knot_test {

using Laurent = std::map<int, std::int64_t>; // coefficients by exponent

inline void add_multiple(Laurent& sum, const Laurent& p, int shift, std::int64_t factor)
{
  for(const auto& [exponent, coefficient] : p) {
    std::int64_t& entry = sum[exponent + shift];
    entry += factor * coefficient;
    if(entry == 0) sum.erase(exponent + shift);
  }
}

// returns p times the bracket of `loops` circles
inline Laurent with_loops(Laurent p, std::size_t loops)
{
  for(; loops > 0; --loops) {
    Laurent product;
    add_multiple(product, p, 2, -1);
    add_multiple(product, p, -2, -1);
    p = std::move(product);
  }
  return p;
}

class Kauffman_bracket
{
public:
  explicit Kauffman_bracket(const Diagram& diagram) : m_diagram(diagram) {}

  // returns the bracket in A, 1 for the unknot
  Laurent operator()()
  {
    m_states = {{State(), Laurent{{0, 1}}}};
    m_is_done.assign(m_diagram.crossings.size(), false);
    for(std::size_t k = 0; k < m_diagram.crossings.size(); ++k)
      resolve(next_crossing(), k + 1 == m_diagram.crossings.size());
    const std::size_t circles = m_diagram.number_of_components_without_crossings();
    const bool has_crossings = !m_diagram.crossings.empty();
    return with_loops(m_states.begin()->second, has_crossings ? circles : circles - 1);
  }

private:
  static constexpr std::size_t max_open_pieces = 22;

  using State = std::map<std::size_t, std::size_t>; // per open piece the other end of its strand

  // returns the pieces counterclockwise from the incoming lower one
  static std::array<std::size_t, 4> pieces(const Crossing& x)
  {
    if(x.sign > 0) return {x.under_in, x.over_out, x.under_out, x.over_in};
    return {x.under_in, x.over_in, x.under_out, x.over_out};
  }

  // returns the crossing with the most open pieces
  std::size_t next_crossing()
  {
    const State& open = m_states.begin()->first;
    std::size_t best = 0, best_count = 0;
    for(std::size_t i = 0; i < m_is_done.size(); ++i) {
      if(m_is_done[i]) continue;
      std::size_t count = 1;
      for(std::size_t piece : pieces(m_diagram.crossings[i])) count += open.count(piece);
      if(count > best_count) std::tie(best, best_count) = std::make_pair(i, count);
    }
    m_is_done[best] = true;
    return best;
  }

  void resolve(std::size_t crossing, bool is_last)
  {
    // not a structured binding, which a lambda cannot capture in C++17
    const std::array<std::size_t, 4> around = pieces(m_diagram.crossings[crossing]);
    const std::size_t a = around[0], b = around[1], c = around[2], d = around[3];
    std::map<State, Laurent> states;
    const auto smooth = [&](const std::pair<const State, Laurent>& old, std::size_t to_a,
                            std::size_t x, std::size_t y, int shift) {
      State state = old.first;
      std::size_t loops = connect(state, a, to_a) + connect(state, x, y);
      if(is_last) --loops; // the bracket of the unknot is 1
      add_multiple(states[state], with_loops(old.second, loops), shift, 1);
    };
    for(const auto& old : m_states) {
      smooth(old, b, c, d, 1);
      smooth(old, d, b, c, -1);
    }
    m_states = std::move(states);
    if(m_states.begin()->first.size() > max_open_pieces)
      throw std::length_error("knot_test: the diagram is too wide for the Jones polynomial");
  }

  // Joins the ends x and y; returns the number of circles that this closes.
  static std::size_t connect(State& state, std::size_t x, std::size_t y)
  {
    if(x == y) return 1;
    for(std::size_t* end : {&x, &y}) {
      const auto found = state.find(*end);
      if(found == state.end()) continue;
      const std::size_t other = found->second;
      state.erase(found);
      state.erase(other);
      if(other == (end == &x ? y : x)) return 1;
      *end = other;
    }
    state[x] = y;
    state[y] = x;
    return 0;
  }

  const Diagram& m_diagram;
  std::map<State, Laurent> m_states;
  std::vector<bool> m_is_done;
};

// returns the Jones polynomial by exponents of t^(1/2): t + t^3 - t^4 for the right-handed trefoil
// \throws std::length_error if the diagram is too wide
inline Laurent jones_polynomial(const Diagram& diagram)
{
  const int writhe = diagram.writhe();
  Laurent result;
  for(const auto& [exponent, coefficient] : Kauffman_bracket(diagram)())
    result[-(exponent - 3 * writhe) / 2] = writhe % 2 == 0 ? coefficient : -coefficient;
  return result;
}

} // namespace knot_test

#endif // VFC_TEST_JONES_POLYNOMIAL_H
