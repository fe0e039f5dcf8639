// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_LISTS_H
#define VFC_LISTS_H

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

// Returns the items of a list with commas, also the empty ones: a list that ends with a comma may
// have lost an item.
std::vector<std::string> items_of_list(const std::string& list);

// Returns the place of the n-th comma, or npos.
std::size_t find_comma(const std::string& text, int n);

} // namespace vfc

#endif // VFC_LISTS_H
