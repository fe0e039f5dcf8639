// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_RUN_CHECKPOINT_H
#define CGAL_VOLUME_FILLING_CURVES_RUN_CHECKPOINT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>

#include <functional>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief The class `Run_checkpoint` is a moment between two iterations of `untangle()` or `fill()`,
 * in which the state of the run can be taken.
 *
 * The function `Curve_run_parameters::checkpoint` is given one before each iteration. Taking the
 * state changes nothing of the run.
 */
class Run_checkpoint
{
public:
  /// \cond SKIP_IN_MANUAL
  Run_checkpoint(std::function<Run_state()> take_state, bool is_last)
      : m_take_state(std::move(take_state)), m_is_last(is_last)
  {}
  /// \endcond

  /// returns the state of the run. Takes time linear in the size of the curve and of the
  /// certificate so far, if there is one.
  Run_state state() const { return m_take_state(); }

  /// returns whether the run ends here before its goal, at a limit or since the visitor wants it:
  /// then no other checkpoint follows.
  bool is_last() const { return m_is_last; }

private:
  std::function<Run_state()> m_take_state;
  bool m_is_last;
};

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_RUN_CHECKPOINT_H
