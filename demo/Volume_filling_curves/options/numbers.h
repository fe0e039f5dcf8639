// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_NUMBERS_H
#define VFC_NUMBERS_H

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cstddef>
#include <string>
#include <vector>

namespace vfc {

// Numbers to text and back, independent of the locale.

using CGAL::Volume_filling_curves::internal::counted;

// returns a number for humans, with 6 significant digits
std::string to_text(double number);

// returns the shortest text that restores the same number
std::string with_all_digits(double number);

// Each reads a number, finite or a nonnegative integer. Returns whether it is the whole text.
bool parse(const std::string& text, double& number);
bool parse(const std::string& text, unsigned long long& number);

// Returns the items of a list with commas, also the empty ones: a list that ends with a comma may
// have lost an item.
std::vector<std::string> items_of_list(const std::string& list);

// Returns the place of the n-th comma, or npos.
std::size_t find_comma(const std::string& text, int n);

} // namespace vfc

#endif // VFC_NUMBERS_H
