// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WATCHED_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WATCHED_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

using Progress_signature = Signature<Progress_parameters>;

using Measure_tags = Tag_list<internal_np::point_map_t, internal_np::closure_t>;
using Measure_polylines_signature = Signature<Progress_parameters, Measure_tags>;

using Chain_signature = Signature<Chain_parameters>;
using Chain_polyline_signature = Signature<Chain_parameters, Measure_tags>;

// Progress for functions without a status: calls f(watch), where the watch calls the named
// parameter `progress`, and returns the result. \throws Run_interrupted if `progress` returns false
template <typename NamedParameters, typename Function>
auto watched(Run_stage stage, const NamedParameters& np, const Function& f)
{
  Run_watch watch(Run_watch::never, get_parameters<Progress_signature>(np).progress);
  try {
    watch.begin(stage);
    watch.check();
    return f(&watch);
  } catch(const Run_stopped&) {
    if(!watch.is_interrupted()) throw; // the surrounding run is to stop
    throw Run_interrupted();
  }
}

// Progress for measures.
template <typename NamedParameters, typename Function>
auto measured(const NamedParameters& np, const Function& f)
{
  return watched(Run_stage::MEASURING, np, f);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_WATCHED_H
