// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_io_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace test_curve_readers {

using namespace curve_io_test;
using Point_3 = Network::Point_3;

// Four corners and a closed curve, in every way of writing that OBJ knows.
class Every_form_of_a_square : public testing::TestWithParam<std::string>
{};

TEST_P(Every_form_of_a_square, is_the_same_closed_curve)
{
  const Reading reading = read_obj(GetParam());
  EXPECT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.defects.empty()) << to_string(reading.defects.front(), "");
  ASSERT_EQ(reading.network.number_of_components(), 1u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(reading.network.point(2), Point_3(1, 1, 0));
}

INSTANTIATE_TEST_SUITE_P(
    Obj,
    Every_form_of_a_square,
    testing::Values(square + "l 1 2 3 4 1\n",
                    square + "l 1 2 3 4 1", // no newline at the end
                    square + "l 1 2\nl 2 3\nl 3 4\nl 4 1\n",
                    square + "l 1 2\nl 4 3\nl 4 1\nl 3 2\n",
                    square + "l 1/7 2/8 3/9 4/1 1/7\n",
                    square + "l 1/ 2/ 3/ 4/ 1/\n",
                    square + "l -4 -3 -2 -1 -4\n",
                    square + "l 1 -3 3 -1 1\n",
                    square + "l 01 2 3 4 1\n",
                    "l 1 2 3 4 1\n" + square,
                    "v 0 0 0\nv 1 0 0\nl -2 -1\nv 1 1 0\nl -2 -1\nv 0 1 0\nl -2 -1 1\n",
                    square + "l 1 2 \\\n3 4 \\\n 1\n",
                    square + "l 1 2\\\n3 4\\\r\n1\n",
                    "v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0 .2 .3 .4\nl 1 2 3 4 1",
                    "v +0 0.0 0.\nv 1e0 .0 -0\nv 1E+0 1e-0 0\nv 0 1 1e-999\nl 1 2 3 4 1",
                    "\xEF\xBB\xBF" + square + "l 1 2 3 4 1",
                    "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nl 1 2 3 4 1\r\n",
                    "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rl 1 2 3 4 1\r",
                    "\tv\t0 0\t0 \n v 1 0 0\t\nv  1  1  0\n\n\nv 0 1 0\n \t\nl\t1 2 3  4 1 ",
                    "# v 9 9 9\nv 0 0 0 # here\nv 1 0 0 #\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1 # 5",
                    "# \xC3\xA4 \xE4 C:\\\no \xE4\ng a b\ns off\nmtllib x\nusemtl y\nvt 0 0\n" +
                        square + "vn 0 0 1\np 1\nl 1 2 3 4 1\nf 1 2 3\n"));

TEST(Obj, index_with_a_plus_sign_is_no_index)
{
  EXPECT_FALSE(read_obj(square + "l +1 2 3 4 1\n").is_accepted);
}

TEST(Obj, record_that_does_not_repeat_its_first_index_is_open)
{
  const Reading reading = read_obj(square + "l 1 2 3 4");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_FALSE(reading.network.is_closed(0));
  EXPECT_EQ(reading.network.number_of_edges(), 3u);
}

TEST(Obj, vertices_without_lines_are_one_closed_curve_with_a_warning)
{
  const Reading reading = read_obj(square);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.network.is_closed(0));
  ASSERT_EQ(reading.defects.size(), 1u);
  EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::NO_LINES);
}

TEST(Obj, components_keep_the_order_of_their_first_edges)
{
  const Reading reading =
      read_obj("v 0 0 0\nv 1 0 0\nv 0 0 5\nv 1 0 5\nv 2 0 5\nl 3 4\nl 1 2\nl 4 5\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{2, 3, 4, 0, 1}));
}

TEST(Obj, fixed_pins_vertices)
{
  const Reading reading = read_obj("fixed 2\n" + square + "l 1 2 3 4 1\nfixed 4 -4\n");
  ASSERT_TRUE(reading.is_accepted);
  const std::vector<bool> expected{true, true, false, true};
  for(std::size_t v = 0; v < 4; ++v) EXPECT_EQ(reading.network.is_pinned(v), expected[v]);
}

TEST(Obj, pin_of_a_merged_node_holds_for_the_node_that_stays)
{
  const Reading reading = read_obj(square + "v 0 1 0\nl 1 2 3 4 5 1\nfixed 5\n");
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_nodes(), 4u);
  EXPECT_EQ(reading.origins().back(), 3u);
  EXPECT_TRUE(reading.network.is_pinned(3));
}

TEST(Polylines_txt, repeated_first_point_closes)
{
  const Reading reading = read_txt("4 0 0 0 1 0 0 0 1 0 0 0 -0\n\n# arc\n2 0 0 1 5 5 5\n1 9 9 9");
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_FALSE(reading.network.is_closed(1));
  EXPECT_EQ(reading.origins(), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  ASSERT_EQ(reading.defects.size(), 1u);
  EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::ISOLATED_VERTEX);
  EXPECT_EQ(reading.defects[0].nodes, std::vector<std::size_t>{6});
}

TEST(Polylines_txt, numbers_may_continue_on_the_next_line)
{
  const Reading reading = read_txt("3 0 0 0\n1 0 0\n1 1\n0\n2 0 0 5 1 1 5\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 5u);
}

TEST(Polylines_txt, equal_ends_are_one_node_of_a_network_only)
{
  const std::string text = "2 0 0 0 1 0 0\n2 1 0 0 0 1 0\n2 1 0 0 0 0 1\n";
  EXPECT_FALSE(read_txt(text).is_accepted);
  const Reading reading = read_txt(text, Junctions::ALLOWED);
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 4u);
  EXPECT_TRUE(reading.network.has_junction());
}

TEST(Polylines_txt, wrong_number_of_points_is_an_error)
{
  for(const std::string text :
      {"3 0 0 0 1 0 0", "1 0 0 0 1 0 0", "2 0 0 0 1 0\n", "99999999999 0 0 0 1 1 1"}) {
    const Reading reading = read_txt(text);
    EXPECT_FALSE(reading.is_accepted);
    ASSERT_FALSE(reading.defects.empty());
    EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::WRONG_POINT_COUNT) << text;
  }
}

TEST(Numbers, tell_overflow_from_underflow)
{
  double x = 0;
  const std::string zeros(400, '0');
  for(const std::string word : {"1e400", "1e99999999999999999999", "100e307"}) {
    EXPECT_TRUE(internal::parse_number(word, x));
    EXPECT_EQ(x, std::numeric_limits<double>::infinity()) << word;
  }
  EXPECT_TRUE(internal::parse_number("1" + zeros + "e-1", x));
  EXPECT_EQ(x, std::numeric_limits<double>::infinity());
  for(const std::string word : {"1e-400", "-1e-99999999999999999999", "0.0001e-330"}) {
    EXPECT_TRUE(internal::parse_number(word, x));
    EXPECT_EQ(x, 0) << word;
    EXPECT_EQ(std::signbit(x), word[0] == '-');
  }
  EXPECT_TRUE(internal::parse_number("." + zeros + "1", x));
  EXPECT_EQ(x, 0);
  for(const std::string word : {"", "+", "+-1", "1,5", "1e", "0x10", "1 ", "--1", "1.2.3"})
    EXPECT_FALSE(internal::parse_number(word, x)) << word;
}

TEST(Obj_reader, takes_an_only_face_for_a_loop)
{
  const std::string pentagon = square + "v -1 0.5 0\n";
  const Reading loop = read_obj(pentagon + "f 1//1 2//2 3//3 4//4 5//5\n");
  ASSERT_TRUE(loop.is_accepted);
  EXPECT_EQ(loop.network.number_of_edges(), 5u);
  ASSERT_EQ(loop.defects.size(), 1u);
  EXPECT_EQ(loop.defects[0].kind, Curve_defect_kind::NO_LINES);
  EXPECT_FALSE(read_obj(pentagon + "f 1 2 3 4\n").is_accepted) << "a mesh";
  EXPECT_FALSE(read_obj(pentagon + "f 1 2 3 4 5\nf 1 3 4\n").is_accepted) << "a mesh";
  EXPECT_EQ(read_obj(square + "f 1 2 3\nl 1 2 3 4\n").network.number_of_edges(), 3u);
}

TEST(Numbers, with_exponents_beyond_all_integers_are_not_zero)
{
  for(const char* exponent : {"9223372036854775807", "9223372036854775806", "99999999999999999999"})
    EXPECT_FALSE(read_obj("v 0 0 1e" + std::string(exponent) + "\nv 1 0 0\nv 0 1 0\n").is_accepted);
  EXPECT_TRUE(read_obj("v 0 0 1e-9223372036854775808\nv 1 0 0\nv 0 1 0\n").is_accepted);
}

} // namespace test_curve_readers
