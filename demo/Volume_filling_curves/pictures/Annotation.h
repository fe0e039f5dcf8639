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

// Texts and marks over a picture, in picture coordinates.
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
    double x, y; // where the base line starts
    double size; // of a digit, in height
  };

  std::vector<Box> boxes;
  std::vector<Text> texts;
};

// Legend of a scale, at the right of a picture of that size: its colors, numbers and their meaning.
Annotation legend(const Color_scale& scale, Coloring coloring, const Eigen::Vector2d& size);

// Numbers of nodes beside them. Where space does not suffice, the nodes nearest to the viewer are
// labeled. O(n log n).
Annotation node_labels(const Drawn_curve& curve, const Eigen::Vector2d& size);

void write_svg(const Annotation& annotation, std::ostream& out);

// Paints on a picture whose pixels are `pixel` picture units wide.
void paint(const Annotation& annotation, double pixel, Rgb_image& image);

} // namespace vfc

#endif // VFC_ANNOTATION_H
