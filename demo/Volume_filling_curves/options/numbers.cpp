// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace vfc {
namespace {

template <typename Number>
bool parse_all(const std::string& text, Number& number)
{
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

} // namespace

std::string to_text(double number)
{
  const int number_of_digits = 6;
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                    std::chars_format::general, number_of_digits);
  return std::string(buffer.data(), result.ptr);
}

std::string with_all_digits(double number)
{
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return std::string(buffer.data(), result.ptr);
}

bool parse(const std::string& text, double& number)
{
  return parse_all(text, number) && std::isfinite(number);
}

bool parse(const std::string& text, unsigned long long& number)
{
  return parse_all(text, number);
}

} // namespace vfc
