// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/coverage_report.h"

#include "files/polygon_files.h"
#include "reports/Report.h"

#include <CGAL/tags.h>

#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

Report::Json to_json(const curves::Coverage& coverage)
{
  return {{"samples", coverage.samples},
          {"mean", coverage.mean},
          {"p50", coverage.p50},
          {"p95", coverage.p95},
          {"p99", coverage.p99},
          {"max", coverage.max},
          {"fraction_within_r", coverage.fraction_within_r}};
}

} // namespace

void report_coverage(Report& report, const curves::Coverage& coverage)
{
  report["coverage"] = to_json(coverage);
}

void report_empty_regions(Report& report,
                          const std::vector<curves::Empty_region_3<Curve::Point_3>>& empty_regions)
{
  Report::Json& regions = report["empty_regions"] = Report::Json::array();
  for(const auto& region : empty_regions)
    regions.push_back({{"point", {region.point.x(), region.point.y(), region.point.z()}},
                       {"radius", region.radius},
                       {"volume", region.volume}});
}

template <typename Domain>
void measure_coverage(Report& report,
                      const Curve& curve,
                      const Domain& domain,
                      const Thickness& thickness,
                      std::size_t seed)
{
  using Samples = curves::Domain_samples_3<Curve::Traits, Domain>;
  const Samples samples(domain, Samples::default_number, seed);
  const std::vector<double> distances =
      curves::sample_distances<CGAL::Parallel_if_available_tag>(curve, samples);
  report_coverage(
      report, curves::coverage(samples, distances, thickness ? thickness : constant_thickness(1)));
  if(!thickness) {
    report["coverage"]["fraction_within_r"] = nullptr;
    return;
  }
  report["uncovered_fraction"] = report["unfilled_fraction"] =
      curves::unfilled_fraction(samples, distances, thickness);
  report_empty_regions(report, curves::empty_regions(curve, samples, distances, thickness));
}

template void measure_coverage(Report&, const Curve&, const Domain&, const Thickness&, std::size_t);
template void measure_coverage(
    Report&, const Curve&, const Planar_domain&, const Thickness&, std::size_t);

} // namespace vfc
