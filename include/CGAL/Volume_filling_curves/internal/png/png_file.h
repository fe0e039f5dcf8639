// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_PNG_FILE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_PNG_FILE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/png/Deflate_compressor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The bytes of a PNG file (RFC 2083): red, green and blue with 8 bits each, no transparency.

struct Rgb_image
{
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes; // three per pixel, rows from the top
};

inline std::string big_endian(std::uint32_t number)
{
  std::string text;
  for(int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(number >> shift & 0xFF);
  return text;
}

// The checksum of the parts of a PNG file.
inline std::uint32_t crc32(std::string_view bytes)
{
  std::uint32_t crc = 0xFFFFFFFF;
  for(const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for(int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
  }
  return ~crc;
}

// The checksum of compressed data (RFC 1950).
inline std::uint32_t adler32(std::string_view bytes)
{
  std::uint32_t a = 1, b = 0;
  for(const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

inline std::string png_chunk(const std::string& type, const std::string& data)
{
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(crc32(type + data));
}

// Each row is replaced by the differences to what its pixels were predicted to be, in the way that
// makes the differences smallest: they compress better than the pixels.
class Png_row_filter
{
public:
  explicit Png_row_filter(const Rgb_image& image) : m_image(image) {}

  std::string operator()() const
  {
    std::string text;
    for(std::size_t y = 0; y < m_image.height; ++y) text += best_row(y);
    return text;
  }

private:
  static constexpr std::array<char, 3> methods{1, 2, 4}; // left, above, Paeth's

  std::string best_row(std::size_t y) const
  {
    std::string best;
    long least = (std::numeric_limits<long>::max)();
    for(const char method : methods) {
      const std::string row = filtered_row(y, method);
      long sum = 0;
      for(const char c : row) sum += std::abs(static_cast<signed char>(c));
      if(sum >= least) continue;
      least = sum;
      best = row;
    }
    return best;
  }

  std::string filtered_row(std::size_t y, char method) const
  {
    std::string row(1, method);
    for(std::size_t i = 0; i < 3 * m_image.width; ++i) {
      const int left = at(i, 3, y), above = at(i, 0, y - 1), diagonal = at(i, 3, y - 1);
      const int guess = method == 1 ? left : method == 2 ? above : paeth(left, above, diagonal);
      row += static_cast<char>(at(i, 0, y) - guess);
    }
    return row;
  }

  // The byte `back` places before byte i of row y, 0 outside; y is unsigned, so -1 is outside too.
  int at(std::size_t i, std::size_t back, std::size_t y) const
  {
    return i < back || y >= m_image.height ? 0 : m_image.bytes[3 * m_image.width * y + i - back];
  }

  static int paeth(int left, int above, int diagonal)
  {
    const int guess = left + above - diagonal;
    const int to_left = std::abs(guess - left), to_above = std::abs(guess - above);
    const int to_diagonal = std::abs(guess - diagonal);
    if(to_left <= to_above && to_left <= to_diagonal) return left;
    return to_above <= to_diagonal ? above : diagonal;
  }

  const Rgb_image& m_image;
};

inline std::string to_png(const Rgb_image& image)
{
  const std::string rows = Png_row_filter(image)();
  const std::string header = big_endian(static_cast<std::uint32_t>(image.width)) +
                             big_endian(static_cast<std::uint32_t>(image.height)) +
                             std::string("\x08\x02\0\0\0", 5); // 8 bits, colors
  const std::string data = "\x78\x01" + Deflate_compressor(rows)() + big_endian(adler32(rows));
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png_chunk("IDAT", data) +
         png_chunk("IEND", "");
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_PNG_FILE_H
