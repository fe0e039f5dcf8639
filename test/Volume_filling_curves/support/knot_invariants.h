// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_KNOT_INVARIANTS_H
#define VFC_TEST_KNOT_INVARIANTS_H

#include "support/knot_diagram.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <ostream>
#include <tuple>
#include <utility>
#include <vector>

// Invariants of knots and links from a diagram, for tests: Alexander polynomial (by its values),
// determinant, linking numbers, signature (its sign changes with the mirror image). All take
// polynomial time and do with hundreds of crossings.
namespace knot_test {

// Arithmetic modulo the prime 2^31 - 1.
constexpr std::uint64_t prime = 2147483647;

inline std::uint64_t residue(std::int64_t x)
{
  const std::int64_t p = static_cast<std::int64_t>(prime);
  return static_cast<std::uint64_t>(((x % p) + p) % p);
}

inline std::uint64_t power(std::uint64_t x, std::uint64_t exponent)
{
  std::uint64_t result = 1;
  for(; exponent > 0; exponent /= 2, x = x * x % prime)
    if(exponent % 2 == 1) result = result * x % prime;
  return result;
}

inline std::uint64_t inverse(std::uint64_t x)
{
  return power(x, prime - 2);
}

using Rows = std::vector<std::vector<std::uint64_t>>;

// Gaussian elimination.
inline std::uint64_t determinant_modulo(Rows a)
{
  std::uint64_t result = 1;
  const std::size_t n = a.size();
  for(std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while(pivot < n && a[pivot][k] == 0) ++pivot;
    if(pivot == n) return 0;
    if(pivot != k) {
      std::swap(a[pivot], a[k]);
      result = prime - result;
    }
    result = result * a[k][k] % prime;
    const std::uint64_t scale = inverse(a[k][k]);
    for(std::size_t i = k + 1; i < n; ++i) {
      if(a[i][k] == 0) continue;
      const std::uint64_t factor = prime - a[i][k] * scale % prime;
      for(std::size_t j = k; j < n; ++j) a[i][j] = (a[i][j] + factor * a[k][j]) % prime;
    }
  }
  return result % prime;
}

class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : m_parent(n)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while(m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  void join(std::size_t i, std::size_t j) { m_parent[find(i)] = find(j); }

private:
  std::vector<std::size_t> m_parent;
};

// The Alexander polynomial at t modulo the prime, up to a unit +-t^k that depends on the diagram
// only: a minor of the matrix of Fox derivatives of the Wirtinger relations. It vanishes for split
// links, of itself but where a component has no crossing and no column.
inline std::uint64_t alexander_minor(const Diagram& diagram, std::uint64_t t)
{
  if(diagram.number_of_components_without_crossings() > 0)
    return diagram.number_of_components == 1 ? 1 : 0;
  Disjoint_sets arcs(diagram.number_of_pieces);
  for(const Crossing& crossing : diagram.crossings) arcs.join(crossing.over_in, crossing.over_out);
  std::map<std::size_t, std::size_t> column;
  for(std::size_t i = 0; i < diagram.number_of_pieces; ++i)
    column.insert({arcs.find(i), column.size()});
  const std::size_t n = diagram.crossings.size(), m = column.size();
  if(n + 1 < m) return 0;
  Rows rows(n, std::vector<std::uint64_t>(m, 0));
  const auto add = [&](std::size_t row, std::size_t piece, std::uint64_t value) {
    std::uint64_t& entry = rows[row][column[arcs.find(piece)]];
    entry = (entry + value) % prime;
  };
  for(std::size_t i = 0; i < n; ++i) {
    const Crossing& x = diagram.crossings[i];
    // positive: out = over in over^-1; negative: over in and out exchanged
    add(i, x.over_in, 1 + prime - t);
    add(i, x.sign > 0 ? x.under_in : x.under_out, t);
    add(i, x.sign > 0 ? x.under_out : x.under_in, prime - 1);
  }
  rows.resize(m - 1);
  for(auto& row : rows) row.pop_back();
  return determinant_modulo(std::move(rows));
}

// A(t) A(1/t) modulo the prime, where no unit is left, for some fixed t.
using Alexander_values = std::array<std::uint64_t, 3>;
constexpr std::array<std::uint64_t, 3> alexander_arguments{1234567, 271828182, 1414213562};

inline Alexander_values alexander_values(const Diagram& diagram)
{
  Alexander_values values;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t t = alexander_arguments[i];
    values[i] = alexander_minor(diagram, t) * alexander_minor(diagram, inverse(t)) % prime;
  }
  return values;
}

// The same from the coefficients, lowest degree first.
inline Alexander_values alexander_values(const std::vector<std::int64_t>& coefficients)
{
  const auto value = [&](std::uint64_t t) {
    std::uint64_t sum = 0;
    for(auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
      sum = (sum * t + residue(*c)) % prime;
    return sum;
  };
  Alexander_values values;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t t = alexander_arguments[i];
    values[i] = value(t) * value(inverse(t)) % prime;
  }
  return values;
}

// returns |Alexander(-1)|. \pre it is below 2^30
inline std::uint64_t determinant(const Diagram& diagram)
{
  const std::uint64_t value = alexander_minor(diagram, prime - 1);
  return (std::min)(value, prime - value);
}

inline std::vector<std::vector<int>> linking_numbers(const Diagram& diagram)
{
  const std::size_t n = diagram.number_of_components;
  std::vector<std::vector<int>> matrix(n, std::vector<int>(n, 0));
  for(const Crossing& crossing : diagram.crossings)
    if(crossing.over_component != crossing.under_component)
      matrix[crossing.over_component][crossing.under_component] += crossing.sign;
  return matrix;
}

// A sparse symmetric matrix over the rationals. Its signature is found by exact elimination, a node
// of least degree first, so that the planar matrices of diagrams hardly fill in.
class Symmetric_matrix
{
public:
  explicit Symmetric_matrix(std::size_t n) : m_rows(n) {}

  void add(std::size_t i, std::size_t j, const CGAL::Exact_rational& value)
  {
    add_entry(i, j, value);
    if(i != j) add_entry(j, i, value);
  }

  int signature() &&
  {
    int result = 0;
    std::vector<bool> is_done(m_rows.size(), false);
    for(std::size_t step = 0; step < m_rows.size(); ++step) {
      const std::size_t i = choose_pivot(is_done);
      is_done[i] = true;
      if(m_rows[i].empty()) continue;
      result += m_rows[i].at(i) > 0 ? 1 : -1;
      eliminate(i);
    }
    return result;
  }

private:
  using Row = std::map<std::size_t, CGAL::Exact_rational>;

  void add_entry(std::size_t i, std::size_t j, const CGAL::Exact_rational& value)
  {
    CGAL::Exact_rational& entry = m_rows[i][j];
    entry += value;
    if(entry == 0) m_rows[i].erase(j);
  }

  // returns a row with a diagonal entry, or an empty row
  std::size_t choose_pivot(const std::vector<bool>& is_done)
  {
    std::size_t best = m_rows.size(), any = m_rows.size();
    for(std::size_t i = 0; i < m_rows.size(); ++i) {
      if(is_done[i]) continue;
      any = i;
      if(m_rows[i].empty()) return i;
      if(m_rows[i].count(i) == 0) continue;
      if(best == m_rows.size() || m_rows[i].size() < m_rows[best].size()) best = i;
    }
    if(best != m_rows.size()) return best;
    const std::size_t j = m_rows[any].begin()->first; // add row and column j, of diagonal 0, to any
    const Row row = m_rows[j];
    for(const auto& [k, value] : row)
      if(k != any) add(any, k, value);
    add_entry(any, any, 2 * row.at(any));
    return any;
  }

  void eliminate(std::size_t i)
  {
    const Row row = std::move(m_rows[i]);
    m_rows[i].clear();
    const CGAL::Exact_rational pivot = row.at(i);
    for(const auto& [j, value] : row) {
      if(j == i) continue;
      m_rows[j].erase(i);
      for(const auto& [k, other] : row)
        if(k != i) add_entry(j, k, -value * other / pivot);
    }
  }

  std::vector<Row> m_rows;
};

// The faces of a diagram, in two colors. A dart is a piece with a direction, 2 * piece if forward.
class Faces
{
public:
  explicit Faces(const Diagram& diagram)
      : m_next(2 * diagram.number_of_pieces), m_face(m_next.size(), unknown)
  {
    for(const Crossing& crossing : diagram.crossings) {
      const std::array<std::size_t, 4> out = darts(crossing);
      // with the face to the left, the way goes on to the next dart clockwise of where it came from
      for(std::size_t k = 0; k < 4; ++k) m_next[out[k] ^ 1u] = out[(k + 3) % 4];
    }
    for(std::size_t dart = 0; dart < m_next.size(); ++dart)
      if(m_face[dart] == unknown) walk(dart);
    color();
  }

  // returns the darts that leave a crossing, counterclockwise, the upper strand's direction first
  static std::array<std::size_t, 4> darts(const Crossing& x)
  {
    const std::size_t forward = 2 * x.under_out, back = 2 * x.under_in + 1;
    const bool is_positive = x.sign > 0;
    return {2 * x.over_out, is_positive ? forward : back, 2 * x.over_in + 1,
            is_positive ? back : forward};
  }

  std::size_t number() const { return m_number; }
  std::size_t left_of(std::size_t dart) const { return m_face[dart]; }
  bool is_black(std::size_t face) const { return m_color[face] == 1; }

  // returns the face of each diagram component that is left out of its matrix
  std::vector<bool> left_out(bool is_of_black) const
  {
    Disjoint_sets diagrams(m_number);
    for(std::size_t dart = 0; dart < m_face.size(); ++dart)
      diagrams.join(m_face[dart], m_face[dart ^ 1u]);
    std::vector<bool> result(m_number, false), is_done(m_number, false);
    for(std::size_t face = 0; face < m_number; ++face) {
      if(is_black(face) != is_of_black || is_done[diagrams.find(face)]) continue;
      result[face] = is_done[diagrams.find(face)] = true;
    }
    return result;
  }

private:
  static constexpr std::size_t unknown = static_cast<std::size_t>(-1);

  void walk(std::size_t start)
  {
    for(std::size_t dart = start; m_face[dart] == unknown; dart = m_next[dart])
      m_face[dart] = m_number;
    ++m_number;
  }

  // Faces on the two sides of a piece differ in color.
  void color()
  {
    std::vector<std::vector<std::size_t>> neighbors(m_number);
    for(std::size_t dart = 0; dart < m_face.size(); ++dart)
      neighbors[m_face[dart]].push_back(m_face[dart ^ 1u]);
    m_color.assign(m_number, 0);
    for(std::size_t face = 0; face < m_number; ++face) {
      if(m_color[face] != 0) continue;
      std::vector<std::size_t> stack(1, face);
      m_color[face] = 1;
      while(!stack.empty()) {
        const std::size_t top = stack.back();
        stack.pop_back();
        for(std::size_t neighbor : neighbors[top]) {
          if(m_color[neighbor] == m_color[top])
            throw std::logic_error("knot_test: the diagram is not planar");
          if(m_color[neighbor] != 0) continue;
          m_color[neighbor] = -m_color[top];
          stack.push_back(neighbor);
        }
      }
    }
  }

  std::vector<std::size_t> m_next, m_face; // per dart
  std::vector<int> m_color;                // per face
  std::size_t m_number = 0;
};

/* returns the signature, -2 for the right-handed trefoil: that of the Goeritz matrix of the faces
 * of one color, corrected by the crossings at which the surface in the other color does not follow
 * the orientation (Gordon and Litherland 1978). Both choices of `is_black` give the same.
 */
inline int signature(const Diagram& diagram, bool is_black = false)
{
  const Faces faces(diagram);
  const std::vector<bool> is_left_out = faces.left_out(is_black);
  Symmetric_matrix matrix(faces.number());
  int correction = 0;
  for(const Crossing& crossing : diagram.crossings) {
    // face k lies between dart k and the next one counterclockwise
    const std::array<std::size_t, 4> darts = Faces::darts(crossing);
    const bool first_is_ours = faces.is_black(faces.left_of(darts[0])) == is_black;
    const int type = first_is_ours ? 1 : -1;
    const std::size_t a = faces.left_of(darts[first_is_ours ? 0 : 1]);
    const std::size_t b = faces.left_of(darts[first_is_ours ? 2 : 3]);
    // of a positive crossing the first face lies between the two outgoing strands
    if(first_is_ours != (crossing.sign > 0)) correction += type;
    if(a == b) continue;
    if(!is_left_out[a]) matrix.add(a, a, type);
    if(!is_left_out[b]) matrix.add(b, b, type);
    if(!is_left_out[a] && !is_left_out[b]) matrix.add(a, b, -type);
  }
  return correction - std::move(matrix).signature();
}

// Invariants that two curves of the same type must share.
struct Invariants
{
  Alexander_values alexander;
  std::uint64_t determinant;
  int signature;
  std::vector<std::vector<int>> linking_numbers;

  bool operator==(const Invariants& other) const
  {
    return std::tie(alexander, determinant, signature, linking_numbers) ==
           std::tie(other.alexander, other.determinant, other.signature, other.linking_numbers);
  }
};

inline std::ostream& operator<<(std::ostream& out, const Invariants& invariants)
{
  out << "determinant " << invariants.determinant << ", signature " << invariants.signature
      << ", Alexander values";
  for(std::uint64_t value : invariants.alexander) out << ' ' << value;
  return out;
}

inline Invariants invariants_of(const std::vector<Loop>& loops)
{
  const Diagram diagram = diagram_of(loops);
  return {alexander_values(diagram), determinant(diagram), signature(diagram),
          linking_numbers(diagram)};
}

} // namespace knot_test

#endif // VFC_TEST_KNOT_INVARIANTS_H
