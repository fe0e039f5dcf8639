// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_IDENTIFY_CURVES_H
#define VFC_IDENTIFY_CURVES_H

#include "files/curve_files.h"

#include <CGAL/Volume_filling_curves/identify.h>

#include <limits>
#include <string>
#include <vector>

namespace vfc {

class Session;

struct Identify_options
{
  std::vector<std::string> files = std::vector<std::string>(1); // a batch sets the first anew
  std::vector<std::string> codes;
  // a stride of 0 is the default, which depends on the chain
  CGAL::Volume_filling_curves::Chain_parameters chain;
  std::string fingerprint;
  double time_limit = std::numeric_limits<double>::infinity();
  Curve_reading reading;
  std::string folder; // of a batch
};

// Each function identifies the curves of a file, reports what it finds, and returns the lines with
// the names. \throws Input_error, Usage_error or No_result

// Closed curves.
std::string identify_link(Session& session,
                          const Curve& curve,
                          const std::string& file,
                          const Identify_options& options);

// Open chains.
std::string identify_chains(Session& session,
                            const Curve& curve,
                            const std::string& file,
                            const Identify_options& options);

// Checks the extension of the file of a fingerprint. \throws Usage_error
void check_fingerprint(const std::string& file);

} // namespace vfc

#endif // VFC_IDENTIFY_CURVES_H
