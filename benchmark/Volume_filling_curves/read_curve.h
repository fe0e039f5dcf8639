// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BENCHMARK_READ_CURVE_H
#define VFC_BENCHMARK_READ_CURVE_H

#include <CGAL/Volume_filling_curves/IO/curve_network.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace vfc_benchmark {

// Reads a curve whose ends, if it has any, are not to move.
inline CGAL::Volume_filling_curves::Curve_network_3<> read_curve(const std::string& file)
{
  CGAL::Volume_filling_curves::Curve_network_3<> curve;
  std::vector<CGAL::Volume_filling_curves::Curve_defect> defects;
  if(!CGAL::IO::read_curve_network(file, curve, defects))
    throw std::runtime_error(to_string(defects.front(), file));
  curve.pin_ends();
  return curve;
}

} // namespace vfc_benchmark

#endif // VFC_BENCHMARK_READ_CURVE_H
