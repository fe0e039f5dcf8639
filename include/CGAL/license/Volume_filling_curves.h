// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_LICENSE_VOLUME_FILLING_CURVES_H
#define CGAL_LICENSE_VOLUME_FILLING_CURVES_H

// Every header of the package includes this one. The intervals that filter CGAL's predicates turn
// the rounding mode; WebAssembly has a single mode, with which signs would be wrong in silence.
#if defined(__wasm__) && !defined(CGAL_ALWAYS_ROUND_TO_NEAREST)
#error "WebAssembly cannot change the rounding mode: define CGAL_ALWAYS_ROUND_TO_NEAREST"
#endif

#include <CGAL/config.h>
#include <CGAL/license.h>

// As every CGAL package does, this one says on request under which terms it is used. There is no
// commercial license.

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning(
    "\nYou use the CGAL Volume_filling_curves package under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#error "You use the CGAL Volume_filling_curves package under the terms of the GPLv3+. \
You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_VOLUME_FILLING_CURVES_H
