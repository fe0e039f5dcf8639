// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Tails.h>

#include <CGAL/Real_timer.h>

#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What all strategies of a run share; the public function makes it.
template <typename Guard, typename Visitor>
struct Untangling_run
{
  Guard& guard;
  Tails<Guard>& tails;
  const Untangling_parameters& parameters;
  const Real_timer& timer; // has been started
  Visitor& visitor;
  Run_saver& saver;
  std::string state_of_strategy = {}; // while a flow runs

  bool is_time_over() const { return timer.time() >= parameters.time_limit; }

  // Writes what every state of the run begins with.
  void write_state(State_writer& writer) const
  {
    writer(guard.curve(), guard, tails);
    writer.append(state_of_strategy);
  }
};

template <typename Guard, typename Visitor>
Untangling_run(
    Guard&, Tails<Guard>&, const Untangling_parameters&, const Real_timer&, Visitor&, Run_saver&)
    -> Untangling_run<Guard, Visitor>;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
