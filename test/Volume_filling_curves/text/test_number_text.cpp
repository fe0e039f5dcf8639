// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Numbers to text and back, with and without std::to_chars for doubles.

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_number_text {

namespace internal = CGAL::Volume_filling_curves::internal;
namespace c_library = internal::c_library;

std::uint64_t bits_of(double number)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

double number_of(std::uint64_t bits)
{
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

// Special numbers, and random ones of all magnitudes, short and long.
std::vector<double> numbers()
{
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0.,      -0.,  1.,     0.1,   -2.5,   1e5,  10000.,
                                 123456., 1e21, 1e22,   1e23,  5e-324, 1e-5, 0.0001,
                                 1 / 3.,  2e15, 7e-310, 1e300, 0x1p66};
  for(const double x :
      {Limits::max(), Limits::min(), Limits::lowest(), Limits::infinity(), -Limits::infinity()})
    numbers.push_back(x);
  std::mt19937_64 random(1);
  for(int i = 0; i < 2000; ++i) {
    const double x = number_of(random());
    if(std::isfinite(x)) numbers.push_back(x);
    numbers.push_back(static_cast<double>(random() % 1000000) * std::pow(10., i % 30 - 15));
  }
  return numbers;
}

struct Read
{
  std::ptrdiff_t length;
  std::errc error;
  std::uint64_t bits;

  bool operator==(const Read& other) const
  {
    return length == other.length && error == other.error && bits == other.bits;
  }
};

template <typename Reader>
Read read(const std::string& text, const Reader& reader)
{
  double number = 42; // stays after an error
  const auto result = reader(text.data(), text.data() + text.size(), number);
  return {result.ptr - text.data(), result.ec, bits_of(number)};
}

Read read(const std::string& text)
{
  return read(text, [](const char* first, const char* last, double& x) {
    return internal::number_from_text(first, last, x);
  });
}

Read read_by_c_library(const std::string& text)
{
  return read(text, [](const char* first, const char* last, double& x) {
    return c_library::number_from_text(first, last, x);
  });
}

TEST(Number_text, c_library_writes_the_same_text)
{
  for(const double x : numbers())
    for(const int digits : {internal::fewest_digits, 1, 6, 17}) {
      std::string text, other;
      internal::append_number(text, x, digits);
      c_library::append_number(other, x, digits);
      EXPECT_EQ(text, other) << digits << " digits";
    }
}

TEST(Number_text, both_ways_give_back_the_same_bits)
{
  for(const double x : numbers())
    for(const int digits : {internal::fewest_digits, 17}) {
      std::string text;
      c_library::append_number(text, x, digits);
      const Read expected{static_cast<std::ptrdiff_t>(text.size()), std::errc(), bits_of(x)};
      EXPECT_TRUE(read(text) == expected) << text;
      EXPECT_TRUE(read_by_c_library(text) == expected) << text;
    }
}

TEST(Number_text, c_library_takes_the_same_words)
{
  for(const std::string text :
      {"",        "-",     "+1",    " 1",     "1 ",     "1,5",   "1.5.2", "1e",
       "1e+",     "1e+2x", "0x10",  "-0x1p3", ".5",     "-.5",   "5.",    ".",
       "e5",      "--1",   "1e400", "-1e400", "1e-400", "inf",   "-inf",  "Infinity",
       "infinit", "nan",   "1_0",   "12abc",  "1E5",    "00012", "1e0005"})
    EXPECT_TRUE(read(text) == read_by_c_library(text)) << text;
}

TEST(Number_text, c_library_heeds_no_locale)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  const char* set = nullptr;
  for(const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR", "ps_AF"})
    if(set == nullptr) set = std::setlocale(LC_NUMERIC, name);
  if(set == nullptr) GTEST_SKIP() << "there is no locale with a decimal comma";
  std::string text;
  c_library::append_number(text, -1234.5, internal::fewest_digits);
  const Read whole = read_by_c_library("1.5"), beginning = read_by_c_library("1,5");
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(text, "-1234.5");
  EXPECT_TRUE((whole == Read{3, std::errc(), bits_of(1.5)}));
  EXPECT_TRUE((beginning == Read{1, std::errc(), bits_of(1)}));
}

TEST(Number_text, whole_text_has_to_be_the_number)
{
  double x = 0;
  int n = 0;
  EXPECT_TRUE(internal::parse_all("-2.5e1", x));
  EXPECT_EQ(x, -25);
  EXPECT_TRUE(internal::parse_all("-17", n));
  EXPECT_EQ(n, -17);
  EXPECT_FALSE(internal::parse_all("1.5", n));
  EXPECT_FALSE(internal::parse_all("1.5 ", x));
  EXPECT_FALSE(internal::parse_all("", x));
}

} // namespace test_number_text
