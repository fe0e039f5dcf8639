// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/looks_unknotted.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Suspected unknot: a tight curve that may be an unknot is not yet done. The flow lingers on
// plateaus, where the gradient is as small and uniform as on tight knots. With the paper's
// preconditioner and a thickness of 0.0336, Ochiai's fourth unknot lingers at 91 crossings from
// iteration 233 on and is untied in iteration 1012. So the flow continues until the curve is untied
// or has lingered for too long.
class Suspected_unknot
{
public:
  // Whether a tight curve in the whole space is suspected to be an unknot.
  template <typename Flow>
  bool is_suspicious(const Flow& flow)
  {
    if(!looks_like_unknot(flow.curve())) return false;
    if(m_iteration == never) set_place(flow);
    return true;
  }

  // Takes how many iterations on a plateau are enough.
  template <typename Flow>
  bool has_lingered_for_long(const Flow& flow, std::size_t patience)
  {
    constexpr double noticeable = 0.99; // a fall of the length
    const std::size_t iterations = flow.statistics().iterations;
    if(m_iteration == never || iterations == 0) return false;
    if(flow.length() < noticeable * m_length) set_place(flow);
    return iterations - m_iteration >= patience;
  }

private:
  static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

  enum class Answer
  {
    UNKNOWN,
    NO,
    YES
  };

  template <typename Flow>
  void set_place(const Flow& flow)
  {
    m_iteration = flow.statistics().iterations;
    m_length = flow.length();
  }

  // result that a motion of the curve does not change
  template <typename Network>
  bool looks_like_unknot(const Network& curve)
  {
    if(curve.number_of_components() != 1 || !curve.is_closed(0) || has_pinned_node(curve))
      return false;
    if(m_answer == Answer::UNKNOWN) m_answer = looks_unknotted(curve) ? Answer::YES : Answer::NO;
    return m_answer == Answer::YES;
  }

  Answer m_answer = Answer::UNKNOWN; // whether the curve looks like an unknot
  std::size_t m_iteration = never;   // when the curve began to linger
  double m_length = 0;               // of the curve then
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_SUSPECTED_UNKNOT_H
