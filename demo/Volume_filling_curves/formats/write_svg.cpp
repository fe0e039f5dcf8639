// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "formats/writers.h"

#include <CGAL/Volume_filling_curves/internal/text/number_text.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>

namespace vfc {
namespace {

using CGAL::Volume_filling_curves::internal::append_number;

constexpr double margin = 0.02;       // around the curve, of the larger side
constexpr double stroke_width = 2e-3; // likewise

std::string numbers(std::initializer_list<double> values)
{
  std::string text;
  for(const double value : values) append_number(text += text.empty() ? "" : " ", value);
  return text;
}

} // namespace

// The y axis of SVG points down.
std::string to_svg(const Curve_paths& curve)
{
  CGAL::Bbox_3 box;
  for(const auto& p : curve.points) box += CGAL::Bbox_3(p[0], -p[1], 0, p[0], -p[1], 0);
  const double size = (std::max)(box.x_span(), box.y_span()), space = margin * size;
  const double width = box.x_span() + 2 * space, height = box.y_span() + 2 * space;
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + numbers({width}) +
                     "mm\" height=\"" + numbers({height}) + "mm\" viewBox=\"" +
                     numbers({box.xmin() - space, box.ymin() - space, width, height}) +
                     "\">\n<g fill=\"none\" stroke=\"black\" stroke-width=\"" +
                     numbers({stroke_width * size}) + "\">\n";
  for(const auto& path : curve.paths) {
    const bool is_closed = path.size() > 1 && path.front() == path.back();
    text += is_closed ? "<polygon points=\"" : "<polyline points=\"";
    for(std::size_t i = 0; i + (is_closed ? 1 : 0) < path.size(); ++i)
      text += numbers({curve.points[path[i]][0], 0 - curve.points[path[i]][1]}) + '\n';
    text += "\"/>\n";
  }
  return text + "</g>\n</svg>\n";
}

} // namespace vfc
