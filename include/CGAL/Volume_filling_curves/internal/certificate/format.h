// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_FORMAT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_FORMAT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Little-endian bytes of numbers; doubles in their IEEE representation.

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

// Parts of a certificate. The manual's page "Format of Certificates" describes their encoding, so
// that anyone can write an independent reader.

constexpr std::string_view certificate_magic = "VFC-CERT";
constexpr std::uint32_t certificate_version = 2;

using Position = std::array<double, 3>;

template <typename Point_3>
Position to_position(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

inline const Position& to_position(const Position& p)
{
  return p;
}

// Curve at the start of the motion. Its nodes have the numbers 0, 1, ... in the lexicographic
// order of their coordinates.
struct Certificate_header
{
  std::uint64_t nodes = 0, edges = 0, components = 0;
  Sha256::Digest curve{};
};

// One change of the curve. Inserted nodes get the next numbers; no number is used twice.
struct Certificate_operation
{
  enum class Kind : std::uint8_t
  {
    MOVE = 0,   // `node` moves to `position` along a straight line
    INSERT = 1, // a new node at `position` splits the edge between `node` and `other`
    REMOVE = 2, // `node` is removed, and an edge joins its two neighbors
    END = 3     // no more operations
  };

  Kind kind = Kind::END;
  std::uint64_t node = 0, other = 0;
  Position position{};
};

// Curve at the end of the motion. `record` is the SHA-256 of all bytes before it.
struct Certificate_trailer
{
  std::uint64_t operations = 0, nodes = 0, edges = 0;
  Sha256::Digest curve{}, record{};
};

// Thrown for bytes that are not a certificate.
struct Certificate_format_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Maps signed numbers to unsigned ones, those nearest to zero first: 0, -1, 1, -2, 2, ...
inline std::uint64_t zigzag(std::int64_t x)
{
  const auto bits = static_cast<std::uint64_t>(x);
  return x < 0 ? ~(bits << 1) : bits << 1;
}

inline std::int64_t from_zigzag(std::uint64_t x)
{
  return static_cast<std::int64_t>(x & 1 ? ~(x >> 1) : x >> 1);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_FORMAT_H
