// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Color_scale.h"
#include "pictures/Scene_raster.h"
#include "pictures/curve_pictures.h"
#include "pictures/cuts.h"
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
  raster.add({a, b, 5, {7, 9}});
  for(std::size_t y = 0; y < 40; ++y)
    for(std::size_t x = 0; x < 40; ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
      double highest = -1e9, value = 0; // by trying many balls
      for(int i = 0; i <= 4000; ++i) {
        const Vector c = a + i / 4000. * (b - a);
        const double rise2 = 25 - (px - c.x()) * (px - c.x()) - (py - c.y()) * (py - c.y());
        if(rise2 < 0 || c.z() + std::sqrt(rise2) < highest) continue;
        highest = c.z() + std::sqrt(rise2);
        value = 7 + 2 * (i / 4000.);
      }
      ASSERT_EQ(sample.has_tube(), highest > -1e9) << x << ' ' << y;
      if(!sample.has_tube()) continue;
      EXPECT_NEAR(sample.depth, highest, 1e-3);
      EXPECT_NEAR(sample.value, value, 0.05);
    }
}

// A ball of many around the segment is left where the half-space is.
TEST(Scene_raster, cuts_a_capsule_and_shows_its_section)
{
  Scene_raster raster(40, 40);
  const Vector a(10, 20, 3), b(30, 20, 13);
  const Half_space half_space{Vector(0.6, 0, 0.8), 19};
  raster.set_cut(half_space);
  raster.add({a, b, 5});
  std::size_t sections = 0, tubes = 0;
  for(std::size_t y = 0; y < 40; ++y)
    for(std::size_t x = 0; x < 40; ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
      double highest = -1e9; // by trying many points of the ray
      for(double z = -10; z < 30; z += 1e-2) {
        const Vector p(px, py, z), d = b - a;
        const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0., 1.);
        if((p - a - t * d).norm() <= 5 && half_space.height(p) <= 0) highest = z;
      }
      const bool is_met = highest > -1e9;
      if(is_met != sample.has_tube()) {
        EXPECT_NEAR(std::abs(py - 20), 5, 0.5) << "only where the ray grazes the capsule";
        continue;
      }
      if(!is_met) continue;
      EXPECT_NEAR(sample.depth, highest, 0.02);
      const bool is_section = sample.part == Scene_raster::Part::SECTION;
      ++(is_section ? sections : tubes);
      if(is_section) {
        EXPECT_NEAR(half_space.height({px, py, sample.depth}), 0, 1e-4);
      }
    }
  EXPECT_GT(sections, 10u);
  EXPECT_GT(tubes, 100u);
}

// Where two capsules overlap in the plane, rounding does not decide which of them is seen.
TEST(Scene_raster, shows_sections_without_a_pattern)
{
  Scene_raster raster(40, 40);
  raster.set_cut({Vector(0.1, 0.2, 1).normalized(), 4});
  for(const double value : {1., 2.}) raster.add({{5, 20, 3}, {35, 20, 0}, 8, {value, value}});
  std::size_t sections = 0;
  for(std::size_t y = 0; y < 40; ++y)
    for(std::size_t x = 0; x < 40; ++x) {
      const Scene_raster::Sample& sample = raster.sample(x, y);
      if(sample.part != Scene_raster::Part::SECTION) continue;
      ++sections;
      EXPECT_EQ(sample.value, 1) << x << ' ' << y;
    }
  EXPECT_GT(sections, 100u);
}

TEST(Scene_raster, adds_surfaces_before_and_behind_the_tube)
{
  Scene_raster raster(20, 20);
  raster.add({{10, -5, 0}, {10, 25, 0}, 3});
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

// Each of the scale's colors is somewhere at the right, where there is nothing without a scale.
TEST(Png_picture, has_the_size_and_the_scale_that_are_asked_for)
{
  const Curve curve({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 1, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  Picture_options options;
  options.pixels = {400, 400};
  for(const auto coloring : {Coloring::COMPONENT, Coloring::ARCLENGTH}) {
    options.coloring = coloring;
    const Rgb_image picture = read_png(png_picture(curve, Mesh(), options));
    ASSERT_EQ(picture.width, 400u);
    ASSERT_EQ(picture.height, 400u);
    for(const double share : {0.1, 0.5, 0.9}) {
      const Color color = scale_color(share);
      bool is_there = false;
      for(std::size_t y = 0; y < 400; ++y)
        for(std::size_t x = 340; x < 400; ++x) {
          double distance = 0;
          for(std::size_t k = 0; k < 3; ++k)
            distance += std::abs(picture.bytes[3 * (400 * y + x) + k] - color[k]);
          is_there = is_there || distance < 8;
        }
      EXPECT_EQ(is_there, coloring == Coloring::ARCLENGTH) << share;
    }
  }
}

TEST(Png_picture, of_nothing_is_white)
{
  const Rgb_image picture = read_png(png_picture(Curve()));
  EXPECT_EQ(picture.bytes, std::vector<std::uint8_t>(3 * 800 * 800, 255));
}

} // namespace test_png_pictures
