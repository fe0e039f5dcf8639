// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_VERSION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_VERSION_H

#include <CGAL/license/Volume_filling_curves.h>

/// \file
/// \ingroup PkgVolumeFillingCurvesRef
/// The version of the package; a test compares it with the one in the build system.

/// the version as a string, for example "0.2.0"; `untangle.h` and `fill.h` define it
#define CGAL_VOLUME_FILLING_CURVES_VERSION "0.2.0"

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_VERSION_H
