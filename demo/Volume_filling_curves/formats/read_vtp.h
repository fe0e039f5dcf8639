// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_READ_VTP_H
#define VFC_READ_VTP_H

#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Vtp_reader.h>

#include <string_view>

namespace vfc {

// Reads a VTP file in any of VTK's encodings but for LZ4 and LZMA: the curve in it, or the points
// and the faces.
CGAL::Volume_filling_curves::internal::Curve_draft read_vtp_curve(std::string_view text);
CGAL::Volume_filling_curves::internal::Curve_draft read_vtp_surface(
    std::string_view text, CGAL::Volume_filling_curves::internal::Vtp_faces& faces);

} // namespace vfc

#endif // VFC_READ_VTP_H
