// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_IDLE_STEPS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_IDLE_STEPS_H

#include <CGAL/license/Volume_filling_curves.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Counter of successive steps in which nothing moved. A few of them do no harm: each step frees
// strands that block one another, and the next may move.
class Idle_steps
{
public:
  void note(bool did_move) { m_count = did_move ? 0 : m_count + 1; }

  // returns whether the flow is stuck
  bool are_too_many() const { return m_count >= most; }

private:
  static constexpr int most = 5;

  int m_count = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_IDLE_STEPS_H
