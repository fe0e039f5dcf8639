// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_BINARY_NUMBERS_H
#define VFC_BINARY_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vfc {

// returns the number that bytes are, at most eight
inline std::uint64_t bits_of(std::string_view bytes, bool is_big_endian)
{
  std::uint64_t bits = 0;
  for(std::size_t k = 0; k < bytes.size(); ++k)
    bits = bits << 8 | static_cast<unsigned char>(bytes[is_big_endian ? k : bytes.size() - 1 - k]);
  return bits;
}

// returns the real number that a pattern of bits stands for
template <typename Real, typename Pattern>
Real real_of(Pattern pattern)
{
  static_assert(sizeof(Real) == sizeof(Pattern), "the bits of the number");
  Real real;
  std::memcpy(&real, &pattern, sizeof real);
  return real;
}

// returns the bytes as text (RFC 4648)
std::string base64(const std::string& bytes);

// Returns the bytes that a text encodes, or none if base64() never writes this text.
std::optional<std::string> bytes_of_base64(std::string_view text);

// The same for the bytes of numbers of 32 bits, the least significant one first.
template <typename Number>
std::string base64(const std::vector<Number>& numbers)
{
  static_assert(sizeof(Number) == 4, "numbers of 32 bits");
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for(const Number number : numbers) {
    unsigned int bits;
    std::memcpy(&bits, &number, sizeof bits);
    for(int k = 0; k < 4; ++k) bytes += static_cast<char>(bits >> (8 * k) & 255);
  }
  return base64(bytes);
}

} // namespace vfc

#endif // VFC_BINARY_NUMBERS_H
