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
#include <string_view>

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

} // namespace vfc

#endif // VFC_BINARY_NUMBERS_H
