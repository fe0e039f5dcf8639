// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// The curve of an arc that fills a sector, and of its images.

#ifndef VFC_IMAGES_H
#define VFC_IMAGES_H

#include "files/curve_files.h"
#include "files/mesh_files.h"
#include "options/ports.h"
#include "reports/fill_report.h"
#include "symmetry/Symmetry.h"
#include "symmetry/sector.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>

#include <functional>
#include <string>

namespace vfc {

using Progress_function =
    std::function<bool(const CGAL::Volume_filling_curves::Run_progress& progress)>;

// Joins an arc that fills the sector with its images.
// \throws Input_error if that curve leaves the domain, in which the file's mesh is
Curve closed_up(const Curve& arc,
                const Ports& ports,
                const Symmetry& symmetry,
                const Domain& domain,
                const std::string& file);

// Measures the curve of all images, for a result of the arc in its sector, and compares it with the
// limits of its shape and of the unfilled volume. Empty regions are not searched again. Once
// `progress` returns false, all that is not measured yet stays unknown, and a curve that seemed to
// fill the domain has reached a limit.
void measure_again(Filling_result& result,
                   const Curve& curve,
                   const Domain& domain,
                   const Filling_parameters& parameters,
                   const Progress_function& progress);

} // namespace vfc

#endif // VFC_IMAGES_H
