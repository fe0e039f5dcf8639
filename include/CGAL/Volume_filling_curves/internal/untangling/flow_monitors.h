// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_MONITORS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_MONITORS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Observations of a flow after each step that change its course: whether it has stalled, lingers on
// a plateau, or shrinks fast enough for coarse steps.

// Monitor of stalled flows: within a window of iterations the length hardly changed and the
// gradient hardly fell, or several steps in a row could not be certified, however short.
class Stall_monitor
{
public:
  // Returns whether the flow has stalled.
  bool operator()(double length, double gradient_norm, bool did_move)
  {
    m_idle_steps.note(did_move);
    m_window[m_count++ % m_window.size()] = {length, gradient_norm};
    return m_idle_steps.are_too_many() || is_flat();
  }

private:
  // A stalled flow runs on for a window. The shorter the window and the larger the tolerated
  // changes, the more slow motions count as stalls.
  static constexpr std::size_t window = 100;
  static constexpr double min_change_of_length = 1e-3;
  static constexpr double min_fall_of_gradient = 1e-2;

  struct Sample
  {
    double length, gradient_norm;
  };

  bool is_flat() const
  {
    if(m_count < m_window.size()) return false;
    const Sample& oldest = m_window[m_count % m_window.size()];
    double least = oldest.length, most = least, gradient = std::numeric_limits<double>::infinity();
    for(const Sample& sample : m_window) {
      least = (std::min)(least, sample.length);
      most = (std::max)(most, sample.length);
      if(&sample != &oldest) gradient = (std::min)(gradient, sample.gradient_norm);
    }
    return most - least < min_change_of_length * most &&
           gradient > (1 - min_fall_of_gradient) * oldest.gradient_norm;
  }

  std::array<Sample, window + 1> m_window = {}; // after the last steps, in turn
  std::size_t m_count = 0;                      // of the steps
  Idle_steps m_idle_steps;
};

// Monitor of plateaus, on which the gradient of an unknot is as small and uniform as that of a
// tight knot: with the paper's preconditioner and a thickness of 0.0336, Ochiai's fourth unknot
// lingers at 91 crossings from iteration 233 on and is untied in iteration 1012. The flow of a
// tight curve that may be an unknot therefore continues until it is untied or has lingered for too
// long.
class Plateau_monitor
{
public:
  // Returns whether a tight curve may be an unknot, which leaves its plateau later; the plateau
  // then starts here, unless it has before. \pre there is no domain
  template <typename Flow>
  bool enter_plateau(const Flow& flow)
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
  static constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

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
    if(m_answer == Answer::UNKNOWN)
      m_answer = looks_like_small_unknot(curve) ? Answer::YES : Answer::NO;
    return m_answer == Answer::YES;
  }

  Answer m_answer = Answer::UNKNOWN; // whether the curve may be an unknot
  std::size_t m_iteration = never;   // at the start of the plateau
  double m_length = 0;               // at that iteration
};

// Coarse phase of a flow, with longer edges and longer steps than required, while the curve shrinks
// fast. Nearly all of the work is done in this phase, and fewer nodes take less time; but tight
// strands with long edges oscillate, and a coarse flow hardly converges (8 knots of 24 with edges
// of at least 0.5 r all the time, 2026-11-23).
class Coarse_phase
{
public:
  // A curve that is nearly tight keeps its fine edges.
  void begin(double gradient_norm)
  {
    m_edges = gradient_norm > gradient_of_nearly_tight ? Edges::LONG : Edges::SHORT;
  }

  void end() { set(Edges::SHORT); }

  bool is_on() const { return m_edges == Edges::LONG; }

  // Takes the length after a step, and decides whether the next step is coarse.
  void note(double length)
  {
    m_lengths[m_count++ % m_lengths.size()] = length;
    if(m_count < m_lengths.size()) return;
    const double fall = 1 - length / m_lengths[m_count % m_lengths.size()];
    if(is_on() ? fall < slow : fall > fast) set(is_on() ? Edges::SHORT : Edges::LONG);
  }

private:
  static constexpr double gradient_of_nearly_tight = 0.1; // tangled curves have 0.2 to 0.5
  static constexpr std::size_t window = 10;
  // Relative decreases of the length in a window. They differ, since longer edges make a curve a
  // little shorter by themselves: 3 % for both take 10 % more node-iterations on the paper's
  // unknots (2026-11-23).
  static constexpr double slow = 0.02, fast = 0.05;

  enum class Edges
  {
    SHORT,
    LONG
  };

  void set(Edges edges)
  {
    m_edges = edges;
    m_count = 0;
  }

  std::array<double, window + 1> m_lengths = {}; // after the last steps, in turn
  std::size_t m_count = 0;                       // of the steps
  Edges m_edges = Edges::SHORT;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_MONITORS_H
