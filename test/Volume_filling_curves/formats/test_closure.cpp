// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

// Closed components of a file: by the format, or by the user's choice.

#include "support/curve_formats_test_support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace test_closure {

using namespace curve_formats_test;

// The first `kept` points of a ring of `n`, a line each.
std::string ring(std::size_t n, std::size_t kept)
{
  std::string text;
  for(std::size_t i = 0; i < kept; ++i) {
    const double t = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
    text += std::to_string(std::cos(t)) + ' ' + std::to_string(std::sin(t)) + " 0\n";
  }
  return text;
}

Reading read_as(const std::string& extension,
                const std::string& text,
                std::optional<Closure> closure = std::nullopt)
{
  const Folder folder;
  const std::string file = folder.file("curve" + extension);
  write(file, text);
  return read_file(file, closure);
}

TEST(Closure, of_rings_in_lists_of_points_must_be_told)
{
  for(const std::string extension : {".xyz", ".txt", ".dat"}) {
    const Reading reading = read_as(extension, ring(40, 40));
    EXPECT_FALSE(reading.is_accepted) << extension;
    ASSERT_EQ(reading.defects.size(), 1u);
    EXPECT_EQ(reading.defects[0].kind, Curve_defect_kind::UNDECIDED_CLOSURE);
    EXPECT_TRUE(is_error(reading.defects[0].kind));
    EXPECT_EQ(reading.defects[0].nodes, (std::vector<std::size_t>{1, 40}));
    EXPECT_EQ(reading.defects[0].line, 40u);
    EXPECT_EQ(reading.network.number_of_nodes(), 0u);
  }
}

TEST(Closure, of_lists_of_points_is_what_the_user_says)
{
  const Reading closed = read_as(".xyz", ring(40, 40), Closure::CLOSED);
  ASSERT_TRUE(closed.is_accepted);
  EXPECT_TRUE(closed.defects.empty());
  EXPECT_TRUE(closed.network.is_closed(0));
  EXPECT_EQ(closed.network.number_of_edges(), 40u);
  for(const Closure closure : {Closure::OPEN, Closure::IF_REPEATED}) {
    const Reading open = read_as(".xyz", ring(40, 40), closure);
    ASSERT_TRUE(open.is_accepted);
    EXPECT_FALSE(open.network.is_closed(0));
    EXPECT_EQ(open.network.number_of_edges(), 39u);
  }
}

TEST(Closure, of_small_rings_must_be_told_too)
{
  EXPECT_FALSE(read_as(".xyz", "0 0 0\n1 0 0\n0.5 0.8 0\n").is_accepted);
  EXPECT_FALSE(read_as(".xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n").is_accepted);
  EXPECT_FALSE(read_as(".xyz", ring(40, 38)).is_accepted) << "a gap of three edges";
}

TEST(Closure, of_arcs_with_ends_apart_is_evident)
{
  const std::vector<std::string> arcs = {ring(40, 36), "0 0 0\n1 0 0\n1 1 0\n", "0 0 0\n1 0 0\n",
                                         "0 0 0\n1 0 0\n2 0 0\n3 0 1\n"};
  for(const std::string& text : arcs) {
    const Reading reading = read_as(".xyz", text);
    EXPECT_TRUE(reading.is_accepted) << text;
    EXPECT_TRUE(reading.defects.empty());
    EXPECT_FALSE(reading.network.is_closed(0));
  }
}

TEST(Closure, of_arcs_that_cannot_be_closed_is_evident)
{
  // another component passes between the ends, exactly or almost
  const std::string arc = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n\n";
  EXPECT_TRUE(read_as(".xyz", arc + "0 0.5 -1\n0 0.5 1\n").is_accepted);
  EXPECT_FALSE(read_as(".xyz", arc + "1e-20 0.5 -1\n1e-20 0.5 1\n").is_accepted);
}

TEST(Closure, of_a_ring_that_repeats_its_first_point_is_evident)
{
  const Reading reading = read_as(".xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n");
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_TRUE(reading.network.is_closed(0));
  const Reading same = read_as(".xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n", Closure::CLOSED);
  ASSERT_TRUE(same.is_accepted);
  EXPECT_EQ(same.network.number_of_edges(), 4u);
  const Reading open = read_as(".xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n", Closure::OPEN);
  ASSERT_TRUE(open.is_accepted);
  EXPECT_EQ(open.network.number_of_nodes(), 4u);
  EXPECT_FALSE(open.network.is_closed(0));
}

// An arc and a loop of four points each, in every format that can hold them.
TEST(Closure, is_what_the_user_says_in_every_format)
{
  const std::string one = "0 0 0 1 0 0 1 1 0 0 3 0", two = "0 0 5 1 0 5 1 1 5 0 1 5";
  const std::vector<std::pair<std::string, std::string>> files = {
      {".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 3 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n"
               "l 1 2 3 4\nl 5 6 7 8 5\n"},
      {".polylines.txt", "4 " + one + "\n5 " + two + " 0 0 5\n"},
      {".vect", "VECT 2 8 0 4 -4 0 0 " + one + ' ' + two + '\n'},
      {".xyz", "0 0 0\n1 0 0\n1 1 0\n0 3 0\n\n0 0 5\n1 0 5\n1 1 5\n0 1 5\n0 0 5\n"},
      {".ply", "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
               "property float z\nelement edge 7\nproperty int vertex1\nproperty int vertex2\n"
               "end_header\n0 0 0\n1 0 0\n1 1 0\n0 3 0\n0 0 5\n1 0 5\n1 1 5\n0 1 5\n"
               "0 1\n1 2\n2 3\n4 5\n5 6\n6 7\n7 4\n"}};
  for(const auto& [extension, text] : files) {
    for(const Closure closure : {Closure::IF_REPEATED, Closure::CLOSED, Closure::OPEN}) {
      const Reading reading = read_as(extension, text, closure);
      ASSERT_TRUE(reading.is_accepted) << extension << ' ' << closure;
      ASSERT_EQ(reading.network.number_of_components(), 2u) << extension;
      EXPECT_EQ(reading.network.number_of_nodes(), 8u) << extension;
      EXPECT_EQ(reading.network.is_closed(0), closure == Closure::CLOSED) << extension;
      EXPECT_EQ(reading.network.is_closed(1), closure != Closure::OPEN) << extension;
    }
  }
}

TEST(Closure, by_an_edge_gives_the_network_of_a_repeated_point)
{
  const std::string one = "0 0 0\n1 0 0\n1 1 0\n0 3 0\n", two = "0 0 5\n1 0 5\n1 1 5\n";
  const Reading told = read_as(".xyz", one + '\n' + two, Closure::CLOSED);
  const Reading repeated = read_as(".xyz", one + "0 0 0\n\n" + two + "0 0 5\n");
  ASSERT_TRUE(told.is_accepted && repeated.is_accepted);
  ASSERT_EQ(told.network.number_of_edges(), repeated.network.number_of_edges());
  for(std::size_t e = 0; e < told.network.number_of_edges(); ++e) {
    EXPECT_EQ(told.network.source(e), repeated.network.source(e));
    EXPECT_EQ(told.network.target(e), repeated.network.target(e));
  }
}

TEST(Closure, of_a_single_edge_is_an_error)
{
  const Reading reading = read_as(".obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", Closure::CLOSED);
  EXPECT_EQ(complaint(reading), "3: an arc of a single edge cannot be closed");
}

TEST(Closure, of_components_with_junctions_does_not_change)
{
  const Folder folder;
  const std::string file = folder.file("star.obj");
  write(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nl 1 2\nl 1 3\nl 1 4\n");
  for(const Closure closure : {Closure::CLOSED, Closure::OPEN}) {
    Network star;
    EXPECT_TRUE(CGAL::IO::read_curve_network(file, star, Junctions::ALLOWED, closure));
    EXPECT_EQ(star.number_of_edges(), 3u);
  }
}

} // namespace test_closure
