// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_CURVE_VIEW_H
#define VFC_CURVE_VIEW_H

#include "pictures/Picture_options.h"
#include "pictures/Triangle_soup.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace vfc {

// A curve in picture coordinates: x to the right, y downwards, both within `picture_size`, and z
// towards the viewer in the same unit. The curve is seen along its shortest principal axis, where
// it hides least of itself, tilted a little to separate parts right behind each other; its longest
// axis runs from left to right. With a surface, or in a requested direction, y is up, since many
// shapes stand upright this way; without a request, a surface is seen from the front, the right and
// above.
class Curve_view
{
public:
  static constexpr double picture_size = 800;

  // Options of a view: a direction, and space for a legend at the right.
  struct Options
  {
    std::optional<Vector> direction;
    bool has_legend = false;
    std::optional<Plane> cut = std::nullopt; // the remainder fills the picture
    double tube = 0;                         // its radius; 0 for one that suits the picture
    Eigen::Vector2d size = {picture_size, picture_size}; // of the picture
  };

  static constexpr double legend_width = 130;

  explicit Curve_view(const Curve& curve) : Curve_view(curve, Triangle_soup(), Options()) {}
  Curve_view(const Curve& curve, const Triangle_soup& surface, const Options& options);

  const Vector& point(std::size_t v) const { return m_points[v]; }

  // Returns the surface in picture coordinates, where faces towards the viewer are oriented
  // clockwise.
  const Triangle_soup& surface() const { return m_surface; }

  // returns the width of the stroke with which the curve is drawn
  double width() const { return m_width; }

  // the position of a point, and of a plane, in the picture
  Vector place(const Vector& p) const;
  Plane place(const Plane& plane) const;

  // Multiplies all lengths in the picture.
  void scale(double factor);

private:
  void fit(const Curve& curve, const Options& options);
  Eigen::AlignedBox3d box(const Curve& curve, const std::optional<Plane>& cut) const;
  void place_all(const Curve& curve);
  double length(const Curve& curve, Eigen::Index dimension) const;

  Eigen::Matrix3d m_frame; // its rows are the directions to the right, up and to the viewer
  Vector m_center = Vector::Zero(), m_middle = Vector::Zero(); // in the frame, and in the picture
  double m_scale = 1, m_width = 1;
  std::vector<Vector> m_points;
  Triangle_soup m_surface;
};

} // namespace vfc

#endif // VFC_CURVE_VIEW_H
