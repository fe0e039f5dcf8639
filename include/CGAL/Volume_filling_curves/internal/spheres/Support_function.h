// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// What turns the search for the medial spheres of node i into arithmetic: under inversion at the
// node another node j, at d_j = node_j - node_i, goes to the image 2 d_j / |d_j|^2, and the sphere
// with its center in direction x_l is free as long as
//   1 / R >= max over j of x_l . 2 d_j / |d_j|^2,
// which is the support function of the images. Only their projections to the plane of the
// directions matter. Everything is in units of the cap r_max of the radii, where the cap itself is
// an image of length 1 in all directions. One array for each coordinate, so that loops take several
// nodes, or directions, at a time. Linear in the number of nodes, times N for those within reach.
class Support_function
{
public:
  using Index = Medial_spheres::Index;

  // the nodes that might matter, in any order; to be followed by load()
  std::vector<Index>& nodes() { return m_nodes; }

  void load(const Vector_field& positions)
  {
    const std::size_t n = m_nodes.size();
    for(auto* values : {&m_x, &m_y, &m_z, &m_u, &m_v, &m_squared_norm}) values->resize(n);
    for(std::size_t k = 0; k < n; ++k) {
      const Vector position = row(positions, m_nodes[k]);
      m_x[k] = position.x();
      m_y[k] = position.y();
      m_z[k] = position.z();
    }
  }

  void evaluate(const Vector& node,
                const Node_circle& circle,
                double cap,
                const Circle_directions& directions)
  {
    invert(node, circle, cap);
    m_support.assign(directions.size(), 1.); // the cap
    m_supporting.assign(directions.size(), none);
    for(std::size_t k = 0; k < m_nodes.size(); ++k)
      // Only images outside the unit circle lie beyond the cap in some direction. The node itself
      // and coincident ones have no image: their norm is not a number.
      if(m_squared_norm[k] > 1) add_image(k, directions);
  }

  // 1 / R in direction l, in units of 1 / cap
  double operator()(std::size_t l) const { return m_support[l]; }

  // returns whether a node supports direction l, and not just the cap
  bool is_supported(std::size_t l) const { return m_supporting[l] != none; }

  Index supporting_node(std::size_t l) const
  {
    return m_nodes[static_cast<std::size_t>(m_supporting[l])];
  }

private:
  static constexpr std::int64_t none = -1;

  void invert(const Vector& node, const Node_circle& circle, double cap)
  {
    const double *x = m_x.data(), *y = m_y.data(), *z = m_z.data();
    double *u = m_u.data(), *v = m_v.data(), *squared_norm = m_squared_norm.data();
    const Vector a = circle.u, b = circle.v;
    for(std::size_t k = 0, n = m_nodes.size(); k < n; ++k) {
      const double dx = x[k] - node.x(), dy = y[k] - node.y(), dz = z[k] - node.z();
      const double scale = 2 * cap / (dx * dx + dy * dy + dz * dz);
      u[k] = scale * (dx * a.x() + dy * a.y() + dz * a.z());
      v[k] = scale * (dx * b.x() + dy * b.y() + dz * b.z());
      squared_norm[k] = u[k] * u[k] + v[k] * v[k];
    }
  }

  void add_image(std::size_t k, const Circle_directions& directions)
  {
    const double u = m_u[k], v = m_v[k];
    const double *cosine = directions.cosine.data(), *sine = directions.sine.data();
    double* support = m_support.data();
    std::int64_t* supporting = m_supporting.data();
    const auto node = static_cast<std::int64_t>(k);
    for(std::size_t l = 0, n = directions.size(); l < n; ++l) {
      const double value = cosine[l] * u + sine[l] * v;
      supporting[l] = value > support[l] ? node : supporting[l];
      support[l] = value > support[l] ? value : support[l];
    }
  }

  std::vector<Index> m_nodes;
  std::vector<double> m_x, m_y, m_z;            // of the nodes
  std::vector<double> m_u, m_v, m_squared_norm; // of their images
  std::vector<double> m_support;                // per direction
  std::vector<std::int64_t> m_supporting;       // per direction, place in m_nodes
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H
