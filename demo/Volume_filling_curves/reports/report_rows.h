// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_REPORT_ROWS_H
#define VFC_REPORT_ROWS_H

#include "reports/Report.h"

#include <string>

namespace vfc {

// Line with a key of the report and its value, - for what does not apply.
std::string row(const std::string& key, const Report::Json& value);

} // namespace vfc

#endif // VFC_REPORT_ROWS_H
