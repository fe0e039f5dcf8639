// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// A sector of a symmetric mesh, which an arc fills.

#ifndef VFC_SECTOR_H
#define VFC_SECTOR_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "options/ports.h"
#include "symmetry/Symmetry.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <string>

namespace vfc {

using Filling_parameters = CGAL::Volume_filling_curves::Filling_parameters<Curve::Point_3>;

struct Sector
{
  Mesh mesh;
  Ports ports;          // where an arc enters and leaves
  double wall_distance; // that it keeps from the boundary of the sector
};

// Cuts the inside of a mesh into sectors and returns one. The cuts keep 0.2 r from the planes, or
// 0.5 r for a strand distance of 1.6 r: together with the wall distance of the sector,
// this keeps strands at both sides that far apart. The ports are the deepest places of the cuts.
// \throws Input_error with the name of the file if the mesh is not symmetric up to r / 100, or no
// cut is wide enough for a port
Sector sector_of(const Mesh& mesh,
                 const Domain& domain,
                 const Symmetry& symmetry,
                 const Filling_parameters& parameters,
                 const std::string& file);

} // namespace vfc

#endif // VFC_SECTOR_H
