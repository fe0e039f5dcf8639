// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CHINESE_REMAINDERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CHINESE_REMAINDERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reconstruction of integers from their residues modulo more and more primes (Garner 1959). The
// result is exact once the product of the primes exceeds twice any absolute value, hence a bound of
// these is needed.
class Chinese_remainders
{
public:
  // n integers of absolute value below 2^bits
  Chinese_remainders(std::size_t n, double bits) : m_values(n, Exact_integer(0)), m_bits(bits + 1)
  {}

  bool is_complete() const { return m_known_bits > m_bits; }

  // the prime for the next residues
  const Prime_field& field() const { return m_field; }

  void add(const std::vector<Prime_field::Number>& residues)
  {
    constexpr double bits_of_primes = 30.9; // all primes in use are above 2^30.9
    const Prime_field::Number scale = m_field.inverse(residue(m_product));
    for(std::size_t k = 0; k < m_values.size(); ++k) {
      const auto missing = m_field.difference(residues[k], residue(m_values[k]));
      m_values[k] += m_product * integer(m_field.product(missing, scale));
    }
    m_product *= integer(m_field.prime());
    m_known_bits += bits_of_primes;
    m_field = m_field.next();
  }

  // \pre is_complete()
  std::vector<Exact_integer> values() const
  {
    std::vector<Exact_integer> result = m_values;
    for(Exact_integer& x : result)
      if(2 * x > m_product) x -= m_product;
    return result;
  }

private:
  static Exact_integer integer(Prime_field::Number x)
  {
    return Exact_integer(static_cast<long>(x));
  }

  // \pre x is not negative
  Prime_field::Number residue(const Exact_integer& x) const
  {
    return static_cast<Prime_field::Number>(
        CGAL::to_double(Exact_integer(x % integer(m_field.prime()))));
  }

  std::vector<Exact_integer> m_values; // modulo the product
  Exact_integer m_product = Exact_integer(1);
  double m_bits, m_known_bits = 0;
  Prime_field m_field;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_CHINESE_REMAINDERS_H
