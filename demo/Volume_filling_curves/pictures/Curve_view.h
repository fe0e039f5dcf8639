// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_VIEW_H
#define VFC_CURVE_VIEW_H

#include "pictures/Triangle_soup.h"

#include <cstddef>
#include <vector>

namespace vfc {

// A curve in picture coordinates: x to the right, y downwards, both within `picture_size`, and z
// towards the viewer in the same unit. The curve is seen along its shortest principal axis, where
// it covers least of itself, tilted a little so that parts right behind each other show; its
// longest axis runs from left to right. With a surface around it the curve is seen from the front,
// the right and above, where y is up, since many shapes stand upright so.
class Curve_view
{
public:
  static constexpr double picture_size = 800;

  explicit Curve_view(const Curve& curve);
  Curve_view(const Curve& curve, const Triangle_soup& surface);

  const Vector& point(std::size_t v) const { return m_points[v]; }

  // returns the surface in picture coordinates, where a face that is turned to the viewer is
  // oriented clockwise
  const Triangle_soup& surface() const { return m_surface; }

  // returns the width of the stroke with which the curve is drawn
  double width() const { return m_width; }

  // Multiplies all lengths in the picture.
  void scale(double factor);

private:
  void add_curve(const Curve& curve, const Eigen::Matrix3d& frame);
  void fit();

  std::vector<Vector> m_points;
  Triangle_soup m_surface;
  double m_width;
};

} // namespace vfc

#endif // VFC_CURVE_VIEW_H
