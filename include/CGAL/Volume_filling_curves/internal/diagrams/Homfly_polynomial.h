// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_POLYNOMIAL_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_POLYNOMIAL_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/diagrams/Diagram_pieces.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Disk_sweep.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Homfly_skein.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Laurent_polynomial_2.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Polynomial_work.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The HOMFLY-PT polynomial P(v, z) of a link, in the variables of KnotInfo: 1/v P(+) - v P(-) =
// z P(0), P(unknot) = 1.
class Homfly_sweep
{
public:
  explicit Homfly_sweep(Polynomial_work& work) : m_work(work) {}

  Laurent_polynomial_2 operator()(const Planar_diagram& diagram)
  {
    const Diagram_pieces pieces = diagram_pieces(diagram);
    auto product = Laurent_polynomial_2::monomial({0, 0});
    for(const Planar_diagram& piece : pieces.diagrams) product = product * of_piece(piece);
    for(std::size_t i = 0; i < pieces.number_of_splits; ++i)
      product = product * Homfly_skein::loop();
    return product;
  }

private:
  Laurent_polynomial_2 of_piece(const Planar_diagram& diagram)
  {
    const Disk_sweep sweep(diagram);
    const Diagram_strands strands(diagram);
    Homfly_skein skein(m_work);
    int writhe = 0;
    for(const Sweep_step& step : sweep.steps()) {
      const int sign = strands.sign(step.crossing);
      skein.rotate(step.rotation);
      take_in(skein, step, sign);
      writhe += sign;
    }
    Laurent_polynomial_2 polynomial = skein.closed();
    polynomial.shift({writhe, 0});
    return polynomial;
  }

  // Adds a crossing to the disk: if only one strand is attached, a new one is added; the two
  // strands cross, and are joined with the remaining arcs from the disk to the crossing.
  static void take_in(Homfly_skein& skein, const Sweep_step& step, int sign)
  {
    const auto is_out = [sign](std::size_t k) { return k == 2 || k == (sign > 0 ? 1u : 3u); };
    std::size_t first = 0, end = step.last_end + step.attached - 1; // the one that crosses the next
    if(step.attached == 0) {
      skein.give_birth(0, is_out(0));
      first = 1;
      end = 0;
    }
    if(step.attached <= 1) skein.give_birth(first + 1, !is_out((end + 3) % 4));
    skein.cross(first, end % 2 == 1, sign);
    if(step.attached >= 3) skein.join(1);
    if(step.attached == 4) skein.join(0);
  }

  Polynomial_work& m_work;
};

// Returns nothing if the polynomial exceeds the limits.
// \throws Run_stopped in a Watched_scope
inline std::optional<Laurent_polynomial_2> homfly_polynomial(
    const Planar_diagram& diagram, Polynomial_work work = Polynomial_work())
{
  try {
    return Homfly_sweep(work)(diagram);
  } catch(const Polynomial_limit&) {
    return std::nullopt;
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DIAGRAMS_HOMFLY_POLYNOMIAL_H
