// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_ANNOTATION_H
#define VFC_ANNOTATION_H

#include "pictures/Curve_view.h"
#include "pictures/Drawn_curve.h"
#include "pictures/Tube_colors.h"
#include "pictures/png_file.h"

#include <Eigen/Core>

#include <ostream>
#include <string>
#include <vector>

namespace vfc {

// Texts and boxes on top of a picture, in picture coordinates.
struct Annotation
{
  struct Box
  {
    double x, y, width, height; // the upper left corner, and the size
    Color color;
  };

  struct Text
  {
    std::string text;
    double x, y; // the start of the base line
    double size; // the height of a digit
  };

  std::vector<Box> boxes;
  std::vector<Text> texts;
};

// Legend of a scale, at the right of a picture of this size: colors, numbers and their meaning.
Annotation legend(const Color_scale& scale, Coloring coloring, const Eigen::Vector2d& size);

// Labels of the nodes: their numbers. If space is short, the nodes nearest to the viewer are
// labeled. O(n log n).
Annotation node_labels(const Drawn_curve& curve, const Eigen::Vector2d& size);

void write_svg(const Annotation& annotation, std::ostream& out);

// Paints on a picture whose pixels are `pixel` picture units wide.
void paint(const Annotation& annotation, double pixel, Rgb_image& image);

} // namespace vfc

#endif // VFC_ANNOTATION_H
