// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CERTIFICATES_H
#define VFC_CERTIFICATES_H

#include "files/curve_files.h"
#include "reports/Defect.h"

#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>

#include <string>
#include <vector>

namespace vfc {

class Session;

// Writes a certificate, as text if the name ends with .txt. \throws Usage_error
void write_certificate(const std::string& file,
                       const CGAL::Volume_filling_curves::Isotopy_certificate& certificate);

// A certificate and the curves that it is about.
struct Certificate_files
{
  std::string certificate, start, end;
  std::string domain;                 // a mesh that the curve must not have left, or empty
  std::vector<std::string> obstacles; // within that mesh
};

// Replays a certificate, reports the number of verified operations, and prints the verdict if it is
// valid. Returns the reason why it does not prove that the curves are isotopic and stayed inside,
// or nothing if it does. \throws Input_error
Defects defects_of_certificate(Session& session,
                               const Certificate_files& files,
                               const Curve_reading& reading);

} // namespace vfc

#endif // VFC_CERTIFICATES_H
