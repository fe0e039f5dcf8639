// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "coverage_report.h"

#include "Report.h"

#include <CGAL/Volume_filling_curves/coverage.h>

#include <CGAL/tags.h>

#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using Samples = curves::Domain_samples_3<Curve::Traits, Domain>;

Report::Json to_json(const curves::Coverage& coverage, bool has_thickness)
{
  Report::Json json = {{"samples", coverage.samples}, {"mean", coverage.mean},
                       {"p50", coverage.p50},         {"p95", coverage.p95},
                       {"p99", coverage.p99},         {"max", coverage.max},
                       {"fraction_within_r", nullptr}};
  if(has_thickness) json["fraction_within_r"] = coverage.fraction_within_r;
  return json;
}

} // namespace

void report_coverage(Report& report,
                     const Curve& curve,
                     const Domain& domain,
                     const Thickness& thickness,
                     std::size_t seed)
{
  const bool has_thickness = thickness != nullptr;
  const Samples samples(domain, Samples::default_number, seed);
  const std::vector<double> distances =
      curves::sample_distances<CGAL::Parallel_if_available_tag>(curve, samples);
  report["coverage"] = to_json(
      curves::coverage(samples, distances, has_thickness ? thickness : constant_thickness(1)),
      has_thickness);
  if(!has_thickness) return;
  Report::Json& regions = report["empty_regions"] = Report::Json::array();
  for(const auto& region : curves::empty_regions(curve, samples, distances, thickness))
    regions.push_back({{"point", {region.point.x(), region.point.y(), region.point.z()}},
                       {"radius", region.radius},
                       {"volume", region.volume}});
}

} // namespace vfc
