// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include <CGAL/Volume_filling_curves/internal/certificate/Sha256.h>

#include <gtest/gtest.h>

#include <string>

namespace test_sha256 {

using namespace CGAL::Volume_filling_curves::internal;

std::string hex_hash(const std::string& bytes)
{
  return to_hex(sha256(bytes));
}

// FIPS 180-4 and its examples
TEST(Sha256, has_the_standard_values)
{
  EXPECT_EQ(hex_hash(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex_hash("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex_hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hex_hash("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                     "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(hex_hash(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, does_not_depend_on_the_pieces)
{
  std::string bytes;
  for(int i = 0; i < 300; ++i) bytes += static_cast<char>(7 * i);
  for(std::size_t length : {55u, 56u, 63u, 64u, 65u, 119u, 120u, 128u, 300u})
    for(std::size_t piece = 1; piece < 70; ++piece) {
      const std::string message = bytes.substr(0, length);
      Sha256 hash;
      for(std::size_t i = 0; i < length; i += piece) hash.update(message.substr(i, piece));
      EXPECT_EQ(hash.digest(), sha256(message)) << length << " bytes in pieces of " << piece;
    }
}

TEST(Sha256, can_be_read_on_the_way)
{
  Sha256 hash;
  hash.update("ab");
  EXPECT_EQ(hash.digest(), sha256("ab"));
  hash.update("c");
  EXPECT_EQ(hash.digest(), sha256("abc"));
}

} // namespace test_sha256
