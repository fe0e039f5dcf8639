// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/thickness.h"

#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

// Refuses a length that is larger than what is to have it.
void check_size(const std::string& option,
                double length,
                const std::string& whole,
                const CGAL::Bbox_3& box)
{
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  if(length > size)
    throw Usage_error(option + ' ' + to_text(length) + " is larger than the " + whole +
                      ", whose box has a diagonal of " + to_text(size));
}

constexpr double max_nodes = 2e7; // some 20 GB

} // namespace

void check_thickness(double thickness, const Curve& curve)
{
  check_size("--thickness", thickness, "curve", curve.bbox());
}

void check_number_of_nodes(double thickness,
                           const std::string& options,
                           double spacing,
                           const Curve& curve)
{
  const double length = curves::length(curve);
  if(!(length / max_nodes > spacing * thickness)) return;
  throw Usage_error((options.empty() ? "" : options + " and ") + "--spacing " + to_text(spacing) +
                    (options.empty() ? " is" : " are") + " too small for a curve of length " +
                    to_text(length) + " and thickness " + to_text(thickness) +
                    ": there would be more than " + to_text(max_nodes) + " nodes");
}

void check_filling(const curves::Filling_parameters<>& parameters, const Mesh& mesh)
{
  namespace pmp = CGAL::Polygon_mesh_processing;
  const double thickness = parameters.thickness, length = parameters.length,
               spacing = parameters.spacing;
  const double volume = std::abs(pmp::volume(mesh));
  const CGAL::Bbox_3 box = pmp::bbox(mesh);
  check_size("--thickness", thickness, "mesh", box);
  check_size("--bend-radius", parameters.bend_radius, "mesh", box);
  check_size("--strand-distance", parameters.strand_distance, "mesh", box);
  const bool is_round = false; // a filling has the most nodes before its bends are rounded
  const double r = length > 0
                       ? curves::thickness_of_filling(volume, length, is_round)
                       : (std::max)(thickness, curves::internal::min_thickness_for(parameters));
  if((length > 0 || thickness > 0) &&
     curves::length_of_filling(volume, r, is_round) / (r * spacing) > max_nodes)
    throw Usage_error(
        (length > 0 ? "--length " + to_text(length) : options_of_thickness(parameters)) +
        " and --spacing " + to_text(spacing) + ": there would be more than " + to_text(max_nodes) +
        " nodes in a volume of " + to_text(volume));
}

} // namespace vfc
