// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "film/Film.h"
#include "film/film_page.h"
#include "formats/binary_numbers.h"

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace test_film {

using namespace vfc;
using Json = nlohmann::json;
using Point = Curve::Point_3;

std::string decoded(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned int bits = 0, number = 0;
  for(const char c : text) {
    if(c == '=') break;
    bits = bits << 6 | static_cast<unsigned int>(digits.find(c));
    number += 6;
    if(number < 8) continue;
    number -= 8;
    bytes += static_cast<char>(bits >> number & 255);
  }
  return bytes;
}

template <typename Number>
std::vector<Number> numbers(const Json& text)
{
  const std::string bytes = decoded(text);
  std::vector<Number> result(bytes.size() / sizeof(Number));
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

TEST(Base64, has_the_least_byte_first)
{
  EXPECT_EQ(decoded(base64(std::vector<std::uint32_t>{0x04030201})), "\x01\x02\x03\x04");
}

TEST(Film, holds_the_frames_and_the_surface)
{
  const Curve ring_and_arc(
      {Point(0, 0, 0), Point(1, 0, 0), Point(0, 2, 0), Point(0, 0, 3), Point(0, 0, 4)},
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}});
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(-9, -9, -9), Kernel::Point_3(9, 0, 0),
                         Kernel::Point_3(0, 9, 0), Kernel::Point_3(0, 0, 9), mesh);
  Film film("a run", mesh);
  film.add(70, ring_and_arc);
  film.add(80, Curve());
  const Json json = Json::parse(film.to_json(0.5));
  EXPECT_EQ(json["title"], "a run");
  const double unit = 18 * std::sqrt(3); // the diagonal of the surface
  EXPECT_DOUBLE_EQ(json["tube"], 0.5 / unit);
  for(std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(json["low"][k], -9 / unit);
    EXPECT_DOUBLE_EQ(json["high"][k], 9 / unit);
  }
  ASSERT_EQ(json["frames"].size(), 2u);
  const Json& frame = json["frames"][0];
  EXPECT_EQ(frame["iteration"], 70);
  EXPECT_EQ(frame["nodes"], 5);
  EXPECT_DOUBLE_EQ(frame["length"], 1 + 2 + std::sqrt(5) + 1);
  EXPECT_EQ(frame["strands"], Json({{3, 1, 0}, {2, 0, 1}}));
  const std::vector<double> expected{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 4};
  const std::vector<float> coordinates = numbers<float>(frame["points"]);
  ASSERT_EQ(coordinates.size(), expected.size());
  for(std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(coordinates[k] * unit, expected[k], 1e-6 * unit);
  EXPECT_EQ(numbers<float>(json["surface"]["points"]).size(), 12u);
  EXPECT_EQ(numbers<std::uint32_t>(json["surface"]["triangles"]).size(), 12u);
  EXPECT_EQ(json["frames"][1]["strands"], Json::array());
}

// Single precision alone would round a curve far away to a point, and a tiny one to nothing.
TEST(Film, does_not_depend_on_size_and_place)
{
  const auto film_of = [](double size, double place) {
    Film film("", Mesh());
    const double a = place, b = place + size;
    film.add(0, Curve({Point(a, a, a), Point(b, a, a), Point(b, b, a), Point(a, b, b)},
                      {{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
    return Json::parse(film.to_json(0));
  };
  const Json usual = film_of(1, 0);
  for(const Json& film : {film_of(0x1p-200, 0), film_of(1, 0x1p40), film_of(0x1p100, 0)}) {
    EXPECT_EQ(film["frames"][0]["points"], usual["frames"][0]["points"]);
    EXPECT_EQ(film["tube"], usual["tube"]);
  }
}

// Half of the distance between strands is the radius at which they touch.
TEST(Film, has_a_tube_that_suits_it)
{
  Film film("", Mesh());
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t i = 0; i < 100; ++i) // rods in a box of volume 1, at a distance of 0.1
    for(const double z : {0., 1.}) {
      if(z > 0) edges.push_back({2 * i, 2 * i + 1});
      points.emplace_back(0.1 * double(i % 10), 0.1 * double(i / 10), z);
    }
  film.add(0, Curve(points, edges));
  const double tube = Json::parse(film.to_json(0))["tube"];
  const double unit = std::sqrt(1 + 2 * 0.81);
  EXPECT_GT(tube * unit, 0.005);
  EXPECT_LT(tube * unit, 0.05);
}

TEST(Film_page, is_one_file_and_keeps_its_parts_apart)
{
  Film film("</script><!--", Mesh());
  film.add(0, Curve({Point(0, 0, 0), Point(1, 0, 0)}, {{0, 1}}));
  const std::string page = film_page(film.to_json(0), "const a = '</script><!-- /* page.js */';");
  EXPECT_EQ(page.compare(0, 15, "<!DOCTYPE html>"), 0);
  const auto count = [&](const std::string& word) {
    std::size_t n = 0;
    for(std::size_t i = page.find(word); i != page.npos; i = page.find(word, i + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<script"), 2u);
  EXPECT_EQ(count("</script"), 2u);
  EXPECT_EQ(count("<!--"), 1u) << "the page's own";
  EXPECT_EQ(count("src="), 0u);
  EXPECT_EQ(count("href="), 0u);
  EXPECT_EQ(count("<\\/script><\\!-- /* page.js */';"), 1u);
  for(const std::string mark : {"/* page.css */", "/* three.js */", "/* film */"})
    EXPECT_EQ(count(mark), 0u) << mark;
  const std::size_t start = page.find('>', page.find("<script id=\"film\"")) + 1;
  const Json json = Json::parse(page.substr(start, page.find("</script>", start) - start));
  EXPECT_EQ(json["title"], "</script><!--");
}

} // namespace test_film
