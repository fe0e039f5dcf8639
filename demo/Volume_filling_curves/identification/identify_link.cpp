// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "identification/Identification_watch.h"
#include "identification/identify_curves.h"
#include "reports/knot_report.h"
#include "session/Session.h"
#include "session/errors.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/identify.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;

namespace {

std::string diagram_code(const std::string& kind, const curves::Planar_diagram& diagram)
{
  if(kind == "pd") return curves::pd_code(diagram);
  return kind == "gauss" ? curves::gauss_code(diagram) : curves::dt_code(diagram);
}

// \throws Input_error unless all components are closed
void check_closed(const Curve& curve, const std::string& file)
{
  Defects defects;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c))
      defects.emplace_back("open component", file, std::vector<std::size_t>{}, c + 1,
                           "component " + std::to_string(c + 1) +
                               " is not a closed curve, while others are, or branches");
  if(!defects.empty()) throw Input_error(std::move(defects), "a knot or link, or open chains");
}

// \throws Input_error if a link is to have a code that only knots have
void check_codes(const Curve& curve, const std::string& file, const Identify_options& options)
{
  const auto& codes = options.codes;
  const bool needs_knot = std::find(codes.begin(), codes.end(), "dt") != codes.end();
  if(!needs_knot || curve.number_of_components() == 1) return;
  constexpr std::size_t second = 2; // component
  const Defect defect("several components", file, {}, second,
                      "only a knot has a Dowker-Thistlethwaite code");
  throw Input_error({defect}, "a knot");
}

} // namespace

std::string identify_link(Session& session,
                          const Curve& curve,
                          const std::string& file,
                          const Identify_options& options)
{
  if(!options.fingerprint.empty())
    throw Usage_error("--fingerprint: " + file + ": is not an open chain");
  check_closed(curve, file);
  check_codes(curve, file, options);
  Report& report = session.report();
  Identification_watch watch(session, file, options.time_limit);
  const curves::Link_identity identity = watch([&](const auto& progress) {
    report["linking_matrix"] =
        curves::linking_matrix(curve, curves::parameters::progress(progress));
    return curves::identify(curve, curves::parameters::progress(progress));
  });
  session.end_stage("identifying");
  report_identity(report, identity);
  for(const std::string& kind : options.codes)
    report["codes"][kind] = diagram_code(kind, identity.diagram);
  session.end_stage("measuring");
  return file + ": " + identity_text(identity) + '\n';
}

} // namespace vfc
