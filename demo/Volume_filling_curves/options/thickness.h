// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_THICKNESS_H
#define VFC_THICKNESS_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <string>

namespace vfc {

// Returns the options of `vfc untangle` or `vfc fill` that decide on the thickness, with the values
// that the user gave: "--thickness 0.1, --bend-radius 0.2". The largest thickness that one of them
// asks for counts.
template <typename Parameters>
std::string options_of_thickness(const Parameters& parameters)
{
  std::string text;
  const auto add = [&](const char* option, double value) {
    if(value > 0) text += (text.empty() ? "" : ", ") + std::string(option) + ' ' + to_text(value);
  };
  add("--thickness", parameters.thickness);
  add("--bend-radius", parameters.bend_radius);
  add("--strand-distance", parameters.strand_distance);
  return text;
}

// These refuse typing errors. \throws Usage_error that names the options

// Refuses a thickness larger than the curve; 0 stands for none.
void check_thickness(double thickness, const Curve& curve);

// Refuses a thickness that, with the spacing, requires more nodes than fit into memory. The options
// that it comes from are empty if it was measured.
void check_number_of_nodes(double thickness,
                           const std::string& options,
                           double spacing,
                           const Curve& curve);

// Refuses both for a curve that fills a mesh, with a thickness or a length, and limits of its shape
// larger than the mesh; 0 stands for none.
void check_filling(const CGAL::Volume_filling_curves::Filling_parameters<>& parameters,
                   const Mesh& mesh);

} // namespace vfc

#endif // VFC_THICKNESS_H
