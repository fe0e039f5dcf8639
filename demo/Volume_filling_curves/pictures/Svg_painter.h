// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_SVG_PAINTER_H
#define VFC_SVG_PAINTER_H

#include "pictures/Stroke_layers.h"
#include "pictures/Tube_colors.h"

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace vfc {

// Painter of layers of strokes as elements of an SVG file. A tube is a dark stroke, a lighter one
// over it and a light line in the middle; white strokes below them leave the gaps at crossings.
// Runs of one layer, color and shade form one path element, which the three strokes share. Shades
// range from pale in the back to full in the front.
class Svg_painter
{
public:
  Svg_painter(const Stroke_layers& layers,
              const Drawn_curve& curve,
              const Tube_colors& colors,
              std::ostream& out);

  // Writes the paths, which several strokes share, and then the strokes.
  void define_runs() const;
  void paint() const;

private:
  using Key = std::array<std::size_t, 4>; // layer, level of the color, shade, and 1 for ends

  struct Run
  {
    Key key;
    std::string path, overlaps;
  };

  enum class Tint
  {
    DARK,
    PLAIN,
    LIGHT
  };

  Key key_of(const Stroke_piece& piece) const;
  void collect_runs();
  void collect_gaps();
  void append_overlaps(std::size_t first, std::size_t last, double extent, std::string& path) const;
  std::vector<Vector> points_from(std::size_t i, bool is_forward, double length) const;
  void append_to_other_layer(std::size_t i,
                             bool is_forward,
                             double extent,
                             std::string Run::*path,
                             std::map<Key, Run>& runs) const;
  void append_points(std::size_t first, std::size_t last, std::string& path) const;
  void collect_ends();
  void paint_layer(std::size_t first, std::size_t last) const;
  void stroke(std::size_t first, std::size_t last, double width, Tint tint) const;
  std::string color(const Key& key, Tint tint) const;

  const std::vector<Stroke_piece>& m_pieces;
  const Drawn_curve& m_curve;
  const Tube_colors& m_colors;
  const double m_width;
  std::ostream& m_out;
  double m_back = std::numeric_limits<double>::infinity();
  double m_front = -std::numeric_limits<double>::infinity();
  std::vector<Run> m_runs;
  std::map<std::size_t, std::string> m_gaps; // the white strokes, by layer
};

} // namespace vfc

#endif // VFC_SVG_PAINTER_H
