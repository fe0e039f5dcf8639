// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_MEANT_NAME_H
#define VFC_MEANT_NAME_H

#include <string>
#include <vector>

namespace vfc {

// Returns the name closest to a typed one, by letters inserted, left out, replaced or swapped with
// the next; empty if more than a third of its letters would change.
std::string meant_name(const std::string& typed, const std::vector<std::string>& names);

} // namespace vfc

#endif // VFC_MEANT_NAME_H
