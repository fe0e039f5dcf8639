// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Node_neighborhoods.h>
#include <CGAL/Volume_filling_curves/internal/for_each_block.h>
#include <CGAL/Volume_filling_curves/internal/node_circles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The medial spheres of a curve (section 3.2 of the paper): for each node and each of N directions
// orthogonal to the curve the largest sphere, up to a cap, that touches the node with its centre in
// that direction and holds no other node.
//
// Inverting the other nodes at the node i turns the search into a support function,
//   1 / R(i, l) = max(1 / r_max, max over j of 2 x_l . d_j / |d_j|^2),  d_j = node_j - node_i,
// so that one query for the nodes within 2 r_max serves all directions. Runs of consecutive nodes,
// which lie close together, share a query.
class Medial_spheres
{
public:
  using Index = std::uint32_t;
  static constexpr Index no_node = static_cast<Index>(-1);

  Medial_spheres() = default;

  // Takes the circles of all nodes, in the order of the nodes. \pre number_of_directions > 0
  template <typename ConcurrencyTag>
  Medial_spheres(ConcurrencyTag,
                 const Vector_field& x,
                 std::vector<Node_circle> circles,
                 std::size_t number_of_directions,
                 double max_radius)
      : m_circles(std::move(circles)),
        m_max_radius(max_radius),
        m_radius(m_circles.size() * number_of_directions),
        m_touching(m_circles.size() * number_of_directions)
  {
    constexpr double pi = 3.14159265358979323846;
    for(std::size_t l = 0; l < number_of_directions; ++l) {
      const double angle =
          2 * pi * static_cast<double>(l) / static_cast<double>(number_of_directions);
      m_cosine.push_back(std::cos(angle));
      m_sine.push_back(std::sin(angle));
    }
    const Node_neighborhoods neighborhoods(x);
    constexpr std::size_t block = 256;
    for_each_block<ConcurrencyTag>(m_circles.size(), block,
                                   [&](std::size_t begin, std::size_t end) {
                                     Workspace workspace;
                                     while(begin < end)
                                       begin = measure_run(x, neighborhoods, begin, end, workspace);
                                   });
  }

  std::size_t number_of_directions() const { return m_cosine.size(); }
  const std::vector<Node_circle>& circles() const { return m_circles; }

  // the first circle of node v, or of the nodes after it if it has none
  std::size_t first_circle(std::size_t v) const
  {
    const auto found = std::lower_bound(
        m_circles.begin(), m_circles.end(), v,
        [](const Node_circle& circle, std::size_t node) { return circle.node < node; });
    return static_cast<std::size_t>(found - m_circles.begin());
  }

  // the direction l of circle c, a unit vector
  Vector direction(std::size_t c, std::size_t l) const
  {
    return m_cosine[l] * m_circles[c].u + m_sine[l] * m_circles[c].v;
  }

  double radius(std::size_t c, std::size_t l) const
  {
    return m_radius[c * number_of_directions() + l];
  }

  // the node that the sphere touches, no_node if its radius is the cap
  Index touching_node(std::size_t c, std::size_t l) const
  {
    return m_touching[c * number_of_directions() + l];
  }

private:
  struct
      Image // of a node under inversion, projected to the plane of the circle, in units of 1 / r_max
  {
    double u, v;
    Index node;
  };

  struct Workspace
  {
    std::vector<Index> nodes;
    std::vector<Vector> positions;
    std::vector<Image> images;
  };

  // Measures the spheres of a run of circles from `begin` on, and returns where it ends.
  std::size_t measure_run(const Vector_field& x,
                          const Node_neighborhoods& neighborhoods,
                          std::size_t begin,
                          std::size_t end,
                          Workspace& workspace)
  {
    constexpr std::size_t longest_run = 16; // best of 4 to 32
    const Vector first = row(x, m_circles[begin].node);
    Vector low = first, high = first;
    std::size_t run_end = begin + 1;
    for(; run_end < end && run_end < begin + longest_run; ++run_end) {
      const Vector p = row(x, m_circles[run_end].node);
      if((p - first).squaredNorm() > m_max_radius * m_max_radius) break;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double slack = 1 + 1e-12; // rounding of the centre
    neighborhoods.find((low + high) / 2, slack * ((high - low).norm() / 2 + 2 * m_max_radius),
                       workspace.nodes);
    workspace.positions.clear();
    for(Index v : workspace.nodes) workspace.positions.push_back(row(x, v));
    for(std::size_t c = begin; c < run_end; ++c) measure_circle(x, c, workspace);
    return run_end;
  }

  void measure_circle(const Vector_field& x, std::size_t c, Workspace& workspace)
  {
    find_images(row(x, m_circles[c].node), m_circles[c], workspace);
    const std::size_t n = number_of_directions();
    double* radius = m_radius.data() + c * n;
    Index* touching = m_touching.data() + c * n;
    for(std::size_t l = 0; l < n; ++l) {
      double support = 1;
      Index node = no_node;
      for(const Image& image : workspace.images) {
        const double value = m_cosine[l] * image.u + m_sine[l] * image.v;
        // ties go to the lower index: the kd-tree reports in no order
        if(value > support || (value == support && image.node < node && node != no_node)) {
          support = value;
          node = image.node;
        }
      }
      radius[l] = m_max_radius / support;
      touching[l] = node;
    }
  }

  // Only images outside the unit circle can lie beyond the cap in some direction.
  void find_images(const Vector& center, const Node_circle& circle, Workspace& workspace) const
  {
    workspace.images.clear();
    for(std::size_t k = 0; k < workspace.nodes.size(); ++k) {
      const Vector d = workspace.positions[k] - center;
      const double d2 = d.squaredNorm();
      if(d2 == 0 || d2 > 4 * m_max_radius * m_max_radius) continue;
      const double scale = 2 * m_max_radius / d2;
      const double u = scale * d.dot(circle.u), v = scale * d.dot(circle.v);
      if(u * u + v * v > 1) workspace.images.push_back({u, v, workspace.nodes[k]});
    }
  }

  std::vector<Node_circle> m_circles;
  double m_max_radius = 0;
  std::vector<double> m_cosine, m_sine;
  std::vector<double> m_radius;  // circle after circle
  std::vector<Index> m_touching; // likewise
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEDIAL_SPHERES_H
