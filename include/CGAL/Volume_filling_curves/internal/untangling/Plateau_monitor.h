// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_PLATEAU_MONITOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_PLATEAU_MONITOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Alexander_matrix.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Monitor of plateaus, on which the gradient of an unknot is as small and uniform as that of a
// tight knot: with the paper's preconditioner and a thickness of 0.0336, Ochiai's fourth unknot
// lingers at 91 crossings from iteration 233 on and is untied in iteration 1012. The flow of a
// tight curve that may be an unknot therefore continues until it is untied or has lingered for too
// long.
class Plateau_monitor
{
public:
  // Returns whether a tight curve in the whole space may be an unknot, which leaves its plateau
  // later.
  template <typename Flow>
  bool may_leave_plateau(const Flow& flow)
  {
    if(!may_be_single_unknot(flow.curve())) return false;
    if(m_iteration == never) restart(flow);
    return true;
  }

  // Returns whether the curve has stayed on a plateau for `patience` iterations.
  template <typename Flow>
  bool has_lingered(const Flow& flow, std::size_t patience)
  {
    constexpr double noticeable = 0.99; // a fall of the length
    const std::size_t iterations = flow.statistics().iterations;
    if(m_iteration == never || iterations == 0) return false;
    if(flow.length() < noticeable * m_length) restart(flow);
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
  void restart(const Flow& flow)
  {
    m_iteration = flow.statistics().iterations;
    m_length = flow.length();
  }

  // A motion of the curve does not change the result.
  template <typename Network>
  bool may_be_single_unknot(const Network& curve)
  {
    if(curve.number_of_components() != 1 || !curve.is_closed(0) || has_constrained_node(curve))
      return false;
    if(m_answer == Answer::UNKNOWN) m_answer = may_be_unknot(curve) ? Answer::YES : Answer::NO;
    return m_answer == Answer::YES;
  }

  Answer m_answer = Answer::UNKNOWN; // whether the curve may be an unknot
  std::size_t m_iteration = never;   // at the start of the plateau
  double m_length = 0;               // at that iteration
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_PLATEAU_MONITOR_H
