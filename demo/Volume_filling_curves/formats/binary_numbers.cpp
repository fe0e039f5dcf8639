// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/binary_numbers.h"

#include <array>

namespace vfc {
namespace {

constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned int no_digit = 64;

std::array<unsigned int, 256> make_values()
{
  std::array<unsigned int, 256> values;
  values.fill(no_digit);
  for(unsigned int i = 0; i < digits.size(); ++i) values[static_cast<unsigned char>(digits[i])] = i;
  return values;
}

} // namespace

std::string base64(const std::string& bytes)
{
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned int bits = 0; // of three bytes, those beyond the end being 0
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::optional<std::string> bytes_of_base64(std::string_view text)
{
  static const std::array<unsigned int, 256> values = make_values();
  if(text.size() % 4 != 0) return std::nullopt;
  std::size_t size = text.size() / 4 * 3;
  for(int k = 0; k < 2 && !text.empty() && text.back() == '='; ++k, --size) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(size);
  unsigned int bits = 0, number_of_bits = 0; // that are left
  for(const char c : text) {
    const unsigned int value = values[static_cast<unsigned char>(c)];
    if(value == no_digit) return std::nullopt;
    bits = (bits << 6 | value) & 0xfff;
    number_of_bits += 6;
    if(number_of_bits < 8) continue;
    number_of_bits -= 8;
    bytes += static_cast<char>(bits >> number_of_bits & 0xff);
  }
  const unsigned int rest = bits & ((1u << number_of_bits) - 1);
  if(rest != 0) return std::nullopt;
  return bytes;
}

} // namespace vfc
