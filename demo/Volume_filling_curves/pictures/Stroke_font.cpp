// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Stroke_font.h"

#include <cstddef>

namespace vfc {
namespace {

// Strokes are chains of grid points, two digits for x and y; y points downwards. Characters stand
// on y = 6. Digits reach up to y = 0, small letters to y = 2.
struct Glyph
{
  char character;
  double width;
  const char* strokes;
};

constexpr double rows = 6; // of a digit

constexpr Glyph glyphs[] = {
    {' ', 2, ""},
    {'#', 4, "11 15,31 35,02 42,04 44"},
    {'*', 3, "11 33,31 13,10 34"},
    {'+', 4, "04 44,22 26"},
    {'-', 3, "04 34"},
    {'.', 1, "06 06"},
    {'0', 4, "10 30 41 45 36 16 05 01 10"},
    {'1', 4, "12 30 36"},
    {'2', 4, "01 10 30 41 42 06 46"},
    {'3', 4, "01 10 30 41 42 33 13,33 44 45 36 16 05"},
    {'4', 4, "36 30 04 44"},
    {'5', 4, "40 00 03 12 32 43 45 36 16 05"},
    {'6', 4, "41 30 10 01 05 16 36 45 44 33 13 04"},
    {'7', 4, "00 40 16"},
    {'8', 4, "13 02 01 10 30 41 42 33 13 04 05 16 36 45 44 33"},
    {'9', 4, "05 16 36 45 41 30 10 01 02 13 33 42"},
    {'_', 3, "06 36"},
    {'a', 3, "12 22 33 36,34 14 05 16 26 35"},
    {'c', 3, "33 22 12 03 05 16 26 35"},
    {'d', 3, "30 36,33 22 12 03 05 16 26 35"},
    {'e', 3, "04 34 33 22 12 03 05 16 26 35"},
    {'g', 3, "32 37 28 18 07,33 22 12 03 05 16 26 35"},
    {'h', 3, "00 06,03 12 22 33 36"},
    {'i', 0, "02 06,00 00"},
    {'k', 3, "00 06,32 04,14 36"},
    {'l', 0, "00 06"},
    {'m', 4, "02 06,03 12 22 26,23 32 43 46"},
    {'n', 3, "02 06,03 12 22 33 36"},
    {'p', 3, "02 08,03 12 22 33 35 26 16 05"},
    {'r', 2, "02 06,03 12 22"},
    {'s', 3, "33 22 12 03 14 24 35 26 16 05"},
    {'t', 2, "10 15 26,02 22"},
    {'u', 3, "02 05 16 26 35,32 36"},
    {'v', 4, "02 26 42"},
};
constexpr double gap = 1.6; // between characters

const Glyph& glyph_of(char character)
{
  for(const Glyph& glyph : glyphs)
    if(glyph.character == character) return glyph;
  return glyphs[0];
}

} // namespace

std::vector<Segment_2> text_strokes(const std::string& text,
                                    const Eigen::Vector2d& start,
                                    double size)
{
  const double unit = size / rows;
  std::vector<Segment_2> strokes;
  Eigen::Vector2d pen = start;
  for(const char character : text) {
    const Glyph& glyph = glyph_of(character);
    const std::string chain = glyph.strokes;
    const auto point = [&](std::size_t i) {
      return Eigen::Vector2d(pen +
                             unit * Eigen::Vector2d(chain[i] - '0', chain[i + 1] - '0' - rows));
    };
    for(std::size_t i = 0; i + 4 < chain.size(); i += 3)
      if(chain[i + 2] == ' ') strokes.push_back({point(i), point(i + 3)});
    pen.x() += unit * (glyph.width + gap);
  }
  return strokes;
}

double text_width(const std::string& text, double size)
{
  double width = 0;
  for(const char character : text) width += size / rows * (glyph_of(character).width + gap);
  return width;
}

} // namespace vfc
