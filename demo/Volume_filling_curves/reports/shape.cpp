// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/shape.h"

#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/mean_medial_radius.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace vfc {
namespace curves = CGAL::Volume_filling_curves;

void report_shape(Report& report, const Curve& curve, double thickness)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const curves::Curve_measures measures = curves::measure<Tag>(curve, thickness);
  report["components"] = curve.number_of_components();
  report["nodes_end"] = curve.number_of_nodes();
  report["length_end"] = measures.length;
  report["min_clearance"] = measures.min_clearance;
  report["component_lengths"] = measures.component_lengths;
  report["total_curvature"] =
      std::accumulate(measures.total_curvatures.begin(), measures.total_curvatures.end(), 0.);
  report["component_total_curvatures"] = measures.total_curvatures;
  report["max_curvature"] = measures.max_curvature;
  report["min_bend_radius"] = measures.min_bend_radius;
  report["polygonal_thickness"] = measures.polygonal_thickness;
  report["ropelength"] = measures.ropelength;
  report["average_crossing_number"] = measures.average_crossing_number;
  report["linking_matrix"] = measures.linking_matrix;
  if(thickness > 0) {
    report["thickness"] = thickness;
    constexpr double cap = 2; // in units of the thickness: many spheres touch nothing at all
    report["medial_radius"] = curves::mean_medial_radius<Tag>(curve, cap * thickness);
  }
}

} // namespace vfc
