// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_PREFILTER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_PREFILTER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The nodes of a ball, out of which those are sifted that a circle can touch: they lie in one of
// the spheres of some diameter D through the circle's node with their centers in its plane. At d
// from the node, of which h is across the plane,
//   |d|^2 <= D sqrt(|d|^2 - h^2).
// In a filling most do not. All are looked at, so that is done in single precision, four at a time,
// with a margin for the rounding.
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

  // Adds the nodes of the places first, ..., beyond - 1 that are in the ball.
  void add(std::size_t first, std::size_t beyond)
  {
    grow(m_size + beyond - first);
    const double *x = m_all.x(), *y = m_all.y(), *z = m_all.z();
    for(std::size_t k = first; k < beyond; ++k) {
      const Vector d = m_scale * (Vector(x[k], y[k], z[k]) - m_center);
      m_x[m_size] = static_cast<float>(d.x());
      m_y[m_size] = static_cast<float>(d.y());
      m_z[m_size] = static_cast<float>(d.z());
      m_places[m_size] = static_cast<std::uint32_t>(k);
      m_size += d.squaredNorm() <= slack ? 1 : 0;
    }
  }

  // Replaces the contents of `sifted` by the nodes that can be touched, and some more.
  // \pre the node is in the ball, and the diameter at most its radius
  void operator()(const Vector& node, const Vector& normal, double diameter, Node_list& sifted)
  {
    mark(m_scale * (node - m_center), normal, m_scale * diameter);
    std::size_t count = 0;
    for(std::size_t k = 0; k < m_size; ++k) {
      m_sifted[count] = m_places[k];
      count += m_marks[k];
    }
    sifted.clear();
    sifted.append(m_all, m_sifted, count);
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

  // Makes room for n nodes.
  void grow(std::size_t n)
  {
    if(n <= m_x.size()) return;
    n = (std::max)(n, 2 * m_x.size());
    for(auto* values : {&m_x, &m_y, &m_z}) values->resize(n);
    for(auto* values : {&m_places, &m_marks, &m_sifted}) values->resize(n);
  }

  const Node_list& m_all;
  Vector m_center;
  double m_scale = 0;
  std::size_t m_size = 0;
  std::vector<float> m_x, m_y, m_z;    // from the center, in units of the ball's radius
  std::vector<std::uint32_t> m_places; // among all nodes
  std::vector<std::uint32_t> m_marks;  // 1 for those that can be touched
  std::vector<std::uint32_t> m_sifted; // places of these
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_NODE_PREFILTER_H
