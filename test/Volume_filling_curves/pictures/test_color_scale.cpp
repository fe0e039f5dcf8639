// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Color_scale.h"
#include "pictures/Stroke_font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_color_scale {

using namespace vfc;

// From sRGB to CIELAB, with the matrix the other way round than in the program.
std::array<double, 3> to_lab(const Color& color)
{
  std::array<double, 3> c;
  for(std::size_t k = 0; k < 3; ++k) {
    const double x = color[k] / 255;
    c[k] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  const auto f = [](double t) {
    return t > 216. / 24389 ? std::cbrt(t) : (24389. / 27 * t + 16) / 116;
  };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.95047);
  const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
  const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Color_scale, has_colors_whose_differences_are_even)
{
  constexpr int steps = 40;
  std::vector<double> differences;
  for(int i = 0; i < steps; ++i) {
    const auto a = to_lab(scale_color(i / double(steps)));
    const auto b = to_lab(scale_color((i + 1) / double(steps)));
    EXPECT_GT(b[0], a[0]) << "lightness";
    differences.push_back(std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  const auto [least, largest] = std::minmax_element(differences.begin(), differences.end());
  EXPECT_GT(*least, 2) << "just noticeable";
  EXPECT_LT(*largest, 1.06 * *least);
}

TEST(Color_scale, ends_with_the_colors_of_its_ends)
{
  EXPECT_EQ(scale_color(-1), scale_color(0));
  EXPECT_EQ(scale_color(2), scale_color(1));
}

TEST(Color_scale, leaves_out_what_is_far_from_the_rest)
{
  std::vector<double> numbers(1000, 0);
  for(std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i);
  numbers.front() = -1e9;
  numbers.back() = 1e9;
  const Color_scale scale(numbers);
  EXPECT_NEAR(scale.least, 10, 1);
  EXPECT_NEAR(scale.largest, 990, 1);
  EXPECT_EQ(scale.share(-1e9), 0);
  EXPECT_EQ(scale.share(1e9), 1);
  EXPECT_NEAR(scale.share(500), 0.5, 1e-3);
}

TEST(Color_scale, has_round_numbers)
{
  for(const double size : {1e-30, 3e-4, 1., 7.3, 9.99, 2.5e8})
    for(const double least : {0., 0.37, -4.}) {
      const Color_scale scale({least * size, (least + 1) * size});
      const std::vector<double> ticks = scale.ticks();
      EXPECT_GE(ticks.size(), 3u);
      EXPECT_LE(ticks.size(), 8u);
      const double step = ticks[1] - ticks[0];
      const double digit = step / std::pow(10, std::floor(std::log10(step * 1.0001)));
      EXPECT_TRUE(std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 ||
                  std::abs(digit - 5) < 1e-6)
          << step;
      for(const double tick : ticks) {
        EXPECT_GE(tick, scale.least);
        EXPECT_LE(tick, scale.largest);
        EXPECT_NEAR(tick / step, std::round(tick / step), 1e-6);
      }
    }
}

TEST(Color_scale, of_one_number_has_it_in_the_middle)
{
  for(const double number : {0., 5., -2e-20}) {
    const Color_scale scale({number, number});
    EXPECT_NEAR(scale.share(number), number == 0 ? 0 : 0.5, 1e-9);
    EXPECT_GE(scale.ticks().size(), 3u);
  }
}

TEST(Stroke_font, has_what_legends_and_labels_say)
{
  for(const std::string text : {"arclength", "curvature", "radius", "thickness", "in", "units",
                                "per", "unit", "0123456789", "-1.5e+07"})
    for(const char character : text)
      EXPECT_FALSE(text_strokes(std::string(1, character), {0, 0}, 10).empty()) << character;
  EXPECT_TRUE(text_strokes(" ", {0, 0}, 10).empty());
}

TEST(Stroke_font, writes_from_left_to_right_on_the_line)
{
  double last = -1;
  for(const Segment_2& stroke : text_strokes("1111", {0, 100}, 12)) {
    EXPECT_LE(stroke[1].y(), 100);
    EXPECT_GE(stroke[0].y(), 88);
    last = std::max(last, stroke[1].x());
  }
  EXPECT_GT(last, text_width("111", 12));
  EXPECT_LT(last, text_width("1111", 12));
}

} // namespace test_color_scale
