// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_COMPUTED_KNOT_KEYS_H
#define VFC_TEST_COMPUTED_KNOT_KEYS_H

#include "support/braid_diagrams.h"

#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knot_key.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/colored_jones_polynomial.h>

#include <cstddef>

// Test support: keys of closed braids, from their polynomials.
namespace knot_test {

using CGAL::Volume_filling_curves::internal::Knot_key;

inline Knot_key computed_key(const Braid& braid)
{
  namespace internal = CGAL::Volume_filling_curves::internal;
  const Planar_diagram diagram = closure(braid);
  return Knot_key::of(internal::homfly_polynomial(diagram).value(),
                      internal::colored_jones_polynomial(diagram, 2).value());
}

// The key of the third color alone, which takes up to ten seconds.
inline Knot_key computed_third_key(const Braid& braid)
{
  namespace internal = CGAL::Volume_filling_curves::internal;
  constexpr std::size_t operations = 1'000'000'000;
  return Knot_key::of(
      internal::colored_jones_polynomial(closure(braid), 3, internal::Polynomial_work(operations))
          .value());
}

} // namespace knot_test

#endif // VFC_TEST_COMPUTED_KNOT_KEYS_H
