// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/knot_report.h"

#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Planar_diagram;

namespace {

// A number if every reader of JSON has it exactly, else its digits
Report::Json exact_number(const CGAL::Exact_integer& x)
{
  constexpr double max_exact = 9007199254740992.; // 2^53
  const double value = CGAL::to_double(x);
  if(-max_exact < value && value < max_exact) return static_cast<std::int64_t>(value);
  std::ostringstream digits;
  digits << x;
  return digits.str();
}

bool is_knot_or_link(const Curve& curve)
{
  if(curve.number_of_nodes() == 0 || curve.has_junction()) return false;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c)) return false;
  return true;
}

} // namespace

Planar_diagram diagram_of(Curve curve, const Progress_function& progress)
{
  curves::simplify_curves(curve, curves::parameters::progress(progress));
  return curves::knot_diagram(curve, curves::parameters::progress(progress));
}

void report_diagram(Report& report, const Planar_diagram& diagram)
{
  constexpr std::size_t max_crossings = 300; // of the polynomial; takes a second
  report["knottedness"] = report_name(to_string(curves::knottedness(diagram)));
  report["crossings"] = diagram.crossings.size();
  report["writhe"] = curves::writhe(diagram);
  report["determinant"] = exact_number(curves::determinant(diagram));
  report["signature"] = curves::signature(diagram);
  if(diagram.crossings.size() > max_crossings) return;
  Report::Json& polynomial = report["alexander_polynomial"] = Report::Json::array();
  for(const auto& coefficient : curves::alexander_polynomial(diagram))
    polynomial.push_back(exact_number(coefficient));
  if(polynomial.empty()) polynomial.push_back(0);
}

void report_knottedness(Report& report, const Curve& curve, const Progress_function& progress)
{
  if(!is_knot_or_link(curve)) return;
  try {
    const auto knottedness = curves::knottedness(diagram_of(curve, progress));
    report["knottedness"] = report_name(to_string(knottedness));
  } catch(const curves::Run_interrupted&) {
    report["knottedness"] = report_name(to_string(curves::Knottedness::UNKNOWN));
  }
}

} // namespace vfc
