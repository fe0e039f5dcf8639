// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "arc_files/arc_writers.h"
#include "options/numbers.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <stdexcept>

namespace vfc {
namespace {

using Point = Curve::Point_3;
using Piece = CGAL::Volume_filling_curves::Arc_spline_piece<Point>;
using Path = CGAL::Volume_filling_curves::Arc_spline_path<Point>;

constexpr double margin = 0.02;       // around the curve, of the larger side
constexpr double stroke_width = 2e-3; // likewise

// The y axis of SVG points down.
std::string coordinate_pair(const Point& p)
{
  return to_exact_text(p.x()) + ' ' + to_exact_text(0 - p.y());
}

// Seen with y up, clockwise is what SVG calls the sweep 1.
bool is_clockwise(const Piece& arc)
{
  const Point &a = arc.start, &b = arc.corner, &c = arc.end;
  return (b.x() - a.x()) * (c.y() - b.y()) < (b.y() - a.y()) * (c.x() - b.x());
}

std::string command(const Piece& piece)
{
  if(!piece.is_arc()) return "L" + coordinate_pair(piece.end);
  const std::string radius = to_exact_text(piece.radius);
  return "A" + radius + ' ' + radius + " 0 0 " + (is_clockwise(piece) ? '1' : '0') + ' ' +
         coordinate_pair(piece.end);
}

std::string path_element(const Path& path)
{
  std::string text = "<path d=\"M" + coordinate_pair(path.pieces.front().start);
  for(const Piece& piece : path.pieces) text += '\n' + command(piece);
  return text + (path.is_closed ? "Z" : "") + "\"/>\n";
}

// An arc lies in the triangle of its ends and its corner.
CGAL::Bbox_3 box_of(const Arcs& arcs)
{
  CGAL::Bbox_3 box;
  for(const Path& path : arcs.paths)
    for(const Piece& piece : path.pieces)
      for(const Point& p : {piece.start, piece.corner, piece.end}) box += p.bbox();
  return box;
}

// meters are unknown to SVG
std::string side(double length, Length_unit unit)
{
  if(unit == Length_unit::METER) return to_exact_text(1000 * length) + "mm";
  return to_exact_text(length) + (unit == Length_unit::INCH ? "in" : to_string(unit));
}

std::string head(const CGAL::Bbox_3& box, Length_unit unit)
{
  const double size = (std::max)(box.x_span(), box.y_span()), space = margin * size;
  const double width = box.x_span() + 2 * space, height = box.y_span() + 2 * space;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + side(width, unit) + "\" height=\"" +
         side(height, unit) + "\" viewBox=\"" + to_exact_text(box.xmin() - space) + ' ' +
         to_exact_text(-box.ymax() - space) + ' ' + to_exact_text(width) + ' ' +
         to_exact_text(height) + "\">\n<g fill=\"none\" stroke=\"black\" stroke-width=\"" +
         to_exact_text(stroke_width * size) + "\">\n";
}

} // namespace

std::string to_svg(const Arcs& arcs, Length_unit unit)
{
  if(arcs.paths.empty()) throw std::invalid_argument("the curve is empty");
  const CGAL::Bbox_3 box = box_of(arcs);
  if(box.zmin() != box.zmax())
    throw std::invalid_argument("SVG is for planar curves, but z goes from " + to_text(box.zmin()) +
                                " to " + to_text(box.zmax()));
  std::string text = head(box, unit);
  for(const Path& path : arcs.paths) text += path_element(path);
  return text + "</g>\n</svg>\n";
}

} // namespace vfc
