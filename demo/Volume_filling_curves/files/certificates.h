// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CERTIFICATES_H
#define VFC_CERTIFICATES_H

#include "reports/Defect.h"

#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>

#include <string>

namespace vfc {

class Session;

// Writes a certificate, as text if the name ends with .txt. \throws Usage_error
void write_certificate(const std::string& file,
                       const CGAL::Volume_filling_curves::Isotopy_certificate& certificate);

// A certificate and the curves that it is about.
struct Certificate_files
{
  std::string certificate, start, end;
  std::string domain; // a mesh that the curve must not have left, or empty
};

// Replays a certificate and reports how many operations were verified. Returns why it does not
// prove that the curves are the same, and that they stayed inside; nothing if it does. \throws
// Input_error
Defects defects_of_certificate(Session& session, const Certificate_files& files, bool is_network);

} // namespace vfc

#endif // VFC_CERTIFICATES_H
