// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_STAGE_TIMER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_STAGE_TIMER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Real_timer.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Timer that adds its lifetime to the seconds of a stage.
class Stage_timer
{
public:
  explicit Stage_timer(double& seconds) : m_seconds(seconds) { m_timer.start(); }
  ~Stage_timer() { m_seconds += m_timer.time(); }

  Stage_timer(const Stage_timer&) = delete;
  Stage_timer& operator=(const Stage_timer&) = delete;

private:
  double& m_seconds;
  Real_timer m_timer;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SUPPORT_STAGE_TIMER_H
