// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_NUMBERS_H
#define VFC_NUMBERS_H

#include <CGAL/Volume_filling_curves/internal/text/counted.h>

#include <string>

namespace vfc {

// Numbers as text, and back, whatever the locale.

using CGAL::Volume_filling_curves::internal::counted;

// returns a number for humans, with 6 significant digits
std::string to_text(double number);

// the shortest text from which the very same number is read
std::string with_all_digits(double number);

// returns whether all of the text is a finite number, or a whole number that is not negative
bool parse(const std::string& text, double& number);
bool parse(const std::string& text, unsigned long long& number);

} // namespace vfc

#endif // VFC_NUMBERS_H
