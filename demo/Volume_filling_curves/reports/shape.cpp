// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/shape.h"

#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/medial_radii.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace vfc {
namespace curves = CGAL::Volume_filling_curves;

Report::Json coordinates(const Curve::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

namespace {

// The value of a measuring function, null if it is interrupted.
template <typename Measure>
Report::Json unless_interrupted(const Measure& measure)
{
  try {
    return measure();
  } catch(const curves::Run_interrupted&) {
    return nullptr;
  }
}

void report_quick_measures(Report& report, const Curve& curve)
{
  report["components"] = curve.number_of_components();
  report["nodes_end"] = curve.number_of_nodes();
  report["length_end"] = curves::length(curve);
  report["component_lengths"] = curves::component_lengths(curve);
  const std::vector<double> curvatures = curves::total_curvatures(curve);
  report["total_curvature"] = std::accumulate(curvatures.begin(), curvatures.end(), 0.);
  report["component_total_curvatures"] = curvatures;
  report["max_curvature"] = curves::max_curvature(curve);
  const curves::Tightest_bend tightest = curves::tightest_bend(curve);
  report["min_bend_radius"] = tightest.radius;
  if(tightest.node < curve.number_of_nodes())
    report["min_bend_point"] = coordinates(curve.point(tightest.node));
}

} // namespace

void report_strands(Report& report, double distance, const std::array<Curve::Point_3, 2>& points)
{
  report["min_strand_distance"] = distance;
  if(std::isfinite(distance))
    report["min_strand_points"] = {coordinates(points[0]), coordinates(points[1])};
}

void report_wall(Report& report, double distance, const Curve::Point_3& point)
{
  report["min_wall_distance"] = distance;
  if(std::isfinite(distance)) report["min_wall_point"] = coordinates(point);
}

namespace {

// Fillings report what their run has measured.
template <typename NamedParameters>
void measure_strands(Report& report,
                     const Curve& curve,
                     double thickness,
                     const NamedParameters& np)
{
  try {
    const auto strands = curves::min_strand_distance(curve, thickness, np);
    report_strands(report, strands.distance, strands.points);
    report["crowded_fraction"] =
        curves::crowded_fraction<CGAL::Parallel_if_available_tag>(curve, thickness, np);
  } catch(const curves::Run_interrupted&) {
  }
}

} // namespace

// The last one takes most of the time.
void report_shape(Report& report,
                  const Curve& curve,
                  double thickness,
                  const std::function<bool(const curves::Run_progress&)>& progress)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const auto np = curves::parameters::progress(progress);
  report_quick_measures(report, curve);
  report["min_clearance"] =
      unless_interrupted([&] { return curves::min_clearance(curve, thickness, np); });
  report["polygonal_thickness"] =
      unless_interrupted([&] { return curves::polygonal_thickness(curve, np); });
  if(!report["polygonal_thickness"].is_null())
    report["ropelength"] = double(report["length_end"]) / double(report["polygonal_thickness"]);
  report["linking_matrix"] = unless_interrupted([&] { return curves::linking_matrix(curve, np); });
  if(thickness > 0) {
    report["thickness"] = thickness;
    if(report["min_strand_distance"].is_null()) measure_strands(report, curve, thickness, np);
    constexpr double cap = 2; // in units of the thickness: many spheres touch nothing at all
    constexpr std::size_t directions = 16;
    report["medial_radius"] = unless_interrupted(
        [&] { return curves::mean_medial_radius<Tag>(curve, cap * thickness, directions, np); });
  }
  report["average_crossing_number"] =
      unless_interrupted([&] { return curves::average_crossing_number<Tag>(curve, np); });
}

} // namespace vfc
