// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_CURVE_VIEW_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_CURVE_VIEW_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box.h>
#include <CGAL/Volume_filling_curves/internal/Triangle_soup.h>
#include <CGAL/Volume_filling_curves/internal/strands.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A curve in picture coordinates: x to the right, y downwards, both within `picture_size`, and z
// towards the viewer in the same unit. The curve is seen along its shortest principal axis, where it
// covers least of itself, tilted a little so that parts right behind each other show; its longest
// axis runs from left to right. With a surface around it the curve is seen from the front, the right
// and above, where y is up, since many shapes stand upright so.
class Curve_view
{
public:
  static constexpr double picture_size = 800;

  template <typename Network>
  explicit Curve_view(const Network& curve)
  {
    add_curve(curve, viewing_frame(curve));
    fit();
    double length = 0;
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      length += (m_points[curve.target(e)] - m_points[curve.source(e)]).template head<2>().norm();
    m_width = std::clamp(covered_share * picture_size * picture_size / (std::max)(length, 1.),
                         min_width, max_width);
  }

  template <typename Network>
  Curve_view(const Network& curve, const Triangle_soup& surface) : m_surface(surface)
  {
    const Eigen::Matrix3d frame = upright_frame();
    add_curve(curve, frame);
    for(Vector& p : m_surface.points) p = frame * p;
    fit();
    double length = 0;
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      length += (m_points[curve.target(e)] - m_points[curve.source(e)]).norm();
    const double distance = std::sqrt(m_surface.volume() / (std::max)(length, 1.));
    m_width = std::clamp(width_per_distance * distance, min_width, max_width);
  }

  const Vector& point(std::size_t v) const { return m_points[v]; }

  // returns the surface in picture coordinates, where a face that is turned to the viewer is
  // oriented clockwise
  const Triangle_soup& surface() const { return m_surface; }

  // returns the width of the stroke with which the curve is drawn
  double width() const { return m_width; }

  // Multiplies all lengths in the picture.
  void scale(double factor)
  {
    for(auto* points : {&m_points, &m_surface.points})
      for(Vector& p : *points) p *= factor;
    m_width *= factor;
  }

private:
  static constexpr double margin = 32;        // around the curve, on all four sides
  static constexpr double covered_share = .2; // of the picture, by strokes
  static constexpr double min_width = 1, max_width = 28;
  static constexpr double width_per_distance = .5; // of strands that fill the surface evenly

  template <typename Network>
  void add_curve(const Network& curve, const Eigen::Matrix3d& frame)
  {
    m_points.reserve(curve.number_of_nodes());
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      m_points.push_back(frame * to_vector(curve.point(v)));
  }

  static Eigen::Matrix3d upright_frame()
  {
    const Vector front = Vector(0.45, 0.35, 1).normalized();
    Eigen::Matrix3d frame;
    frame.row(0) = Vector::UnitY().cross(front).normalized();
    frame.row(1) = front.cross(frame.row(0).transpose());
    frame.row(2) = front;
    return frame;
  }

  // returns a rotation whose rows are the directions to the right, up and to the viewer
  template <typename Network>
  static Eigen::Matrix3d viewing_frame(const Network& curve)
  {
    Vector sum = Vector::Zero();
    double length = 0;
    const auto for_each_edge = [&](const auto& f) {
      for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
        const Vector along = edge_vector(curve, e);
        f(to_vector(curve.point(curve.source(e))) + along / 2, along.norm());
      }
    };
    for_each_edge([&](const Vector& middle, double weight) {
      sum += weight * middle;
      length += weight;
    });
    if(!(length > 0)) return Eigen::Matrix3d::Identity();
    const Vector center = sum / length;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for_each_edge([&](const Vector& middle, double weight) {
      covariance += weight / length * (middle - center) * (middle - center).transpose();
    });
    // eigenvectors of scaled matrices differ in rounding, so the scale is taken out first
    const double scale = covariance.trace();
    if(!(scale > 0)) return Eigen::Matrix3d::Identity();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / scale);
    return frame_of(solver.eigenvectors());
  }

  // \pre the columns are the principal axes, the shortest first
  static Eigen::Matrix3d frame_of(const Eigen::Matrix3d& axes)
  {
    const auto oriented = [](const Vector& axis) -> Vector {
      Eigen::Index largest;
      axis.cwiseAbs().maxCoeff(&largest);
      return axis[largest] < 0 ? -axis : axis;
    };
    constexpr double tilt_sine = 0.2, tilt_cosine = 0.97979589711327124; // 12 degrees
    const Vector right = oriented(axes.col(2)), front = oriented(axes.col(0));
    const Vector up = front.cross(right);
    Eigen::Matrix3d frame;
    frame.row(0) = right;
    frame.row(1) = tilt_cosine * up + tilt_sine * front;
    frame.row(2) = tilt_cosine * front - tilt_sine * up;
    return frame;
  }

  void fit()
  {
    if(m_points.empty() && m_surface.points.empty()) return;
    Box box = Box::of(m_points.empty() ? m_surface.points.front() : m_points.front());
    for(const auto* points : {&m_points, &m_surface.points})
      for(const Vector& p : *points) box += p;
    const double size = (box.max - box.min).head<2>().maxCoeff();
    const double scale = size > 0 ? (picture_size - 2 * margin) / size : 1;
    const Vector center = (box.min + box.max) / 2;
    for(auto* points : {&m_points, &m_surface.points})
      for(Vector& p : *points) {
        p = scale * (p - center);
        p.x() = picture_size / 2 + p.x();
        p.y() = picture_size / 2 - p.y();
      }
  }

  std::vector<Vector> m_points;
  Triangle_soup m_surface;
  double m_width = min_width;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SVG_CURVE_VIEW_H
