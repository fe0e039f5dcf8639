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

// returns the name that is closest to what was typed, by letters inserted, left out, replaced or
// swapped with the next one; empty if the closest one needs more than a third of its letters
// changed
std::string meant_name(const std::string& typed, const std::vector<std::string>& names);

} // namespace vfc

#endif // VFC_MEANT_NAME_H
