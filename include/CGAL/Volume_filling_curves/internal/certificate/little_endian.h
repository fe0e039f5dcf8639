// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_LITTLE_ENDIAN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_LITTLE_ENDIAN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Numbers in bytes, the low ones first. Doubles have those of their IEEE representation.

inline void append_little_endian(std::string& bytes, std::uint64_t x, int size = 8)
{
  for(int k = 0; k < size; ++k) bytes += static_cast<char>(x >> 8 * k & 0xff);
}

inline void append_little_endian(std::string& bytes, double x)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  append_little_endian(bytes, bits);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_LITTLE_ENDIAN_H
