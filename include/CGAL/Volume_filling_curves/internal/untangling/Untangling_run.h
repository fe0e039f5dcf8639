// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Tails.h>

#include <CGAL/Real_timer.h>

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

  bool is_time_over() const { return timer.time() >= parameters.time_limit; }
};

template <typename Guard, typename Visitor>
Untangling_run(Guard&, Tails<Guard>&, const Untangling_parameters&, const Real_timer&, Visitor&)
    -> Untangling_run<Guard, Visitor>;

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_UNTANGLING_RUN_H
