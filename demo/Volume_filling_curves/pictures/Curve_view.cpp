// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Curve_view.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace vfc {
namespace {

constexpr double view_margin = 32;   // around the curve, on all four sides
constexpr double covered_share = .2; // of the picture, by strokes
constexpr double min_width = 1, max_width = 28;
constexpr double width_per_distance = .5; // of strands that fill the surface evenly

// Calls f(source, target) for the points of every edge.
template <typename Point, typename Function>
void for_each_edge(const Curve& curve, const Point& point, const Function& f)
{
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    f(point(curve.source(e)), point(curve.target(e)));
}

Eigen::Matrix3d upright_frame()
{
  const Vector front = Vector(0.45, 0.35, 1).normalized();
  Eigen::Matrix3d frame;
  frame.row(0) = Vector::UnitY().cross(front).normalized();
  frame.row(1) = front.cross(frame.row(0).transpose());
  frame.row(2) = front;
  return frame;
}

// \pre the columns are the principal axes, the shortest first
Eigen::Matrix3d frame_of(const Eigen::Matrix3d& axes)
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

// returns a rotation whose rows are the directions to the right, up and to the viewer
Eigen::Matrix3d principal_frame(const Curve& curve)
{
  const auto point = [&](std::size_t v) { return to_vector(curve.point(v)); };
  Vector sum = Vector::Zero();
  double length = 0;
  for_each_edge(curve, point, [&](const Vector& source, const Vector& target) {
    const Vector along = target - source;
    sum += along.norm() * (source + along / 2);
    length += along.norm();
  });
  if(!(length > 0)) return Eigen::Matrix3d::Identity();
  const Vector center = sum / length;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for_each_edge(curve, point, [&](const Vector& source, const Vector& target) {
    const Vector along = target - source, arm = source + along / 2 - center;
    covariance += along.norm() / length * arm * arm.transpose();
  });
  // eigenvectors of scaled matrices differ in rounding, so the scale is taken out first
  const double scale = covariance.trace();
  if(!(scale > 0)) return Eigen::Matrix3d::Identity();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / scale);
  return frame_of(solver.eigenvectors());
}

} // namespace

Curve_view::Curve_view(const Curve& curve)
{
  add_curve(curve, principal_frame(curve));
  fit();
  double length = 0; // in the picture
  for_each_edge(
      curve, [&](std::size_t v) { return m_points[v]; },
      [&](const Vector& p, const Vector& q) { length += (q - p).head<2>().norm(); });
  const double area = covered_share * picture_size * picture_size;
  m_width = std::clamp(area / (std::max)(length, 1.), min_width, max_width);
}

Curve_view::Curve_view(const Curve& curve, const Triangle_soup& surface) : m_surface(surface)
{
  const Eigen::Matrix3d frame = upright_frame();
  add_curve(curve, frame);
  for(Vector& p : m_surface.points) p = frame * p;
  fit();
  double length = 0; // in space
  for_each_edge(
      curve, [&](std::size_t v) { return m_points[v]; },
      [&](const Vector& p, const Vector& q) { length += (q - p).norm(); });
  const double distance = std::sqrt(m_surface.volume() / (std::max)(length, 1.));
  m_width = std::clamp(width_per_distance * distance, min_width, max_width);
}

void Curve_view::scale(double factor)
{
  for(auto* points : {&m_points, &m_surface.points})
    for(Vector& p : *points) p *= factor;
  m_width *= factor;
}

void Curve_view::add_curve(const Curve& curve, const Eigen::Matrix3d& frame)
{
  m_points.reserve(curve.number_of_nodes());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    m_points.push_back(frame * to_vector(curve.point(v)));
}

void Curve_view::fit()
{
  if(m_points.empty() && m_surface.points.empty()) return;
  Eigen::AlignedBox3d box;
  for(const auto* points : {&m_points, &m_surface.points})
    for(const Vector& p : *points) box.extend(p);
  const double size = (box.max() - box.min()).head<2>().maxCoeff();
  const double scale = size > 0 ? (picture_size - 2 * view_margin) / size : 1;
  const Vector center = (box.min() + box.max()) / 2;
  for(auto* points : {&m_points, &m_surface.points})
    for(Vector& p : *points) {
      p = scale * (p - center);
      p.x() = picture_size / 2 + p.x();
      p.y() = picture_size / 2 - p.y();
    }
}

} // namespace vfc
