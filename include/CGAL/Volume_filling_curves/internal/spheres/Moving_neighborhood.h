// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MOVING_NEIGHBORHOOD_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MOVING_NEIGHBORHOOD_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_neighborhoods.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Prefilter of the nodes of a ball for those that the spheres of a circle can touch: they lie in
// one of the spheres of diameter D through the circle's node with centers in its plane. For a node
// at d, with the component h orthogonal to the plane, |d|^2 <= D sqrt(|d|^2 - h^2). In a filling
// most nodes fail. All nodes are tested, hence in single precision, four at a time, with a margin
// for rounding.
class Node_prefilter
{
public:
  explicit Node_prefilter(const Node_list& all) : m_all(all) {}

  // Begins with another ball.
  void start(const Vector& center, double radius)
  {
    m_center = center;
    m_scale = 1 / radius;
    m_size = 0;
  }

  // Adds the nodes with the indices first, ..., end - 1 that are in the ball.
  void add(std::size_t first, std::size_t end)
  {
    grow(m_size + end - first);
    const double *x = m_all.x(), *y = m_all.y(), *z = m_all.z();
    for(std::size_t k = first; k < end; ++k) {
      const Vector d = m_scale * (Vector(x[k], y[k], z[k]) - m_center);
      m_x[m_size] = static_cast<float>(d.x());
      m_y[m_size] = static_cast<float>(d.y());
      m_z[m_size] = static_cast<float>(d.z());
      m_numbers[m_size] = static_cast<std::uint32_t>(k);
      m_size += d.squaredNorm() <= slack ? 1 : 0;
    }
  }

  // Replaces the contents of `prefiltered` by the nodes that can be touched, and some more.
  // \pre the node is in the ball, and the diameter at most its radius
  void operator()(const Vector& node, const Vector& normal, double diameter, Node_list& prefiltered)
  {
    mark(m_scale * (node - m_center), normal, m_scale * diameter);
    std::size_t count = 0;
    for(std::size_t k = 0; k < m_size; ++k) {
      m_prefiltered_numbers[count] = m_numbers[k];
      count += m_marks[k];
    }
    prefiltered.clear();
    prefiltered.append(m_all, m_prefiltered_numbers, count);
  }

private:
  static constexpr double slack = 1 + 1e-12; // rounding

  // Coordinates are at most 1 and wrong by up to 1e-7, sides that are compared by up to 4e-6.
  static constexpr float margin = 1e-5F;

  void mark(const Vector& node, const Vector& normal, double diameter)
  {
    const auto px = static_cast<float>(node.x()), py = static_cast<float>(node.y()),
               pz = static_cast<float>(node.z());
    const auto nx = static_cast<float>(normal.x()), ny = static_cast<float>(normal.y()),
               nz = static_cast<float>(normal.z());
    const auto square = static_cast<float>(diameter * diameter);
    const float *x = m_x.data(), *y = m_y.data(), *z = m_z.data();
    std::uint32_t* const marks = m_marks.data();
    for(std::size_t k = 0, n = m_size; k < n; ++k) {
      const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
      const float d2 = dx * dx + dy * dy + dz * dz, h = dx * nx + dy * ny + dz * nz;
      marks[k] = d2 * d2 <= square * (d2 - h * h) + margin ? 1 : 0;
    }
  }

  // Reserves space for n nodes.
  void grow(std::size_t n)
  {
    if(n <= m_x.size()) return;
    n = (std::max)(n, 2 * m_x.size());
    for(auto* values : {&m_x, &m_y, &m_z}) values->resize(n);
    for(auto* values : {&m_numbers, &m_marks, &m_prefiltered_numbers}) values->resize(n);
  }

  const Node_list& m_all;
  Vector m_center;
  double m_scale = 0;
  std::size_t m_size = 0;
  std::vector<float> m_x, m_y, m_z;     // from the center, in units of the ball's radius
  std::vector<std::uint32_t> m_numbers; // among all nodes
  std::vector<std::uint32_t> m_marks;   // 1 for those that can be touched
  std::vector<std::uint32_t> m_prefiltered_numbers; // numbers of these
};

// Nodes that the spheres of a circle can touch, for successive circles along the curve: they are
// filtered from a ball that is larger than necessary, and also serves the next few circles (as
// Verlet 1967 does in time). It lies ahead, where these will be.
class Moving_neighborhood
{
public:
  explicit Moving_neighborhood(const Node_neighborhoods& all) : m_all(all), m_ball(all.nodes()) {}

  // returns all nodes in the spheres of some diameter that touch p with their centers in the plane
  // of the unit vector `normal`, and some more
  const Node_list& operator()(const Vector& p, const Vector& normal, double diameter)
  {
    if(!((p - m_center).norm() + diameter <= m_radius)) move_to(p, diameter);
    m_last = p;
    m_ball(p, normal, diameter, m_prefiltered);
    return m_prefiltered;
  }

private:
  // In units of the diameter. With the ball around p, skins of 0.25 and 0.4 took 2 % longer to find
  // all spheres of a filling; skins of 0.2 to 0.4 that lie ahead differ by 2 % (2026-11-23).
  static constexpr double skin = 0.25, ahead = 0.2;

  // Continues in the direction of the last step, if that was small.
  void move_to(const Vector& p, double diameter)
  {
    const Vector step = p - m_last;
    const double length = step.norm();
    m_center = p;
    if(length < skin * diameter) m_center += ahead * diameter * step.normalized();
    m_radius = (1 + skin) * diameter;
    m_ball.start(m_center, m_radius);
    m_all.for_each_run_near(m_center, m_radius,
                            [&](std::size_t first, std::size_t end) { m_ball.add(first, end); });
  }

  const Node_neighborhoods& m_all;
  Vector m_center, m_last;
  double m_radius = -1;
  Node_prefilter m_ball;
  Node_list m_prefiltered;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MOVING_NEIGHBORHOOD_H
