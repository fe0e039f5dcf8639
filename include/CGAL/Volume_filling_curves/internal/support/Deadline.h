// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DEADLINE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DEADLINE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The end of the time that a run may take, for the parts of it that come before the first step and
// after the last one.
class Deadline
{
public:
  // The timer has been started and must outlive the deadline; the limit is in its seconds.
  Deadline(const Real_timer& timer, double limit) : m_timer(timer), m_limit(limit) {}

  bool has_passed() const { return !leaves(0); }

  // returns whether what takes that many seconds ends in time
  bool leaves(double seconds) const { return m_timer.time() + seconds < m_limit; }

private:
  const Real_timer& m_timer;
  double m_limit;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_DEADLINE_H
