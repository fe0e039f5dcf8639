// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOT_KEY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOT_KEY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial_2.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Prime_field.h>

#include <cstdint>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Value of a polynomial of a knot at a point, modulo two primes: of P(v, z) J_2(t), J_c(t), or
// P(v, z), also of a link.
// These polynomials are multiplicative, and so is the key: the key of a connected sum is the
// product. A test shows that keys of different knots of up to 10 crossings, composite ones
// included, differ.
class Knot_key
{
public:
  using Number = Prime_field::Number;

  Knot_key() = default; // 1, the key of the unknot
  explicit Knot_key(std::uint64_t bits) : m_first(bits >> 32), m_second(bits & 0xffffffff) {}

  static Knot_key of(const Laurent_polynomial_2& homfly, const Laurent_polynomial& jones)
  {
    return of(jones) * of(homfly);
  }

  static Knot_key of(const Laurent_polynomial_2& homfly)
  {
    return Knot_key([&](const Prime_field& field) { return value(homfly, field); });
  }

  static Knot_key of(const Laurent_polynomial& jones)
  {
    return Knot_key([&](const Prime_field& field) { return value(jones, field); });
  }

  std::uint64_t bits() const { return m_first << 32 | m_second; }

  friend Knot_key operator*(const Knot_key& k, const Knot_key& l)
  {
    return Knot_key(first_field().product(k.m_first, l.m_first),
                    second_field().product(k.m_second, l.m_second));
  }

  // \pre neither number is 0
  Knot_key inverse() const
  {
    return Knot_key(first_field().inverse(m_first), second_field().inverse(m_second));
  }

  friend bool operator==(const Knot_key& k, const Knot_key& l) { return k.bits() == l.bits(); }
  friend bool operator!=(const Knot_key& k, const Knot_key& l) { return k.bits() != l.bits(); }
  friend bool operator<(const Knot_key& k, const Knot_key& l) { return k.bits() < l.bits(); }

private:
  static constexpr Number v = 271828183, z = 314159265,
                          t = 141421356; // there is no known relation between them

  Knot_key(Number first, Number second) : m_first(first), m_second(second) {}

  template <typename Value>
  explicit Knot_key(const Value& value)
      : m_first(value(first_field())), m_second(value(second_field()))
  {}

  static const Prime_field& first_field()
  {
    static const Prime_field field;
    return field;
  }
  static const Prime_field& second_field()
  {
    static const Prime_field field = first_field().next();
    return field;
  }

  static Number power(Number x, int exponent, const Prime_field& field)
  {
    if(exponent < 0) return power(field.inverse(x), -exponent, field);
    return field.power(x, static_cast<Number>(exponent));
  }

  static Number value(const Laurent_polynomial& p, const Prime_field& field)
  {
    Number sum = 0;
    for(int e = p.end(); e-- > p.low();)
      sum = field.sum(field.product(sum, t), field.residue(p[e]));
    return field.product(sum, power(t, p.low(), field));
  }

  static Number value(const Laurent_polynomial_2& p, const Prime_field& field)
  {
    Number sum = 0;
    for(const auto& term : p.terms()) {
      const Number powers =
          field.product(power(v, term.exponents[0], field), power(z, term.exponents[1], field));
      sum = field.sum(sum, field.product(field.residue(term.coefficient), powers));
    }
    return sum;
  }

  Number m_first = 1, m_second = 1;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_KNOT_KEY_H
