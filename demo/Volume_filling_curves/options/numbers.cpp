// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/numbers.h"

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <cmath>

namespace vfc {

namespace internal = CGAL::Volume_filling_curves::internal;

std::string to_text(double number)
{
  const int number_of_digits = 6;
  std::string text;
  internal::append_number(text, number, number_of_digits);
  return text;
}

std::string to_exact_text(double number)
{
  std::string text;
  internal::append_number(text, number, internal::fewest_digits);
  return text;
}

bool parse(const std::string& text, double& number)
{
  return internal::parse_all(text, number) && std::isfinite(number);
}

bool parse(const std::string& text, unsigned long long& number)
{
  return internal::parse_all(text, number);
}

} // namespace vfc
