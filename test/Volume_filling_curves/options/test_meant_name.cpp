// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "options/complaint.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test_meant_name {

using vfc::meant_name;

const std::vector<std::string> commands = {"untangle", "simplify", "fill", "check", "draw"};

TEST(Meant_name, is_a_letter_or_two_away)
{
  for(const char* typed : {"untagle", "untanglee", "unfangle", "untangel", "ntangle", "untangled"})
    EXPECT_EQ(meant_name(typed, commands), "untangle") << typed;
  EXPECT_EQ(meant_name("fil", commands), "fill");
  EXPECT_EQ(meant_name("fill", commands), "fill");
}

TEST(Meant_name, is_the_closest)
{
  EXPECT_EQ(meant_name("--lenth", {"--length", "--lambda", "--lengths"}), "--length");
}

TEST(Meant_name, is_empty_if_none_is_close)
{
  for(const char* typed : {"", "x", "resolve", "trefoil.obj", "fa"})
    EXPECT_EQ(meant_name(typed, commands), "") << typed;
  EXPECT_EQ(meant_name("fill", {}), "");
}

} // namespace test_meant_name
