// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Curve_view.h"

#include "pictures/cuts.h"

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

// Returns a frame with y up, or with x to the right if the view is along y.
Eigen::Matrix3d upright_frame(const Vector& direction)
{
  const Vector front = direction.normalized();
  const Vector across = Vector::UnitY().cross(front);
  constexpr double steep = 1e-6;
  Eigen::Matrix3d frame;
  frame.row(0) = across.norm() > steep ? Vector(across.normalized()) : Vector(Vector::UnitX());
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
  // without its scale: eigenvectors of scaled matrices differ by rounding
  const double scale = covariance.trace();
  if(!(scale > 0)) return Eigen::Matrix3d::Identity();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / scale);
  return frame_of(solver.eigenvectors());
}

} // namespace

Curve_view::Curve_view(const Curve& curve, const Triangle_soup& surface, const Options& options)
    : m_surface(surface)
{
  const bool has_surface = !surface.triangles.empty();
  const Vector usual_direction(0.45, 0.35, 1);
  m_frame = options.direction || has_surface
                ? upright_frame(options.direction.value_or(usual_direction))
                : principal_frame(curve);
  fit(curve, options);
  place_all(curve);
  const double width =
      has_surface
          ? width_per_distance * std::sqrt(m_surface.volume() / (std::max)(length(curve, 3), 1.))
          : covered_share * options.size.prod() / (std::max)(length(curve, 2), 1.);
  m_width = options.tube > 0 ? (std::max)(2 * options.tube * m_scale, min_width)
                             : std::clamp(width, min_width, max_width);
}

Vector Curve_view::place(const Vector& p) const
{
  const Vector q = m_scale * (m_frame * p - m_center);
  return {m_middle.x() + q.x(), m_middle.y() - q.y(), q.z()};
}

Plane Curve_view::place(const Plane& plane) const
{
  Vector normal = m_frame * plane.normal.normalized();
  normal.y() = -normal.y();
  const Vector on_plane = plane.offset / plane.normal.squaredNorm() * plane.normal;
  return {normal, normal.dot(place(on_plane))};
}

void Curve_view::scale(double factor)
{
  for(auto* points : {&m_points, &m_surface.points})
    for(Vector& p : *points) p *= factor;
  m_width *= factor;
  m_middle *= factor;
  m_scale *= factor;
}

// Determines position and scale, so that everything fits into the picture beside the legend.
void Curve_view::fit(const Curve& curve, const Options& options)
{
  const Eigen::AlignedBox3d drawn = box(curve, options.cut);
  if(drawn.isEmpty()) return;
  const Eigen::Vector2d legend(options.has_legend ? legend_width : 0, 0);
  const Eigen::Vector2d room = options.size - Eigen::Vector2d::Constant(2 * view_margin) - legend;
  const Eigen::Vector2d size = drawn.sizes().head<2>().array() + 2 * options.tube;
  if(size.maxCoeff() > 0) m_scale = 1 / size.cwiseQuotient(room).maxCoeff();
  m_center = drawn.center();
  m_middle = Vector(view_margin + room.x() / 2, options.size.y() / 2, 0);
}

// Returns the box, in the frame, of the drawn parts: all, or those that a cut leaves.
Eigen::AlignedBox3d Curve_view::box(const Curve& curve, const std::optional<Plane>& cut) const
{
  std::optional<Half_space> kept;
  if(cut) kept = side_kept({m_frame * cut->normal.normalized(), cut->offset / cut->normal.norm()});
  Eigen::AlignedBox3d result;
  const auto add = [&](const Vector& p, const Vector& q) {
    const double above_p = kept ? kept->height(p) : 0, above_q = kept ? kept->height(q) : 0;
    if(above_p <= 0) result.extend(p);
    if(above_q <= 0) result.extend(q);
    if((above_p <= 0) != (above_q <= 0)) result.extend(p + above_p / (above_p - above_q) * (q - p));
  };
  const auto point = [&](std::size_t v) -> Vector { return m_frame * to_vector(curve.point(v)); };
  for_each_edge(curve, point, add);
  for(const auto& triangle : m_surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      add(m_frame * m_surface.points[triangle[k]],
          m_frame * m_surface.points[triangle[(k + 1) % 3]]);
  return result;
}

void Curve_view::place_all(const Curve& curve)
{
  m_points.reserve(curve.number_of_nodes());
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    m_points.push_back(place(to_vector(curve.point(v))));
  for(Vector& p : m_surface.points) p = place(p);
}

// returns the length of the curve in space, or in the plane of the picture
double Curve_view::length(const Curve& curve, Eigen::Index dimension) const
{
  double sum = 0;
  for_each_edge(
      curve, [&](std::size_t v) { return m_points[v]; },
      [&](const Vector& p, const Vector& q) {
        const Vector edge = q - p; // g++ 12 warns of head(dimension)
        sum += dimension == 2 ? edge.head<2>().norm() : edge.norm();
      });
  return sum;
}

} // namespace vfc
