// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_NUMBER_TEXT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_NUMBER_TEXT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Conversion of doubles to text and back, independent of the locale. If std::to_chars and
// std::from_chars take only integers, as in libc++ before version 20, the C library converts, with
// its decimal point replaced: text and bits are the same.
//
// `append_number()` writes a number with a given number of significant digits, like "%.*g", or with
// the fewest digits that restore the same double. `number_from_text()` reads a number like
// std::from_chars; a number out of range leaves `number` unchanged.

constexpr int fewest_digits = 0;

namespace c_library {

inline std::string decimal_point()
{
  const std::lconv* const conventions = std::localeconv();
  return conventions->decimal_point;
}

// \pre `format` takes a number of digits and a double
inline std::string print(const char* format, int number_of_digits, double number)
{
  const std::size_t longest = 350; // 309 digits before the point, and a few more
  std::string text(longest, '\0');
  const int length = std::snprintf(text.data(), text.size(), format, number_of_digits, number);
  text.resize(static_cast<std::size_t>(length));
  const std::string point = decimal_point();
  const std::size_t position = text.find(point);
  if(position != std::string::npos) text.replace(position, point.size(), ".");
  return text;
}

// Returns the shorter of both notations, with the fewest digits that restore the same double.
inline std::string shortest_text(double number)
{
  if(!std::isfinite(number)) return print("%.*g", 1, number);
  const auto is_exact = [&](int digits) { // both calls use the point of the locale
    char text[32];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, number);
    return std::strtod(text, nullptr) == number;
  };
  int digits = 1;
  while(digits < std::numeric_limits<double>::max_digits10 && !is_exact(digits)) ++digits;
  const std::string scientific = print("%.*e", digits - 1, number);
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  const std::string fixed = print("%.*f", (std::max)(0, digits - 1 - exponent), number);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

inline void append_number(std::string& text, double number, int number_of_digits)
{
  text += number_of_digits == fewest_digits ? shortest_text(number)
                                            : print("%.*g", number_of_digits, number);
}

// Returns the beginning that can be a number for std::from_chars. strtod would also accept blanks,
// a plus sign, hexadecimal digits and the locale's point.
inline std::string_view beginning_of_number(std::string_view text)
{
  if(text.empty() || text[0] == '+') return {};
  const auto may_belong = [](char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' ||
           (is_letter && c != 'x' && c != 'X');
  };
  const auto end = std::find_if_not(text.begin(), text.end(), may_belong);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

inline std::from_chars_result number_from_text(const char* first, const char* last, double& number)
{
  const std::string point = decimal_point();
  std::string text;
  for(const char c :
      beginning_of_number(std::string_view(first, static_cast<std::size_t>(last - first))))
    c == '.' ? text += point : text += c;
  char* end = nullptr;
  errno = 0;
  const double value = std::strtod(text.c_str(), &end);
  const std::string read(text.c_str(), static_cast<const char*>(end));
  if(read.empty()) return {first, std::errc::invalid_argument};
  const bool has_point = read.find(point) != std::string::npos;
  const char* const stop = first + read.size() - (has_point ? point.size() - 1 : 0);
  if(errno == ERANGE && (value == 0 || std::isinf(value)))
    return {stop, std::errc::result_out_of_range};
  number = value;
  return {stop, std::errc()};
}

} // namespace c_library

#if defined(__cpp_lib_to_chars) && !defined(CGAL_VOLUME_FILLING_CURVES_NUMBERS_BY_C_LIBRARY)

inline void append_number(std::string& text, double number, int number_of_digits)
{
  char buffer[32]; // sign, point, 17 digits, e-308
  char* const last = buffer + sizeof buffer;
  const auto result =
      number_of_digits == fewest_digits
          ? std::to_chars(buffer, last, number)
          : std::to_chars(buffer, last, number, std::chars_format::general, number_of_digits);
  text.append(buffer, result.ptr);
}

inline std::from_chars_result number_from_text(const char* first, const char* last, double& number)
{
  return std::from_chars(first, last, number);
}

#else

using c_library::append_number;
using c_library::number_from_text;

#endif

// Appends 17 digits, which restore the same double.
inline void append_number(std::string& text, double number)
{
  append_number(text, number, std::numeric_limits<double>::max_digits10);
}

template <typename Integer>
std::from_chars_result number_from_text(const char* first, const char* last, Integer& number)
{
  static_assert(std::is_integral_v<Integer>);
  return std::from_chars(first, last, number);
}

// Reads a number. Returns whether it is the whole text.
template <typename Number>
bool parse_all(std::string_view text, Number& number)
{
  const char* const last = text.data() + text.size();
  const auto [end, error] = number_from_text(text.data(), last, number);
  return error == std::errc() && end == last;
}

// Returns "(x, y, z)", for messages.
template <typename Point_3>
std::string point_text(const Point_3& p)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return text.str();
}

// Returns a number with its noun, such as "1 vertex" or "2 vertices".
inline std::string counted(std::size_t number,
                           const std::string& singular,
                           const std::string& plural)
{
  return std::to_string(number) + ' ' + (number == 1 ? singular : plural);
}

// the same for a noun whose plural is formed by an s
inline std::string counted(std::size_t number, const std::string& singular)
{
  return counted(number, singular, singular + 's');
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TEXT_NUMBER_TEXT_H
