// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/knots/looks_unknotted.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A tight curve that may well be an unknot has not got there: the flow lingers on plateaus, where
// the gradient is small and as uniform as on tight knots. With the paper's preconditioner Ochiai's
// fourth unknot, with a thickness of 0.0336, lingers at 91 crossings from iteration 233 on and is
// untied in iteration 1012. So the flow goes on until the curve is untied or it has lingered for
// too long.
class Suspected_unknot
{
public:
  // Whether a tight curve in the whole space is suspected to be an unknot.
  template <typename Flow>
  bool is_suspicious(const Flow& flow)
  {
    if(!looks_like_unknot(flow.curve())) return false;
    if(!m_lingering) m_lingering = {flow.statistics().iterations, flow.length()};
    return true;
  }

  // Takes how many iterations on a plateau are enough.
  template <typename Flow>
  bool has_lingered_for_long(const Flow& flow, std::size_t patience)
  {
    constexpr double noticeable = 0.99; // a fall of the length
    const std::size_t iterations = flow.statistics().iterations;
    if(!m_lingering || iterations == 0) return false;
    if(flow.length() < noticeable * m_lingering->length) m_lingering = {iterations, flow.length()};
    return iterations - m_lingering->iteration >= patience;
  }

  // Writes or reads everything, see State_writer.
  template <typename Archive>
  void serialize(Archive& archive)
  {
    archive(m_looks_unknotted, m_lingering);
  }

private:
  struct Place // on the way
  {
    std::size_t iteration;
    double length;

    template <typename Archive>
    void serialize(Archive& archive)
    {
      archive(iteration, length);
    }
  };

  // what stays when a curve moves
  template <typename Network>
  bool looks_like_unknot(const Network& curve)
  {
    if(curve.number_of_components() != 1 || !curve.is_closed(0) || has_pinned_node(curve))
      return false;
    if(!m_looks_unknotted) m_looks_unknotted = looks_unknotted(curve);
    return *m_looks_unknotted;
  }

  std::optional<bool> m_looks_unknotted;
  std::optional<Place> m_lingering;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H
