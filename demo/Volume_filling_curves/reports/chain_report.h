// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CHAIN_REPORT_H
#define VFC_CHAIN_REPORT_H

#include "reports/Report.h"

#include <CGAL/Volume_filling_curves/identify.h>

#include <cstddef>
#include <string>

namespace vfc {

// What was found out about an open chain, for the list `chains` of the report. Nodes are counted
// along the chain from 1.
Report::Json chain_report(const CGAL::Volume_filling_curves::Chain_identity& identity,
                          std::size_t nodes);

// The most frequent knot, for example "3_1* in 74 of 100 closures", from an entry of that list.
std::string chain_text(const Report::Json& chain);

// A line for each key.
std::string chain_details(const Report::Json& chain);

// A table of the fingerprint: first node, last node, knot and share of each section.
std::string fingerprint_csv(const CGAL::Volume_filling_curves::Chain_identity& identity);

} // namespace vfc

#endif // VFC_CHAIN_REPORT_H
