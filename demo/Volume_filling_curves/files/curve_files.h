// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_FILES_H
#define VFC_CURVE_FILES_H

#include "session/errors.h"

#include <CGAL/Volume_filling_curves/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve_files/Curve_draft.h>

#include <string>

namespace vfc {

using Curve = CGAL::Volume_filling_curves::Curve_network_3<>;

class Output_files;
class Session;

// The content of a file. The curve is empty if one of the defects is an error.
struct Curve_and_defects
{
  Curve curve;
  Defects defects;
  bool is_valid = false;
};

// Options for reading a curve: whether it may have junctions, and whether its components are closed
// or open, overriding the file.
struct Curve_reading
{
  bool is_network = false, is_closed = false, is_open = false;
};

// Reads a file, which need not be a curve.
CGAL::Volume_filling_curves::internal::Curve_draft read_curve_draft(const std::string& file,
                                                                    const Curve_reading& reading);

Curve_and_defects read_curve_and_defects(const std::string& file, const Curve_reading& reading);

// Reads a curve, prints the warnings, and reports the start. \throws Input_error
Curve read_curve(Session& session, const std::string& file, const Curve_reading& reading);

// Plans to write a curve, if the name is not empty. \throws Usage_error
void add_curve_file(Output_files& outputs, const std::string& option, const std::string& file);

// Writes a curve and, if the format supports values and the thickness is not 0 (unknown), the
// medial radii, capped at twice the thickness. \throws Usage_error \pre the format of this file
// name can be written
void write_curve(const std::string& file, const Curve& curve, double thickness = 0);

// Writes the input numbers of a result's nodes, in the order of the result's file, unless the name
// of the map is empty. \throws Usage_error
void write_map(const std::string& map, const std::string& output, const Curve& curve);

} // namespace vfc

#endif // VFC_CURVE_FILES_H
