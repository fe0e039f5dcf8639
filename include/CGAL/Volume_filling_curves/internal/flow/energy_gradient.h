// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_ENERGY_GRADIENT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_ENERGY_GRADIENT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/flow/Direction_preference.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/flow/held_components.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Medial_spheres.h>
#include <CGAL/Volume_filling_curves/internal/support/for_each_block.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Nodes less than `reach` away from a junction, along the network: their medial spheres meet the
// sibling branches, which are arbitrarily close, and would push them apart. Dijkstra's algorithm
// from all junctions at once; O(n log n), constant time without junctions.
template <typename Network>
std::vector<bool> near_junctions(const Network& curve,
                                 const Vector_field& x,
                                 const std::vector<double>& thickness)
{
  using Item = std::pair<double, std::size_t>;
  std::vector<bool> is_near(curve.number_of_nodes(), false);
  if(!curve.has_junction()) return is_near;
  std::vector<double> distance(curve.number_of_nodes(), std::numeric_limits<double>::infinity());
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.degree(v) > 2) queue.emplace(distance[v] = 0, v);
  while(!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if(is_near[v]) continue;
    is_near[v] = true;
    for(std::size_t k = 0; k < curve.degree(v); ++k) {
      const std::size_t w = curve.neighbor(v, k);
      const double farther = d + 2 * (row(x, w) - row(x, v)).norm() / (thickness[v] + thickness[w]);
      if(farther >= distance[w] || farther >= 1) continue;
      queue.emplace(distance[w] = farther, w);
    }
  }
  return is_near;
}

// The weight of the length term for each component: 1, but less for short components, which it
// would pull to a point, where no medial sphere resists. The tension fades from a length of 5 r,
// less than a component of a tight link has, and is gone at r. Components that two nodes hold
// cannot vanish, see is_held(). Without their tension, an arc whose ends slide on two plates 2 r
// apart stayed more than twice as long as the distance.
template <typename Network>
std::vector<double> component_tensions(const Network& curve,
                                       const Vector_field& x,
                                       const std::vector<double>& weights,
                                       const std::vector<double>& thickness)
{
  constexpr double slack_length = 1, tense_length = 5; // in units of r
  std::vector<double> tensions;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    double length = 0; // in units of r
    for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v)
      length += weights[v] / thickness[v];
    const double tension = (length - slack_length) / (tense_length - slack_length);
    const bool is_tense = tension >= 1 || is_held(curve, c, x, thickness);
    tensions.push_back(is_tense ? 1. : (std::max)(tension, 0.));
  }
  return tensions;
}

// Gradient of the two-term energy E = length + alpha / 2 * sum_i w_i (1 / N) sum_l |x_i - m_il|^2
// with the sphere centers m_il = x_i + R_il x_l and the weights w_i, half of the edges at a node,
// held fixed (sections 3.1 and 3.3 of the paper). Each node sums the forces of its edges and
// spheres, hence nodes are independent, and processed in parallel with a parallel tag. Linear time.
template <typename Network, typename ConcurrencyTag = Sequential_tag>
class Energy_gradient
{
public:
  Energy_gradient(const Network& curve, const Vector_field& x, const std::vector<double>& weights)
      : m_curve(curve), m_x(x), m_weights(weights), m_gradient(Vector_field::Zero(x.rows(), 3))
  {}

  // length, times a factor per component
  void add_length(const std::vector<double>& tensions)
  {
    for_each_index<ConcurrencyTag>(size(), [&](std::size_t v) {
      const double tension = tensions[m_curve.component(v)];
      for(std::size_t k = 0; k < m_curve.degree(v); ++k)
        add(v, tension * (row(m_x, v) - row(m_x, m_curve.neighbor(v, k))).normalized());
    });
  }

  // Beyond the paper: the additional cost of edges across a direction field, times a factor per
  // component.
  void add_direction_preference(const Direction_preference& preference,
                                const std::vector<double>& tensions)
  {
    for_each_index<ConcurrencyTag>(size(), [&](std::size_t v) {
      const double tension = tensions[m_curve.component(v)];
      for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
        const Vector edge = row(m_x, v) - row(m_x, m_curve.neighbor(v, k));
        add(v, tension * preference.pull(m_curve.incident_edge(v, k), edge.normalized()));
      }
    });
  }

  // Beyond the paper: small spheres push harder. Two arcs that hook each other touch in one place
  // only, where a force that is linear in the radius hardly grows as they come closer: without
  // enough of the extra push trefoils and figure-eight knots pull through the barrier and jam.
  // Takes alpha in units of 1 / r^2.
  void add_medial_spheres(const Medial_spheres& spheres,
                          const std::vector<double>& thickness,
                          double medial_weight)
  {
    // In units of r; the strands of tight knots are 1.1 r apart. With 0.4 all of 8 closed braids of
    // the figure-eight jam, 0.6 takes 38 % more iterations on the paper's curves (2026-11-21).
    constexpr double contact_radius = 0.5;
    const auto n = static_cast<double>(spheres.number_of_directions());
    const std::vector<bool> is_left_out = near_junctions(m_curve, m_x, thickness);
    for_each_block<ConcurrencyTag>(size(), block, [&](std::size_t begin, std::size_t end) {
      const std::size_t last_circle = spheres.first_circle(end);
      for(std::size_t c = spheres.first_circle(begin); c < last_circle; ++c) {
        const Node_circle& circle = spheres.circles()[c];
        if(is_left_out[circle.node]) continue;
        const double r = thickness[circle.node];
        Vector sum; // of m_il - x_i over the directions
        for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
          const double radius = spheres.radius(c, l),
                       push = (std::max)(0., contact_radius * r - radius);
          sum += (radius - push) * spheres.direction(c, l);
        }
        const double weight = medial_weight / (r * r) * m_weights[circle.node] * circle.share / n;
        add(circle.node, -weight * sum);
      }
    });
  }

  // Returns the sum of the terms so far along the sets in which nodes move, zero at pinned nodes.
  Vector_field projected(const Tangent_projection& project) const
  {
    Vector_field gradient = m_gradient;
    project(gradient);
    return gradient;
  }

private:
  static constexpr std::size_t block = 256; // nodes per task

  std::size_t size() const { return m_curve.number_of_nodes(); }

  void add(std::size_t v, const Vector& x) { set_row(m_gradient, v, row(m_gradient, v) + x); }

  const Network& m_curve;
  const Vector_field& m_x;
  const std::vector<double>& m_weights;
  Vector_field m_gradient;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_ENERGY_GRADIENT_H
