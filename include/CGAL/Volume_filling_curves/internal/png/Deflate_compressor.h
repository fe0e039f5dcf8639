// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_DEFLATE_COMPRESSOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_DEFLATE_COMPRESSOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Compresses bytes as one block of RFC 1951 with the fixed codes: repetitions of three bytes and more
// are found through a table that holds where their first three bytes stood last (LZ77). Pictures
// become about twice as large as with the best compressors, without a library. Linear time.
class Deflate_compressor
{
public:
  explicit Deflate_compressor(const std::string& bytes) : m_bytes(bytes) {}

  std::string operator()()
  {
    add_bits(1, 1); // the last block
    add_bits(1, 2); // with fixed codes
    std::vector<std::size_t> last_place(std::size_t(1) << hash_bits, none);
    for(std::size_t i = 0; i < m_bytes.size();) {
      std::size_t length = 0, distance = 0;
      if(i + min_length <= m_bytes.size()) {
        std::size_t& place = last_place[hash(i)];
        if(place != none && i - place <= window) {
          length = common_length(place, i);
          distance = i - place;
        }
        place = i;
      }
      if(length >= min_length)
        add_repetition(length, distance);
      else
        add_symbol(byte(i));
      i += length >= min_length ? length : 1;
    }
    add_symbol(end_of_block);
    if(m_count > 0) m_out += static_cast<char>(m_buffer);
    return std::move(m_out);
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr std::size_t window = 32768, min_length = 3, max_length = 258;
  static constexpr std::uint32_t end_of_block = 256;
  static constexpr int hash_bits = 15;

  // A number is written as the code of the largest base below it, and the rest in extra bits.
  struct Number_code
  {
    std::uint32_t base, extra_bits;
  };

  static constexpr std::array<Number_code, 29> lengths{
      {{3, 0},   {4, 0},   {5, 0},   {6, 0},   {7, 0},  {8, 0},  {9, 0},  {10, 0},
       {11, 1},  {13, 1},  {15, 1},  {17, 1},  {19, 2}, {23, 2}, {27, 2}, {31, 2},
       {35, 3},  {43, 3},  {51, 3},  {59, 3},  {67, 4}, {83, 4}, {99, 4}, {115, 4},
       {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
  static constexpr std::array<Number_code, 30> distances{
      {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},
       {9, 2},     {13, 2},    {17, 3},    {25, 3},     {33, 4},     {49, 4},
       {65, 5},    {97, 5},    {129, 6},   {193, 6},    {257, 7},    {385, 7},
       {513, 8},   {769, 8},   {1025, 9},  {1537, 9},   {2049, 10},  {3073, 10},
       {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

  std::uint32_t byte(std::size_t i) const { return static_cast<unsigned char>(m_bytes[i]); }

  std::size_t hash(std::size_t i) const
  {
    const std::uint32_t three = byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16;
    return (three * 2654435761u) >> (32 - hash_bits); // Knuth's multiplicative hash
  }

  std::size_t common_length(std::size_t i, std::size_t j) const
  {
    const std::size_t most = (std::min)(max_length, m_bytes.size() - j);
    std::size_t length = 0;
    while(length < most && m_bytes[i + length] == m_bytes[j + length]) ++length;
    return length;
  }

  void add_repetition(std::size_t length, std::size_t distance)
  {
    add_number(lengths, length, [this](std::uint32_t code) { add_symbol(257 + code); });
    add_number(distances, distance, [this](std::uint32_t code) { add_code(code, 5); });
  }

  template <typename Codes, typename Add>
  void add_number(const Codes& codes, std::size_t number, const Add& add)
  {
    const auto value = static_cast<std::uint32_t>(number);
    std::uint32_t code = static_cast<std::uint32_t>(codes.size()) - 1;
    while(codes[code].base > value) --code;
    add(code);
    add_bits(value - codes[code].base, codes[code].extra_bits);
  }

  void add_symbol(std::uint32_t symbol)
  {
    if(symbol < 144)
      add_code(0x30 + symbol, 8);
    else if(symbol < 256)
      add_code(0x190 + symbol - 144, 9);
    else if(symbol < 280)
      add_code(symbol - 256, 7);
    else
      add_code(0xC0 + symbol - 280, 8);
  }

  // Codes start with their highest bit, all else with the lowest.
  void add_code(std::uint32_t code, std::uint32_t count)
  {
    while(count > 0) add_bits(code >> --count & 1, 1);
  }

  void add_bits(std::uint32_t bits, std::uint32_t count)
  {
    m_buffer |= bits << m_count;
    m_count += count;
    for(; m_count >= 8; m_count -= 8, m_buffer >>= 8) m_out += static_cast<char>(m_buffer & 0xFF);
  }

  const std::string& m_bytes;
  std::string m_out;
  std::uint32_t m_buffer = 0, m_count = 0; // bits that wait for their byte to be full
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PNG_DEFLATE_COMPRESSOR_H
