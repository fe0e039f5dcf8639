// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_FIELD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_FIELD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Arithmetic modulo a prime below 2^31; products fit into 64 bits.
class Prime_field
{
public:
  using Number = std::uint64_t;

  explicit Prime_field(Number prime = largest) : m_prime(prime) {}

  // the next smaller prime field; there are 50 million of them
  Prime_field next() const
  {
    Number p = m_prime - 2;
    while(!is_prime(p)) p -= 2;
    return Prime_field(p);
  }

  Number prime() const { return m_prime; }

  Number residue(std::int64_t x) const
  {
    const auto p = static_cast<std::int64_t>(m_prime);
    return static_cast<Number>((x % p + p) % p);
  }

  Number sum(Number a, Number b) const { return a + b < m_prime ? a + b : a + b - m_prime; }
  Number negative(Number a) const { return a == 0 ? 0 : m_prime - a; }
  Number difference(Number a, Number b) const { return sum(a, negative(b)); }
  Number product(Number a, Number b) const { return a * b % m_prime; }

  // \pre a is not 0
  Number inverse(Number a) const { return power(a, m_prime - 2); }

  Number power(Number a, Number exponent) const
  {
    Number result = 1;
    for(; exponent > 0; exponent /= 2, a = product(a, a))
      if(exponent % 2 == 1) result = product(result, a);
    return result;
  }

private:
  static constexpr Number largest = 2147483647; // 2^31 - 1

  static bool is_prime(Number p)
  {
    for(Number d = 3; d * d <= p; d += 2)
      if(p % d == 0) return false;
    return true;
  }

  Number m_prime;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_PRIME_FIELD_H
