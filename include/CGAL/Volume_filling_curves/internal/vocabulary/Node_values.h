// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_VALUES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_VALUES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesIO
 *
 * \brief what is known about the nodes of a curve and shall be written with them: for each name a
 * value per node, in the order of the nodes.
 *
 * For example `Node_values values = {{"radius", medial_radii(curve, 2 * r)}};`. A name consists of
 * letters, digits and underscores, and does not start with a digit.
 */
using Node_values = std::map<std::string, std::vector<double>>;

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_NODE_VALUES_H
