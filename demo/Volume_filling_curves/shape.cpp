// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "shape.h"

#include "Report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/Medial_spheres.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

// The mean over the curve and all directions. Many spheres touch nothing at all, hence the cap.
double mean_medial_radius(const Curve& curve, double thickness)
{
  constexpr std::size_t number_of_directions = 16;
  constexpr double cap = 2; // in units of the thickness
  const std::vector<double> thicknesses(curve.number_of_nodes(), thickness);
  const auto x = curves::internal::coordinates(curve);
  const auto weights = curves::internal::node_weights(curve, x);
  const curves::internal::Medial_spheres spheres(CGAL::Parallel_if_available_tag(), x,
                                                 curves::internal::node_circles(curve, x),
                                                 number_of_directions, thicknesses, cap);
  double sum = 0, sum_of_weights = 0;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto& circle = spheres.circles()[c];
    const double weight = weights[circle.node] * circle.share;
    for(std::size_t l = 0; l < number_of_directions; ++l) sum += weight * spheres.radius(c, l);
    sum_of_weights += weight * number_of_directions;
  }
  return sum / sum_of_weights;
}

} // namespace

void report_shape(Report& report, const Curve& curve, double thickness)
{
  const curves::Curve_measures measures = curves::measure(curve, thickness);
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
    report["medial_radius"] = mean_medial_radius(curve, thickness);
  }
}

} // namespace vfc
