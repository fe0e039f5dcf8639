// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_KNOT_REPORT_H
#define VFC_KNOT_REPORT_H

#include "files/curve_files.h"
#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/identify.h>

#include <functional>
#include <string>

namespace vfc {

using Progress_function = std::function<bool(const CGAL::Volume_filling_curves::Run_progress&)>;

// Name, proofs, polynomials and invariants of the diagram; not the codes.
void report_identity(Report& report, const CGAL::Volume_filling_curves::Link_identity& identity);

// Name and proof in plain English, for example "3_1, right-handed (proved)".
std::string identity_text(const CGAL::Volume_filling_curves::Link_identity& identity);

// Keys "knotted" and "knottedness" of the result of a run, if the curves are closed.
void report_knottedness(Report& report, const Curve& curve, const Progress_function& progress);
void report_knottedness(Report& report, CGAL::Volume_filling_curves::Knottedness knottedness);

} // namespace vfc

#endif // VFC_KNOT_REPORT_H
