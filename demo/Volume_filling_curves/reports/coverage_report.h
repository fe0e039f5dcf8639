// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COVERAGE_REPORT_H
#define VFC_COVERAGE_REPORT_H

#include "files/curve_files.h"
#include "files/mesh_files.h"

#include <CGAL/Volume_filling_curves/coverage.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace vfc {

class Report;

// The thickness r at a point.
using Thickness = std::function<double(const Curve::Point_3&)>;

inline Thickness constant_thickness(double r)
{
  return [r](const Curve::Point_3&) { return r; };
}

// Reports how evenly a curve fills a domain, in units of the thickness.
void report_coverage(Report& report, const CGAL::Volume_filling_curves::Coverage& coverage);

// Reports the regions that a curve did not reach.
void report_empty_regions(
    Report& report,
    const std::vector<CGAL::Volume_filling_curves::Empty_region_3<Curve::Point_3>>& empty_regions);

// Measures and reports both; without a thickness (null) only the distances, in the input's unit.
template <typename Domain>
void measure_coverage(Report& report,
                      const Curve& curve,
                      const Domain& domain,
                      const Thickness& thickness,
                      std::size_t seed);

} // namespace vfc

#endif // VFC_COVERAGE_REPORT_H
