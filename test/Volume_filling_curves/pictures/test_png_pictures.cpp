// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Scene_raster.h"
#include "pictures/curve_pictures.h"
#include "pictures/png_file.h"

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace test_png_pictures {

using namespace vfc;

// Decodes a picture with libpng.
Rgb_image read_png(const std::string& file)
{
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&header, file.data(), file.size()));
  EXPECT_EQ(header.format, std::uint32_t(PNG_FORMAT_RGB));
  Rgb_image image{header.width, header.height, {}};
  image.bytes.resize(PNG_IMAGE_SIZE(header));
  EXPECT_TRUE(png_image_finish_read(&header, nullptr, image.bytes.data(), 0, nullptr));
  return image;
}

TEST(Png_file, holds_the_pixels)
{
  std::mt19937 random(1);
  Rgb_image image{37, 11, {}};
  while(image.bytes.size() < 3 * image.width * image.height)
    image.bytes.push_back(static_cast<std::uint8_t>(random() % 256));
  const Rgb_image read = read_png(to_png(image));
  EXPECT_EQ(read.width, image.width);
  EXPECT_EQ(read.height, image.height);
  EXPECT_EQ(read.bytes, image.bytes);
}

TEST(Scene_raster, meets_a_capsule_where_it_is)
{
  Scene_raster raster(40, 40);
  const Vector a(10, 20, 3), b(30, 20, 13);
  raster.add_capsule(a, b, 5, 7);
  for(std::size_t y = 0; y < 40; ++y)
    for(std::size_t x = 0; x < 40; ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
      double highest = -1e9; // by trying many balls
      for(int i = 0; i <= 4000; ++i) {
        const Vector c = a + i / 4000. * (b - a);
        const double rise2 = 25 - (px - c.x()) * (px - c.x()) - (py - c.y()) * (py - c.y());
        if(rise2 >= 0) highest = std::max(highest, c.z() + std::sqrt(rise2));
      }
      ASSERT_EQ(sample.has_tube(), highest > -1e9) << x << ' ' << y;
      if(!sample.has_tube()) continue;
      EXPECT_NEAR(sample.depth, highest, 1e-3);
      EXPECT_EQ(sample.component, 7u);
    }
}

TEST(Scene_raster, adds_surfaces_before_and_behind_the_tube)
{
  Scene_raster raster(20, 20);
  raster.add_capsule({10, -5, 0}, {10, 25, 0}, 3, 0);
  for(const double z : {-10., 10.}) {
    Triangle_soup soup;
    soup.points = {{-50, -50, z}, {100, -50, z}, {-50, 100, z}};
    soup.triangles = {{0, 1, 2}};
    raster.add_surface(soup, std::vector<Vector>(3, Vector::UnitZ()));
  }
  const auto &on = raster.sample(10, 10), &off = raster.sample(1, 10);
  EXPECT_GT(on.in_front, 0);
  EXPECT_FLOAT_EQ(on.in_front, on.behind);
  EXPECT_FLOAT_EQ(off.in_front + off.behind, on.in_front + on.behind);
}

// A triangle in a tetrahedron, both scaled.
std::string picture_of_size(double s)
{
  using Point = Kernel::Point_3;
  const Curve curve({{-s, -s, 0}, {s, -s, 0}, {0, s, s}}, {{0, 1}, {1, 2}, {2, 0}});
  Mesh mesh;
  CGAL::make_tetrahedron(Point(-3 * s, -2 * s, -s), Point(0, -2 * s, 4 * s),
                         Point(3 * s, -2 * s, -s), Point(0, 4 * s, 0), mesh);
  return png_picture(curve, mesh);
}

std::size_t number_of_colors(const Rgb_image& image)
{
  std::vector<std::uint32_t> colors;
  for(std::size_t i = 0; i < image.bytes.size(); i += 3)
    colors.push_back(static_cast<std::uint32_t>(image.bytes[i] << 16 | image.bytes[i + 1] << 8 |
                                                image.bytes[i + 2]));
  std::sort(colors.begin(), colors.end());
  return static_cast<std::size_t>(std::unique(colors.begin(), colors.end()) - colors.begin());
}

TEST(Png_picture, does_not_depend_on_the_size)
{
  const Rgb_image picture = read_png(picture_of_size(1));
  EXPECT_EQ(picture.width, 800u);
  EXPECT_EQ(picture.height, 800u);
  EXPECT_GT(number_of_colors(picture), 1000u) << "shades of a tube behind glass";
  EXPECT_EQ(picture.bytes, read_png(picture_of_size(0x1p-30)).bytes);
}

TEST(Png_picture, of_nothing_is_white)
{
  const Rgb_image picture = read_png(png_picture(Curve()));
  EXPECT_EQ(picture.bytes, std::vector<std::uint8_t>(3 * 800 * 800, 255));
}

} // namespace test_png_pictures
