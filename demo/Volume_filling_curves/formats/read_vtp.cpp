// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/read_vtp.h"

#include "formats/vtp_in_ascii.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_defect.h>

#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;
using Draft = curves::internal::Curve_draft;
using Reader = curves::internal::Vtp_reader;

template <typename Read>
Draft read(std::string_view text, const Read& read_ascii)
{
  try {
    const std::string ascii = vtp_in_ascii(std::string(text));
    return read_ascii(Reader(ascii));
  } catch(const Encoding_error& error) {
    Draft nothing;
    nothing.is_complete = false;
    nothing.defects.add({curves::Curve_defect_kind::BINARY_DATA, error.what(), error.line});
    return nothing;
  }
}

} // namespace

Draft read_vtp_curve(std::string_view text)
{
  return read(text, [](Reader reader) { return reader.run(); });
}

Draft read_vtp_surface(std::string_view text, curves::internal::Vtp_faces& faces)
{
  return read(text, [&](Reader reader) { return reader.read_surface(faces); });
}

} // namespace vfc
