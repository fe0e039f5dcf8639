// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STALL_MONITOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STALL_MONITOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Idle_steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_STALL_MONITOR_H
