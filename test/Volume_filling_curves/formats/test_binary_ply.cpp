// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "support/curve_formats_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

// Binary PLY files, of which all numbers are written here byte by byte.
namespace test_binary_ply {

using namespace curve_formats_test;

enum class Order
{
  LITTLE,
  BIG
};

template <typename Number>
std::string bytes(Number number, Order order)
{
  std::uint64_t bits = 0;
  if constexpr(std::is_same_v<Number, float>) {
    std::uint32_t word;
    std::memcpy(&word, &number, 4);
    bits = word;
  } else {
    std::memcpy(&bits, &number, sizeof number); // the tests run on little-endian machines
  }
  std::string result;
  for(std::size_t k = 0; k < sizeof number; ++k) result += static_cast<char>(bits >> 8 * k & 255);
  if(order == Order::BIG) std::reverse(result.begin(), result.end());
  return result;
}

std::string header(Order order, const std::string& elements)
{
  return "ply\nformat " +
         std::string(order == Order::BIG ? "binary_big_endian" : "binary_little_endian") +
         " 1.0\n" + elements + "end_header\n";
}

const std::string vertices = "element vertex 3\nproperty float x\nproperty double y\n"
                             "property short z\nproperty uchar pinned\n";
const std::string edges = "element edge 2\nproperty int vertex1\nproperty uint16 vertex2\n";

std::string vertex(float x, double y, std::int16_t z, std::uint8_t pinned, Order order)
{
  return bytes(x, order) + bytes(y, order) + bytes(z, order) + bytes(pinned, order);
}

std::string edge(std::int32_t v, std::uint16_t w, Order order)
{
  return bytes(v, order) + bytes(w, order);
}

// The first byte that follows the header is that of a line end where the order is little.
std::string items(Order order)
{
  float x = 1;
  std::uint32_t bits = 0x3f80000a;
  std::memcpy(&x, &bits, 4);
  return vertex(x, -1e-300, -2, 0, order) + vertex(3, 4, 300, 7, order) +
         vertex(0.1f, 0.1, 32767, 0, order) + edge(0, 1, order) + edge(1, 2, order);
}

TEST(Binary_ply, keeps_the_value_of_every_number)
{
  for(const Order order : {Order::LITTLE, Order::BIG}) {
    const Reading reading = read_ply(header(order, vertices + edges) + items(order));
    ASSERT_TRUE(reading.is_accepted);
    const Network& arc = reading.network;
    ASSERT_EQ(arc.number_of_nodes(), 3u);
    EXPECT_EQ(arc.number_of_edges(), 2u);
    EXPECT_EQ(arc.point(0), Network::Point_3(1 + 10 * 0x1p-23, -1e-300, -2));
    EXPECT_EQ(arc.point(1), Network::Point_3(3, 4, 300));
    EXPECT_EQ(arc.point(2), Network::Point_3(double(0.1f), 0.1, 32767));
    EXPECT_FALSE(arc.is_pinned(0));
    EXPECT_TRUE(arc.is_pinned(1));
    EXPECT_TRUE(reading.defects.empty());
  }
}

TEST(Binary_ply, passes_over_lists_and_other_elements)
{
  const Order order = Order::LITTLE;
  const std::string lists = "element face 2\nproperty list uchar int vertex_indices\n"
                            "property char flag\n";
  const auto face = [&](std::initializer_list<std::int32_t> corners) {
    std::string item = bytes(static_cast<std::uint8_t>(corners.size()), order);
    for(const std::int32_t v : corners) item += bytes(v, order);
    return item + bytes(static_cast<std::int8_t>(-1), order);
  };
  const Reading reading =
      read_ply(header(order, lists + vertices + edges) + face({0, 1, 2}) + face({}) + items(order));
  ASSERT_TRUE(reading.is_accepted);
  EXPECT_EQ(reading.network.number_of_edges(), 2u);
}

TEST(Binary_ply, may_have_a_header_with_other_line_ends)
{
  std::string head = header(Order::BIG, vertices + edges);
  for(std::size_t i = head.find('\n'); i != std::string::npos; i = head.find('\n', i + 2))
    head.insert(i, 1, '\r');
  EXPECT_TRUE(read_ply(head + items(Order::BIG)).is_accepted);
}

// Items have no lines.
TEST(Binary_ply, says_what_is_wrong)
{
  const Order order = Order::LITTLE;
  const std::string head = header(order, vertices + edges), all = items(order);
  EXPECT_EQ(complaint(read_ply(head + all.substr(0, all.size() - 1))),
            "0: the file ends within edge 2 of 2");
  EXPECT_EQ(complaint(read_ply(head)), "0: the file ends within vertex 1 of 3");
  EXPECT_EQ(
      complaint(read_ply(head + all.substr(0, all.size() - 2) + bytes(std::uint16_t(3), order))),
      "0: edge 2: there is no vertex 3 (numbered from 0)");
  EXPECT_EQ(complaint(read_ply(header(order, "element vertex 1\nproperty half x\n"))),
            "4: 'half' is no type of a property");
  EXPECT_EQ(complaint(read_ply(header(order, "element vertex 9\n") + "123")),
            "3: vertices have no numbers x, y and z");
  const Reading infinite = read_ply(header(order, vertices) + vertex(0, INFINITY, 0, 0, order) +
                                    vertex(0, 1, 0, 0, order) + vertex(1, 1, 0, 0, order));
  ASSERT_FALSE(infinite.is_accepted);
  EXPECT_EQ(infinite.defects.at(0).kind, Curve_defect_kind::NON_FINITE_COORDINATE);
  EXPECT_EQ(infinite.defects.at(0).nodes, std::vector<std::size_t>{1});
}

TEST(Binary_ply, takes_no_memory_for_what_is_announced)
{
  const std::string many = "element vertex 18446744073709551615\n";
  EXPECT_EQ(complaint(read_ply(header(Order::LITTLE, many + "property double x\nproperty double y\n"
                                                            "property double z\n"))),
            "3: more is announced than the file can hold");
  EXPECT_EQ(complaint(read_ply(header(Order::LITTLE, "element none 99999999999999\n"))),
            "3: more is announced than the file can hold");
}

} // namespace test_binary_ply
