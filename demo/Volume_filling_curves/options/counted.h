// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_COUNTED_H
#define VFC_COUNTED_H

#include <CGAL/Volume_filling_curves/internal/text/counted.h>

namespace vfc {

using CGAL::Volume_filling_curves::internal::counted;

} // namespace vfc

#endif // VFC_COUNTED_H
