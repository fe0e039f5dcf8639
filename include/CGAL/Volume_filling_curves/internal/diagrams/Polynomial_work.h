// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYNOMIAL_WORK_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYNOMIAL_WORK_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Coefficient.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The work that may be spent on a polynomial, in operations on terms. A run that is to stop ends
// it.
class Polynomial_work
{
public:
  static constexpr std::size_t about_a_second = 25'000'000;

  explicit Polynomial_work(std::size_t operations = about_a_second) : m_left(operations) {}

  Polynomial_work(const Polynomial_work&) = delete;
  Polynomial_work& operator=(const Polynomial_work&) = delete;

  // \throws Polynomial_limit if less is left
  // \throws Run_stopped in a Watched_scope
  void use(std::size_t operations)
  {
    if(operations > m_left) throw Polynomial_limit();
    m_left -= operations;
    check_run_sometimes(m_steps);
  }

private:
  std::size_t m_left;
  unsigned m_steps = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_POLYNOMIAL_WORK_H
