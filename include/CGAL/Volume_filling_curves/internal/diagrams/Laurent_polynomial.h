// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Coefficient.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Polynomial in a variable and its inverse, with integer coefficients. Dense, since the
// polynomials of knots have few gaps.
class Laurent_polynomial
{
public:
  Laurent_polynomial() = default;

  static Laurent_polynomial monomial(int exponent, Coefficient coefficient = 1)
  {
    Laurent_polynomial p;
    p.add(exponent, coefficient);
    return p;
  }

  bool is_zero() const { return m_coefficients.empty(); }

  // the exponents of nonzero coefficients are in [low(), end()), and low() and end() - 1 are some
  int low() const { return m_low; }
  int end() const { return m_low + static_cast<int>(m_coefficients.size()); }

  Coefficient operator[](int exponent) const
  {
    if(exponent < low() || exponent >= end()) return 0;
    return m_coefficients[static_cast<std::size_t>(exponent - m_low)];
  }

  // Adds coefficient * x^exponent.
  void add(int exponent, Coefficient coefficient)
  {
    if(coefficient == 0) return;
    reserve(exponent, exponent + 1);
    at(exponent) = checked(at(exponent) + checked(coefficient));
    trim();
  }

  // Adds factor * x^shift * p. \pre &p != this
  void add_multiple(const Laurent_polynomial& p, int shift, Coefficient factor = 1)
  {
    if(p.is_zero()) return;
    reserve(p.low() + shift, p.end() + shift);
    Coefficient* c = &at(p.low() + shift);
    for(const Coefficient d : p.m_coefficients) {
      *c = checked(*c + checked_product(d, factor));
      ++c;
    }
    trim();
  }

  friend Laurent_polynomial operator*(const Laurent_polynomial& p, const Laurent_polynomial& q)
  {
    Laurent_polynomial product;
    for(int e = p.low(); e < p.end(); ++e)
      if(p[e] != 0) product.add_multiple(q, e, p[e]);
    return product;
  }

  // The polynomial with x^(e * factor) for x^e. \pre factor != 0
  Laurent_polynomial with_exponents_times(int factor) const
  {
    Laurent_polynomial p;
    for(int e = low(); e < end(); ++e) p.add(e * factor, (*this)[e]);
    return p;
  }

  // The polynomial with x^(e / divisor) for x^e. \pre the divisor divides all exponents
  Laurent_polynomial with_exponents_over(int divisor) const
  {
    Laurent_polynomial p;
    for(int e = low(); e < end(); ++e) p.add(e / divisor, (*this)[e]);
    return p;
  }

  friend bool operator==(const Laurent_polynomial& p, const Laurent_polynomial& q)
  {
    return (p.is_zero() || p.m_low == q.m_low) && p.m_coefficients == q.m_coefficients;
  }
  friend bool operator!=(const Laurent_polynomial& p, const Laurent_polynomial& q)
  {
    return !(p == q);
  }

  // Writes the terms with rising exponents: "t + t^3 - t^4".
  void write(std::ostream& out, const char* variable) const
  {
    if(is_zero()) out << 0;
    for(int e = low(); e < end(); ++e) {
      if((*this)[e] == 0) continue;
      write_coefficient(out, (*this)[e], e == low(), e == 0);
      if(e != 0) write_power(out, variable, e);
    }
  }

private:
  Coefficient& at(int exponent)
  {
    return m_coefficients[static_cast<std::size_t>(exponent - m_low)];
  }

  void reserve(int low, int end)
  {
    if(is_zero()) m_low = low;
    const auto more = static_cast<std::size_t>((std::max)(0, m_low - low));
    m_coefficients.insert(m_coefficients.begin(), more, 0);
    m_low = (std::min)(m_low, low);
    if(end > this->end()) m_coefficients.resize(static_cast<std::size_t>(end - m_low), 0);
  }

  void trim()
  {
    while(!m_coefficients.empty() && m_coefficients.back() == 0) m_coefficients.pop_back();
    const auto is_nonzero = [](Coefficient c) { return c != 0; };
    const auto first = std::find_if(m_coefficients.begin(), m_coefficients.end(), is_nonzero);
    m_low += static_cast<int>(first - m_coefficients.begin());
    m_coefficients.erase(m_coefficients.begin(), first);
  }

  int m_low = 0;
  std::vector<Coefficient> m_coefficients; // the first and the last are not 0
};

// Returns p / q. \pre q divides p, and the last coefficient of q is 1 or -1
inline Laurent_polynomial quotient(Laurent_polynomial p, const Laurent_polynomial& q)
{
  Laurent_polynomial result;
  while(!p.is_zero()) {
    const int shift = p.end() - q.end();
    const Coefficient c = p[p.end() - 1] * q[q.end() - 1];
    result.add(shift, c);
    p.add_multiple(q, shift, -c);
  }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_H
