// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/spheres/node_circles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
/// \headerfile CGAL/Volume_filling_curves/Curve_flow_3.h
///
/// A sphere that touches a curve at a node and contains no other node.
template <typename Point_3>
struct Medial_sphere
{
  Point_3 center;           ///< the center, in the plane orthogonal to the curve at the node
  double radius;            ///< the radius, in the input's unit
  std::size_t touched_node; ///< the node that limits the radius, or `null_node()` if the cap does
};

namespace internal {

// Directions: N evenly spaced unit vectors of a plane.
struct Circle_directions
{
  std::vector<double> cosine, sine;

  Circle_directions() = default;

  explicit Circle_directions(std::size_t n)
  {
    for(std::size_t l = 0; l < n; ++l) {
      const auto [c, s] = cos_sin(static_cast<double>(l) / static_cast<double>(n));
      cosine.push_back(c);
      sine.push_back(s);
    }
  }

  std::size_t size() const { return cosine.size(); }
};

// The medial spheres of a curve (section 3.2 of the paper): for each node and each of N directions
// orthogonal to the curve the largest sphere, up to a cap, that touches the node with its center in
// that direction and holds no other node. Medial_sphere_search finds them.
class Medial_spheres
{
public:
  using Index = std::uint32_t;
  static constexpr Index no_node = static_cast<Index>(-1);

  Medial_spheres() = default;

  // Takes the circles of all nodes, in the order of the nodes. The spheres have no size yet.
  Medial_spheres(std::vector<Node_circle> circles, std::size_t number_of_directions)
      : m_circles(std::move(circles)),
        m_directions(number_of_directions),
        m_radii(m_circles.size() * number_of_directions, 0.),
        m_touching_nodes(m_radii.size(), no_node)
  {}

  const std::vector<Node_circle>& circles() const { return m_circles; }
  const Circle_directions& directions() const { return m_directions; }
  std::size_t number_of_directions() const { return m_directions.size(); }

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
    return m_directions.cosine[l] * m_circles[c].u + m_directions.sine[l] * m_circles[c].v;
  }

  double radius(std::size_t c, std::size_t l) const { return m_radii[index(c, l)]; }

  // the node that the sphere touches, no_node if something else limits it
  Index touching_node(std::size_t c, std::size_t l) const { return m_touching_nodes[index(c, l)]; }

  void set(std::size_t c, std::size_t l, double radius, Index touching_node)
  {
    m_radii[index(c, l)] = radius;
    m_touching_nodes[index(c, l)] = touching_node;
  }

private:
  std::size_t index(std::size_t c, std::size_t l) const { return c * number_of_directions() + l; }

  std::vector<Node_circle> m_circles;
  Circle_directions m_directions;
  std::vector<double> m_radii; // circle after circle
  std::vector<Index> m_touching_nodes;
};

// The mean of the radii of medial spheres along a curve, each of them capped at `largest`, at the
// nodes v for which counts(v) holds; 0 if there are none. Takes the nodes' shares of the length.
template <typename Predicate>
double mean_radius(const Medial_spheres& spheres,
                   const std::vector<double>& node_weights,
                   double largest,
                   const Predicate& counts)
{
  double sum = 0, sum_of_weights = 0;
  for(std::size_t c = 0; c < spheres.circles().size(); ++c) {
    const auto& circle = spheres.circles()[c];
    if(!counts(circle.node)) continue;
    const double weight = node_weights[circle.node] * circle.share;
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      sum += weight * (std::min)(spheres.radius(c, l), largest);
      sum_of_weights += weight;
    }
  }
  return sum_of_weights > 0 ? sum / sum_of_weights : 0;
}

// Those of node v, as users see them: with centers.
template <typename Network>
auto medial_spheres_at(const Network& curve, std::size_t v, const Medial_spheres& spheres)
{
  std::vector<Medial_sphere<typename Network::Point_3>> result;
  for(std::size_t c = spheres.first_circle(v); c < spheres.first_circle(v + 1); ++c)
    for(std::size_t l = 0; l < spheres.number_of_directions(); ++l) {
      const double radius = spheres.radius(c, l);
      const Vector center = to_vector(curve.point(v)) + radius * spheres.direction(c, l);
      result.push_back({to_point(center, curve.traits()), radius, spheres.touching_node(c, l)});
    }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_SPHERES_MEDIAL_SPHERES_H
