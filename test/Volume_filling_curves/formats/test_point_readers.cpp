// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_formats_test_support.h"
#include "support/shared_curves.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

namespace test_point_readers {

using namespace curve_formats_test;

TEST(Vect_reader, reads_closed_and_open_polylines)
{
  const Reading reading = read_vect("VECT # a comment\n2 5 1\n-3 2\n1 0\n"
                                    "0 0 0 1 0 0\n0 1 0\n\n0 0 5\n1 1 6\n1 0 0 1\n");
  ASSERT_TRUE(reading.is_accepted);
  ASSERT_EQ(reading.network.number_of_components(), 2u);
  EXPECT_TRUE(reading.network.is_closed(0));
  EXPECT_FALSE(reading.network.is_closed(1));
  EXPECT_EQ(reading.network.point(4), Network::Point_3(1, 1, 6));
}

TEST(Vect_reader, takes_a_repeated_first_point_for_closure)
{
  const Reading reading = read_vect("VECT 1 4 0 4 0 0 0 0 1 0 0 0 1 0 0 0 0");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_nodes(), 3u);
  EXPECT_TRUE(reading.network.is_closed(0));
}

TEST(Vect_reader, takes_braces_around_the_file)
{
  const std::string rest = "VECT 1 3 0 -3 0 0 0 0 1 0 0 0 1 0";
  for(const std::string& text :
      {"{ " + rest + " }", "{" + rest + "}\n", "# a knot\n{ = " + rest + "\n}\n"}) {
    const Reading reading = read_vect(text);
    EXPECT_EQ(reading.is_accepted, text.find('=') == std::string::npos) << text;
    if(reading.is_accepted) {
      EXPECT_TRUE(reading.network.is_closed(0));
    }
  }
  EXPECT_EQ(complaint(read_vect("{ " + rest)), "1: '{' is not VECT, the first word");
}

TEST(Vect_reader, says_where_a_file_is_wrong)
{
  EXPECT_EQ(complaint(read_vect("")), "1: '' is not VECT, the first word");
  EXPECT_EQ(complaint(read_vect("VECT\n-1 1 5\n")), "2: '-1' is not a count");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2\n")), "3: the file ends before its last counts");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2 0\n3\n0\n")),
            "3: the polylines have more than the 2 vertices announced");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2 0\n-1\n0\n0 0 0\n")),
            "3: the polylines have fewer than the 2 vertices announced");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2 1\n2\n1\n0 0 0\n1 x 1\n0 0 0 1")),
            "6: 'x' is not a number");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2 1\n2\n1\n0 0 0\n1 1\n")),
            "7: the file ends before its last vertices");
  EXPECT_EQ(complaint(read_vect("VECT\n1 2 1\n2\n1\n0 0 0\n1 1 1\n1 0 0 Red\n")),
            "7: 'Red' is not a number");
  EXPECT_EQ(complaint(read_vect("VECT\n4294967295 9 0\n")),
            "3: the file ends before its last counts")
      << "and takes no memory for what is announced";
}

TEST(Point_list_reader, reads_columns)
{
  const Reading loop = read_point_list("# x y z\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n");
  ASSERT_TRUE(loop.is_accepted);
  EXPECT_EQ(loop.network.number_of_nodes(), 3u);
  EXPECT_TRUE(loop.network.is_closed(0));
  const Reading two = read_point_list("0 0 0\n1 0 0\n\n\n0 1 0\n0 1 1\n0 2 2\n");
  ASSERT_TRUE(two.is_accepted);
  EXPECT_EQ(two.network.number_of_components(), 2u);
  EXPECT_FALSE(two.network.is_closed(1));
}

TEST(Point_list_reader, reads_numbered_points_and_atoms)
{
  const Reading numbered = read_point_list("17 0 0 0\n18 1 0 0\n19 1 1 0\nEND\n");
  ASSERT_TRUE(numbered.is_accepted);
  EXPECT_EQ(numbered.network.point(1), Network::Point_3(1, 0, 0));
  const Reading atoms = read_point_list("2\na molecule of carbon\nC 0 0 0\nC 1.5 0 0\n");
  ASSERT_TRUE(atoms.is_accepted);
  EXPECT_EQ(atoms.network.point(1), Network::Point_3(1.5, 0, 0));
}

TEST(Point_list_reader, reads_counted_rings)
{
  const Reading rings = read_point_list("4\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n"
                                        "4\n0 0 1\n1 0 1\n0 1 1\n0 0 1\n");
  ASSERT_TRUE(rings.is_accepted);
  EXPECT_EQ(rings.network.number_of_components(), 2u);
  EXPECT_TRUE(rings.network.is_closed(1));
  EXPECT_EQ(complaint(read_point_list("5\n0 0 0\n1 0 0\n")),
            "1: 5 points are announced, there are 2");
}

TEST(Point_list_reader, says_where_a_file_is_wrong)
{
  EXPECT_EQ(complaint(read_point_list("0 0 0\n1 0\n")), "2: '1' does not begin three coordinates");
  EXPECT_EQ(complaint(read_point_list("0 0 0\n1 0 x\n")), "2: 'x' is not a number");
  EXPECT_EQ(complaint(read_point_list("once upon a time\n")),
            "1: 'once' does not begin three coordinates");
  EXPECT_EQ(complaint(read_point_list("\n")), "2: there are no points");
}

using Shared_formats = shared_curves::Shared_data_test;

TEST_F(Shared_formats, formats_of_other_programs_are_read)
{
  const auto folder = shared_curves::folder() / "real" / "formats";
  const auto components = [&](const std::string& name,
                              std::optional<Closure> closure = std::nullopt) {
    const Reading reading = read_file((folder / name).string(), closure);
    EXPECT_TRUE(reading.is_accepted) << name;
    return reading.network.number_of_components();
  };
  EXPECT_EQ(components("05_123.xyz", Closure::OPEN), 3u) << "which END separates";
  EXPECT_EQ(components("kymoknot_rings.dat"), 10u);
  EXPECT_EQ(components("9.2.40.vect"), 2u);
  EXPECT_EQ(components("10.127.vect"), 1u);
  EXPECT_EQ(components("kl_3_1_I.vect"), 1u);
  EXPECT_EQ(components("loop_as_face.obj"), 1u);
}

TEST_F(Shared_formats, bad_vect_files_are_refused_with_a_line)
{
  const auto folder = shared_curves::folder() / "real" / "formats" / "bad_vect";
  if(!fs::exists(folder)) GTEST_SKIP() << "there is no " << folder.string();
  for(const auto& file : fs::directory_iterator(folder))
    EXPECT_FALSE(complaint(read_vect(content(file.path().string()))).empty()) << file.path();
}

} // namespace test_point_readers
