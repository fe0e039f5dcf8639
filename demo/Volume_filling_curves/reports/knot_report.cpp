// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "reports/knot_report.h"

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/identify.h>
#include <CGAL/Volume_filling_curves/simplify_curves.h>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <utility>

namespace vfc {

namespace curves = CGAL::Volume_filling_curves;
using curves::Knottedness;
using curves::Link_identity;
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

Planar_diagram diagram_of(Curve curve, const Progress_function& progress)
{
  curves::simplify_curves(curve, curves::parameters::progress(progress));
  return curves::knot_diagram(curve, curves::parameters::progress(progress));
}

bool is_nontrivial(Knottedness knottedness)
{
  return knottedness != Knottedness::UNKNOWN && knottedness != Knottedness::UNKNOTTED;
}

Report::Json text_or_null(const std::string& text)
{
  return text.empty() ? Report::Json() : Report::Json(text);
}

void report_invariants(Report& report, const Planar_diagram& diagram)
{
  constexpr std::size_t max_crossings = 300; // of the Alexander polynomial; takes a second
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

// The name, and whether the knot or its mirror image is meant
std::string name_text(const Link_identity& identity)
{
  const std::string& name = identity.name;
  if(identity.knottedness == Knottedness::UNKNOTTED)
    return identity.number_of_components == 1 ? name + ", unknotted" : name;
  if(name == "3_1") return name + ", right-handed";
  if(name == "3_1*") return name + ", left-handed";
  if(identity.chirality == curves::Knot_chirality::UNKNOWN) return name + ", of unknown chirality";
  return name + ", " + to_string(identity.chirality);
}

} // namespace

void report_identity(Report& report, const Link_identity& identity)
{
  report["name"] = text_or_null(identity.name);
  report["is_proved"] = identity.is_proved;
  if(!identity.name.empty()) report["chirality"] = to_string(identity.chirality);
  report_knottedness(report, identity.knottedness);
  report_invariants(report, identity.diagram);
  report["homfly_polynomial"] = text_or_null(identity.homfly_polynomial);
  report["jones_polynomial"] = text_or_null(identity.jones_polynomial);
}

std::string identity_text(const Link_identity& identity)
{
  const bool is_knotted = is_nontrivial(identity.knottedness);
  if(identity.is_proved) return name_text(identity) + " (proved)";
  if(!identity.name.empty())
    return "consistent with " + name_text(identity) + (is_knotted ? "; knotted (proved)" : "");
  const std::size_t n = identity.number_of_components;
  return (n == 1 ? "unnamed knot" : "link of " + counted(n, "component")) +
         (is_knotted ? ", nontrivial (proved)" : ", not known to be trivial or not");
}

void report_knottedness(Report& report, Knottedness knottedness)
{
  report["knotted"] = is_nontrivial(knottedness) ? "knotted" : to_string(knottedness);
  report["knottedness"] = report_name(to_string(knottedness));
}

void report_knottedness(Report& report, const Curve& curve, const Progress_function& progress)
{
  if(!is_knot_or_link(curve)) return;
  try {
    report_knottedness(report, curves::knottedness(diagram_of(curve, progress)));
  } catch(const curves::Run_interrupted&) {
    report_knottedness(report, Knottedness::UNKNOWN);
  }
}

} // namespace vfc
