// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_RESOURCES_H
#define VFC_RESOURCES_H

#include <cstddef>

namespace vfc {

// Resources used so far; negative or 0 if the system does not report them.
double cpu_seconds();
std::size_t peak_memory_bytes();

} // namespace vfc

#endif // VFC_RESOURCES_H
