// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SHA256_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SHA256_H

#include <CGAL/license/Volume_filling_curves.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Hash function SHA-256 (FIPS 180-4) for a stream of bytes that arrives in pieces: blocks of 64
// bytes are mixed into a state of eight words; the end is padded with the length of the message.
// Boost has SHA-1 only. Linear time, some 200 MB per second.
class Sha256
{
public:
  using Digest = std::array<std::uint8_t, 32>;

  void update(std::string_view bytes)
  {
    m_length += bytes.size();
    while(!bytes.empty()) {
      const std::string_view piece = bytes.substr(0, m_block.size() - m_filled);
      std::memcpy(m_block.data() + m_filled, piece.data(), piece.size());
      m_filled += piece.size();
      bytes.remove_prefix(piece.size());
      if(m_filled == m_block.size()) mix_block();
    }
  }

  // Returns the hash of all bytes so far; more can follow.
  Digest digest() const
  {
    Sha256 padded = *this;
    const std::uint64_t number_of_bits = 8 * m_length;
    std::string padding(1, '\x80');
    while((m_length + padding.size()) % 64 != 56) padding += '\0';
    for(int shift = 56; shift >= 0; shift -= 8)
      padding += static_cast<char>(number_of_bits >> shift & 0xff);
    padded.update(padding);
    Digest digest{};
    for(std::size_t i = 0; i < digest.size(); ++i)
      digest[i] = static_cast<std::uint8_t>(padded.m_state[i / 4] >> (24 - 8 * (i % 4)));
    return digest;
  }

private:
  using Word = std::uint32_t;

  static Word rotated(Word x, int count) { return x >> count | x << (32 - count); }

  // the first 32 bits of the fractional parts of the cube roots of the first 64 primes
  static constexpr std::array<Word, 64> constants = {
      0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
      0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
      0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
      0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
      0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
      0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
      0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
      0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
      0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
      0xc67178f2};

  // the words of the block, and 48 more computed from them
  std::array<Word, 64> schedule() const
  {
    std::array<Word, 64> w{};
    for(std::size_t i = 0; i < m_block.size(); ++i) w[i / 4] = w[i / 4] << 8 | m_block[i];
    for(std::size_t t = 16; t < w.size(); ++t) {
      const Word x = w[t - 15], y = w[t - 2];
      const Word s0 = rotated(x, 7) ^ rotated(x, 18) ^ x >> 3;
      const Word s1 = rotated(y, 17) ^ rotated(y, 19) ^ y >> 10;
      w[t] = w[t - 16] + s0 + w[t - 7] + s1;
    }
    return w;
  }

  void mix_block()
  {
    const std::array<Word, 64> w = schedule();
    auto [a, b, c, d, e, f, g, h] = m_state;
    for(std::size_t t = 0; t < w.size(); ++t) {
      const Word s1 = rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25);
      const Word t1 = h + s1 + ((e & f) ^ (~e & g)) + constants[t] + w[t];
      const Word s0 = rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22);
      const Word t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
      h = g;
      g = f;
      f = e;
      e = d + t1;
      d = c;
      c = b;
      b = a;
      a = t1 + t2;
    }
    const std::array<Word, 8> change = {a, b, c, d, e, f, g, h};
    for(std::size_t i = 0; i < change.size(); ++i) m_state[i] += change[i];
    m_filled = 0;
  }

  // the first 32 bits of the fractional parts of the square roots of the first 8 primes
  std::array<Word, 8> m_state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> m_block{};
  std::size_t m_filled = 0;
  std::uint64_t m_length = 0;
};

inline Sha256::Digest sha256(std::string_view bytes)
{
  Sha256 hash;
  hash.update(bytes);
  return hash.digest();
}

// Returns 64 hexadecimal digits.
inline std::string to_hex(const Sha256::Digest& digest)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for(const std::uint8_t byte : digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_SHA256_H
