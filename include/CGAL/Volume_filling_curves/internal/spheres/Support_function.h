// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Node_list.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Support function of the images of nodes under inversion, which gives the medial spheres of node
// i: another node j, at d_j = node_j - node_i, has the image 2 d_j / |d_j|^2, and the sphere with
// its center in direction x_l is free if 1 / R >= max over j of x_l . 2 d_j / |d_j|^2. Only the
// projections of the images to the plane of the directions matter. Lengths are in units of the
// thickness. One array per coordinate lets loops process several nodes, or directions, at a time.
// Linear in the number of nodes times N.
//
// Known lower bounds of the support initialize each direction. The higher these bounds, the fewer
// nodes must be added: images within the circle of the lowest bound do not matter.
class Support_function
{
public:
  using Index = Node_list::Index;

  explicit Support_function(const Circle_directions& directions)
      : m_directions(directions),
        m_support(directions.size()),
        m_supporting_nodes(directions.size())
  {}

  // Begins with another circle, at whose node the thickness is `unit`. The support in each
  // direction is to be bounded next.
  void start(const Vector& node, const Node_circle& circle, double unit)
  {
    m_node = node;
    m_axis_u = 2 * unit * circle.u;
    m_axis_v = 2 * unit * circle.v;
  }

  // Resets the support in direction l.
  void bound(std::size_t l, double least)
  {
    m_support[l] = least;
    m_supporting_nodes[l] = none;
  }

  // Leaves direction l alone: nothing supports it.
  void close(std::size_t l) { bound(l, std::numeric_limits<double>::infinity()); }

  // Adds the images of some nodes, in any order, also repeatedly.
  void add(const Node_list& nodes)
  {
    invert(nodes);
    m_supporting_groups.assign(m_support.size(), no_group);
    raise_support();
    for(std::size_t l = 0; l < m_support.size(); ++l)
      if(m_supporting_groups[l] != no_group)
        m_supporting_nodes[l] = nodes.index(supporting_image(l));
  }

  // 1 / R in direction l, in units of 1 / thickness
  double operator()(std::size_t l) const { return m_support[l]; }

  // the least of them, which belongs to the largest sphere
  double least() const { return *std::min_element(m_support.begin(), m_support.end()); }

  // returns whether a node supports direction l, and not just a bound
  bool is_supported(std::size_t l) const { return m_supporting_nodes[l] != none; }

  Index supporting_node(std::size_t l) const { return m_supporting_nodes[l]; }

private:
  static constexpr Index none = Medial_spheres::no_node;
  static constexpr std::size_t group = 4; // images at a time
  static constexpr double no_group = -1;

  // The node itself and coincident ones have no image: it is not a number. They are left in the
  // center, where they support nothing.
  void invert(const Node_list& nodes)
  {
    const std::size_t n = nodes.size();
    for(auto* values : {&m_u, &m_v})
      if(values->size() < n + group) values->resize(n + group);
    const double *x = nodes.x(), *y = nodes.y(), *z = nodes.z();
    double *u = m_u.data(), *v = m_v.data();
    const Vector p = m_node, a = m_axis_u, b = m_axis_v;
    for(std::size_t k = 0; k < n; ++k) {
      const double dx = x[k] - p.x(), dy = y[k] - p.y(), dz = z[k] - p.z();
      const double scale = 1 / (dx * dx + dy * dy + dz * dz);
      const double along_u = scale * (dx * a.x() + dy * a.y() + dz * a.z()),
                   along_v = scale * (dx * b.x() + dy * b.y() + dz * b.z());
      const bool is_image = along_u * along_u + along_v * along_v > 0;
      u[k] = is_image ? along_u : 0;
      v[k] = is_image ? along_v : 0;
    }
    for(m_number_of_images = n; m_number_of_images % group != 0; ++m_number_of_images)
      m_u[m_number_of_images] = m_v[m_number_of_images] = 0;
  }

  void raise_support()
  {
    const double *cosine = m_directions.cosine.data(), *sine = m_directions.sine.data();
    double *const support = m_support.data(), *const supporting = m_supporting_groups.data();
    for(std::size_t k = 0; k < m_number_of_images; k += group) {
      const double u0 = m_u[k], u1 = m_u[k + 1], u2 = m_u[k + 2], u3 = m_u[k + 3];
      const double v0 = m_v[k], v1 = m_v[k + 1], v2 = m_v[k + 2], v3 = m_v[k + 3];
      const auto this_group = static_cast<double>(k);
      for(std::size_t l = 0, n = m_directions.size(); l < n; ++l) {
        const double c = cosine[l], s = sine[l];
        const double first = (std::max)(c * u0 + s * v0, c * u1 + s * v1),
                     last = (std::max)(c * u2 + s * v2, c * u3 + s * v3);
        const double value = (std::max)(first, last);
        supporting[l] = value > support[l] ? this_group : supporting[l];
        support[l] = value > support[l] ? value : support[l];
      }
    }
  }

  // The first of the group with the greatest value; no branches, which could not be predicted. That
  // value may differ from the support in the last bit where compilers fuse a product and a sum, as
  // on ARM without -ffp-contract=off.
  std::size_t supporting_image(std::size_t l) const
  {
    const auto k = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(m_supporting_groups[l]));
    const double v0 = value(k, l), v1 = value(k + 1, l), v2 = value(k + 2, l), v3 = value(k + 3, l);
    const std::size_t in_first_half = v1 > v0, in_last_half = v3 > v2;
    const std::size_t is_in_last_half = (std::max)(v2, v3) > (std::max)(v0, v1);
    return k + 2 * is_in_last_half + (is_in_last_half & in_last_half) +
           ((1 - is_in_last_half) & in_first_half);
  }

  double value(std::size_t k, std::size_t l) const
  {
    return m_directions.cosine[l] * m_u[k] + m_directions.sine[l] * m_v[k];
  }

  const Circle_directions& m_directions;
  Vector m_node, m_axis_u, m_axis_v; // the circle's, times twice the unit
  std::vector<double> m_u, m_v;      // of images, and zeros that make the last group full
  std::size_t m_number_of_images = 0;
  std::vector<double> m_support;           // per direction
  std::vector<double> m_supporting_groups; // likewise, of those added last: the first image, k
  std::vector<Index> m_supporting_nodes;   // likewise
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_SUPPORT_FUNCTION_H
