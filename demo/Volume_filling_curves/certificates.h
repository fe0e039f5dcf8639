// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CERTIFICATES_H
#define VFC_CERTIFICATES_H

#include "Defect.h"

#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>

#include <string>

namespace vfc {

class Session;

// Writes a certificate, as text if the name ends with .txt. \throws Usage_error
void write_certificate(const std::string& file,
                       const CGAL::Volume_filling_curves::Isotopy_certificate& certificate);

// Replays a certificate and reports how many operations were verified. Returns why it does not prove
// that the curves of two files are the same, nothing if it does. \throws Input_error
Defects defects_of_certificate(Session& session,
                               const std::string& certificate,
                               const std::string& start,
                               const std::string& end,
                               bool is_network);

} // namespace vfc

#endif // VFC_CERTIFICATES_H
