// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_PATIENCE_H
#define VFC_PATIENCE_H

#include "session/interruption.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace vfc {

// Time limit for the measures of a report, as a function for the parameter `progress`: the time
// limit of the run, or a signal, but at least a moment, which suffices for small curves.
class Patience
{
public:
  // Takes the seconds that are left.
  explicit Patience(double seconds = std::numeric_limits<double>::infinity()) : m_seconds(seconds)
  {}

  bool operator()(const CGAL::Volume_filling_curves::Run_progress& progress) const
  {
    constexpr double moment = 0.1; // seconds
    const double passed = this->passed();
    return passed < moment || (passed < m_seconds && is_to_go_on(progress));
  }

  double seconds_left() const { return (std::max)(m_seconds - passed(), 0.); }

private:
  using Clock = std::chrono::steady_clock;

  double passed() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  double m_seconds;
  Clock::time_point m_start = Clock::now();
};

} // namespace vfc

#endif // VFC_PATIENCE_H
