// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Annotation.h"

#include "options/numbers.h"
#include "pictures/Stroke_font.h"
#include "pictures/svg_number.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>

namespace vfc {
namespace {

constexpr double text_size = 13;
constexpr Color text_ink{34, 40, 49};

struct Title
{
  std::string name, unit;
};

Title title_of(Coloring coloring)
{
  switch(coloring) {
  case Coloring::ARCLENGTH:
    return {"arclength", "in units"};
  case Coloring::CURVATURE:
    return {"curvature", "per unit"};
  case Coloring::RADIUS:
    return {"radius", "in units"};
  case Coloring::THICKNESS:
    return {"thickness", "in units"};
  case Coloring::COMPONENT:
    break;
  }
  return {};
}

// Space for labels: the cells, as high as a line of text, that no label occupies.
class Free_space
{
public:
  // Returns whether there is space for the label, and occupies it.
  bool take(double x, double y, double width)
  {
    std::set<Cell> wanted;
    for(long i = cell(x); i <= cell(x + width); ++i)
      for(long j = cell(y - text_size); j <= cell(y); ++j) wanted.insert({i, j});
    const auto is_taken = [&](const Cell& cell) { return m_taken.count(cell) > 0; };
    if(std::any_of(wanted.begin(), wanted.end(), is_taken)) return false;
    m_taken.insert(wanted.begin(), wanted.end());
    return true;
  }

private:
  using Cell = std::pair<long, long>;

  static long cell(double x) { return std::lround(std::floor(x / text_size)); }

  std::set<Cell> m_taken;
};

void blend(Rgb_image& image, std::size_t x, std::size_t y, const Color& color, double share)
{
  for(std::size_t k = 0; k < 3; ++k) {
    std::uint8_t& channel = image.bytes[3 * (y * image.width + x) + k];
    channel = static_cast<std::uint8_t>(std::lround(channel + share * (color[k] - channel)));
  }
}

// Calls f(x, y) for the pixels of a rectangle that are in the image.
template <typename Function>
void for_each_pixel(const Rgb_image& image,
                    const Eigen::AlignedBox2d& box,
                    const Function& function)
{
  const auto clamped = [](double x, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(x, 0., static_cast<double>(size)));
  };
  const Eigen::Vector2d low = box.min(), high = box.max();
  for(std::size_t y = clamped(std::floor(low.y()), image.height);
      y < clamped(std::ceil(high.y()), image.height); ++y)
    for(std::size_t x = clamped(std::floor(low.x()), image.width);
        x < clamped(std::ceil(high.x()), image.width); ++x)
      function(x, y);
}

void paint_box(const Annotation::Box& box, double pixel, Rgb_image& image)
{
  const Eigen::Vector2d low(std::round(box.x / pixel), std::round(box.y / pixel));
  const Eigen::Vector2d high(std::round((box.x + box.width) / pixel),
                             std::round((box.y + box.height) / pixel));
  for_each_pixel(image, {low, high},
                 [&](std::size_t x, std::size_t y) { blend(image, x, y, box.color, 1); });
}

void paint_stroke(const Segment_2& stroke, double width, const Color& color, Rgb_image& image)
{
  const Eigen::Vector2d d = stroke[1] - stroke[0], margin(width, width);
  Eigen::AlignedBox2d box(stroke[0]);
  box.extend(stroke[1]);
  box.extend(Eigen::Vector2d(box.min() - margin));
  box.extend(Eigen::Vector2d(box.max() + margin));
  for_each_pixel(image, box, [&](std::size_t x, std::size_t y) {
    const Eigen::Vector2d p =
        Eigen::Vector2d(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5) - stroke[0];
    const double t = d.squaredNorm() > 0 ? std::clamp(p.dot(d) / d.squaredNorm(), 0., 1.) : 0;
    const double share = std::clamp(width / 2 + 0.5 - (p - t * d).norm(), 0., 1.);
    if(share > 0) blend(image, x, y, color, share);
  });
}

// Paints text in text_ink with a white halo, readable on every color.
void paint_text(const Annotation::Text& text, double pixel, Rgb_image& image)
{
  constexpr double stroke_width = 0.12, halo_width = 0.5; // of the size
  const double size = text.size / pixel;
  const auto strokes = text_strokes(text.text, {text.x / pixel, text.y / pixel}, size);
  for(const Segment_2& stroke : strokes)
    paint_stroke(stroke, halo_width * size, {255, 255, 255}, image);
  for(const Segment_2& stroke : strokes) paint_stroke(stroke, stroke_width * size, text_ink, image);
}

} // namespace

Annotation legend(const Color_scale& scale, Coloring coloring, const Eigen::Vector2d& size)
{
  constexpr double height = 560, width = 22, gap = 8;
  const double left = size.x() - Curve_view::legend_width + 10, top = (size.y() - height) / 2 + 10;
  constexpr int steps = 140;
  const auto [name, unit] = title_of(coloring);
  Annotation result;
  for(int k = 0; k < steps; ++k)
    result.boxes.push_back({left, top + height * k / steps, width, height / steps,
                            scale_color(1 - (k + 0.5) / steps)});
  result.texts.push_back({name, left, top - 3.6 * text_size, text_size});
  result.texts.push_back({unit, left, top - 1.9 * text_size, text_size});
  for(const double tick : scale.ticks()) {
    const double y = top + height * (1 - scale.share(tick));
    result.boxes.push_back({left + width, y - 0.5, gap - 2, 1, text_ink});
    result.texts.push_back({to_text(tick), left + width + gap, y + text_size / 2, text_size});
  }
  return result;
}

Annotation node_labels(const Drawn_curve& curve, const Eigen::Vector2d& size)
{
  std::vector<bool> is_drawn(curve.points.size(), false);
  for(const Drawn_edge& edge : curve.edges) is_drawn[edge.source] = is_drawn[edge.target] = true;
  std::vector<std::size_t> nearest_first(curve.points.size());
  std::iota(nearest_first.begin(), nearest_first.end(), std::size_t(0));
  std::stable_sort(nearest_first.begin(), nearest_first.end(), [&](std::size_t v, std::size_t w) {
    return curve.points[v].z() > curve.points[w].z();
  });
  Annotation result;
  Free_space space;
  for(const std::size_t v : nearest_first) {
    if(!is_drawn[v] || curve.numbers[v] == 0) continue;
    const std::string text = std::to_string(curve.numbers[v]);
    const double width = text_width(text, text_size);
    const double x = (std::min)(curve.points[v].x() + curve.width / 2, size.x() - width);
    const double y = curve.points[v].y() - curve.width / 2;
    if(space.take(x, y, width)) result.texts.push_back({text, x, y, text_size});
  }
  return result;
}

void write_svg(const Annotation& annotation, std::ostream& out)
{
  out << "<g shape-rendering=\"crispEdges\">";
  for(const Annotation::Box& box : annotation.boxes)
    out << "<rect x=\"" << svg_number(box.x) << "\" y=\"" << svg_number(box.y) << "\" width=\""
        << svg_number(box.width) << "\" height=\"" << svg_number(box.height) << "\" fill=\""
        << svg_color(box.color) << "\"/>";
  constexpr double font_size_per_digit = 1.4; // of most fonts without serifs
  out << "</g>\n<g font-family=\"sans-serif\" font-size=\""
      << svg_number(font_size_per_digit * text_size) << "\" fill=\"" << svg_color(text_ink)
      << "\" stroke=\"#fff\" stroke-width=\"4\" paint-order=\"stroke\">\n";
  for(const Annotation::Text& text : annotation.texts)
    out << "<text x=\"" << svg_number(text.x) << "\" y=\"" << svg_number(text.y) << "\">"
        << text.text << "</text>\n";
  out << "</g>\n";
}

void paint(const Annotation& annotation, double pixel, Rgb_image& image)
{
  for(const Annotation::Box& box : annotation.boxes) paint_box(box, pixel, image);
  for(const Annotation::Text& text : annotation.texts) paint_text(text, pixel, image);
}

} // namespace vfc
