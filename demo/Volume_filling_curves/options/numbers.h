// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_NUMBERS_H
#define VFC_NUMBERS_H

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <string>

namespace vfc {

// Numbers to text and back, independent of the locale.

using CGAL::Volume_filling_curves::internal::counted;

// returns a number for humans, with 6 significant digits
std::string to_text(double number);

// returns the shortest text that restores the same number
std::string to_exact_text(double number);

// Read a finite number, and a nonnegative integer. Return whether the whole text is one; if it is
// not, the number may have changed.
bool parse(const std::string& text, double& number);
bool parse(const std::string& text, unsigned long long& number);

} // namespace vfc

#endif // VFC_NUMBERS_H
