// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_READ_CURVE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_READ_CURVE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/curve/check_embedded.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Reads the curve of a run that goes on, and runs a further check, which throws
// std::invalid_argument. Throws Run_state_error if the curve is not embedded or the check fails:
// all that follows is certified only for an embedded curve.
template <typename Network, typename Check>
void read_curve(State_reader& reader, Network& curve, const Check& check)
{
  reader(curve);
  try {
    check_embedded(curve);
    check();
  } catch(const std::invalid_argument& error) {
    throw Run_state_error(std::string("the curve of the state: ") + error.what());
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_READ_CURVE_H
