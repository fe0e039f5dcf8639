// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_2_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_2_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Coefficient.h>

#include <array>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Polynomial in two variables and their inverses, with integer coefficients. Sparse: its terms
// are sorted by exponents, which makes sums and shifts linear.
class Laurent_polynomial_2
{
public:
  using Exponents = std::array<int, 2>;

  struct Term
  {
    Exponents exponents;
    Coefficient coefficient; // not 0

    friend bool operator==(const Term& s, const Term& t)
    {
      return s.exponents == t.exponents && s.coefficient == t.coefficient;
    }
  };

  Laurent_polynomial_2() = default;

  static Laurent_polynomial_2 monomial(Exponents exponents, Coefficient coefficient = 1)
  {
    Laurent_polynomial_2 p;
    if(coefficient != 0) p.m_terms.push_back({exponents, coefficient});
    return p;
  }

  bool is_zero() const { return m_terms.empty(); }
  const std::vector<Term>& terms() const { return m_terms; }

  // Adds factor * x^shift[0] * y^shift[1] * p. \pre factor != 0
  void add_multiple(const Laurent_polynomial_2& p, Exponents shift = {0, 0}, Coefficient factor = 1)
  {
    std::vector<Term> sum;
    sum.reserve(m_terms.size() + p.m_terms.size());
    auto old = m_terms.begin();
    for(const Term& t : p.m_terms) {
      const Exponents e{t.exponents[0] + shift[0], t.exponents[1] + shift[1]};
      Coefficient c = checked_product(t.coefficient, factor);
      while(old != m_terms.end() && old->exponents < e) sum.push_back(*old++);
      if(old != m_terms.end() && old->exponents == e) c = checked(c + old++->coefficient);
      if(c != 0) sum.push_back({e, c});
    }
    sum.insert(sum.end(), old, m_terms.end());
    m_terms = std::move(sum);
  }

  // Multiplies by a monomial with coefficient 1.
  void shift(Exponents by)
  {
    for(Term& t : m_terms) t.exponents = {t.exponents[0] + by[0], t.exponents[1] + by[1]};
  }

  friend Laurent_polynomial_2 operator*(const Laurent_polynomial_2& p,
                                        const Laurent_polynomial_2& q)
  {
    Laurent_polynomial_2 product;
    for(const Term& t : p.m_terms) product.add_multiple(q, t.exponents, t.coefficient);
    return product;
  }

  friend bool operator==(const Laurent_polynomial_2& p, const Laurent_polynomial_2& q)
  {
    return p.m_terms == q.m_terms;
  }
  friend bool operator!=(const Laurent_polynomial_2& p, const Laurent_polynomial_2& q)
  {
    return !(p == q);
  }

  // Writes the terms with rising exponents: "2 v^2 + v^2 z^2 - v^4".
  void write(std::ostream& out, const std::array<const char*, 2>& variables) const
  {
    if(is_zero()) out << 0;
    for(const Term& t : m_terms) {
      const auto [a, b] = t.exponents;
      write_coefficient(out, t.coefficient, &t == m_terms.data(), a == 0 && b == 0);
      if(a != 0) write_power(out, variables[0], a);
      if(a != 0 && b != 0) out << ' ';
      if(b != 0) write_power(out, variables[1], b);
    }
  }

private:
  std::vector<Term> m_terms; // sorted by exponents
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_LAURENT_POLYNOMIAL_2_H
