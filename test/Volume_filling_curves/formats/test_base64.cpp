// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/binary_numbers.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace test_base64 {

TEST(Base64, is_that_of_the_standard) // RFC 4648, section 10
{
  for(const auto& [bytes, text] :
      {std::pair("", ""), std::pair("f", "Zg=="), std::pair("fo", "Zm8="), std::pair("foo", "Zm9v"),
       std::pair("foob", "Zm9vYg=="), std::pair("fooba", "Zm9vYmE="),
       std::pair("foobar", "Zm9vYmFy")}) {
    EXPECT_EQ(vfc::base64(std::string(bytes)), text);
    EXPECT_EQ(vfc::bytes_of_base64(text), bytes);
  }
}

TEST(Base64, knows_every_byte)
{
  std::string bytes;
  for(int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  EXPECT_EQ(vfc::bytes_of_base64(vfc::base64(bytes)), bytes);
}

TEST(Base64, refuses_all_else)
{
  for(const char* text : {"Z", "Zg", "Zm8", "Zg=", "Zg==Zg==", "Z===", "====", "=", "Zm9=Zm9v",
                          "Zm 8", "Zm9v\n", "Zm9v    ", "Zm-_", "Zm9\xff", "Zh==", "Zm9="})
    EXPECT_FALSE(vfc::bytes_of_base64(text)) << text;
  EXPECT_FALSE(vfc::bytes_of_base64(std::string(4, '\0')));
}

} // namespace test_base64
