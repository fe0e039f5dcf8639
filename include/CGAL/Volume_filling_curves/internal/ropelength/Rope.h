// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Closed curves as a rope: the positions of their nodes in units of the rope's radius, which makes
// the descent independent of scale, and the order of the nodes.
struct Rope
{
  // \pre all components of the curve are closed, and there is no garbage
  template <typename Network>
  Rope(const Network& curve, double radius)
      : next(curve.number_of_nodes()), previous(next.size()), component(next.size())
  {
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      next[curve.source(e)] = curve.target(e);
      previous[curve.target(e)] = curve.source(e);
    }
    for(std::size_t v = 0; v < next.size(); ++v) component[v] = curve.component(v);
    take_positions(curve, radius);
  }

  template <typename Network>
  void take_positions(const Network& curve, double radius)
  {
    x.resize(next.size());
    for(std::size_t v = 0; v < x.size(); ++v) x[v] = to_vector(curve.point(v)) / radius;
  }

  // in the unit of the curve
  Vector_field coordinates(double radius) const
  {
    Vector_field result(static_cast<Eigen::Index>(x.size()), 3);
    for(std::size_t v = 0; v < x.size(); ++v) set_row(result, v, radius * x[v]);
    return result;
  }

  std::size_t size() const { return x.size(); }

  // the edge that begins at node v
  Vector edge(std::size_t v) const { return x[next[v]] - x[v]; }

  double length() const
  {
    double sum = 0;
    for(const Component& c : components()) sum += c.length;
    return sum;
  }

  struct Component
  {
    double length = 0, size = 0; // the number of nodes
    Vector center;               // the mean of the nodes

    double mean_edge() const { return length / size; }
  };

  // of each component
  std::vector<Component> components() const
  {
    std::vector<Component> components(1 + *std::max_element(component.begin(), component.end()));
    for(std::size_t v = 0; v < size(); ++v) {
      Component& c = components[component[v]];
      c.length += edge(v).norm();
      c.center += x[v];
      ++c.size;
    }
    for(Component& c : components) c.center /= c.size;
    return components;
  }

  double mean_edge() const { return length() / static_cast<double>(size()); }

  std::vector<Vector> x;
  std::vector<std::size_t> next, previous, component; // of each node
};

// Motion of a rope's nodes without contacts: by its tension, and by its stiffness where it bends
// more tightly than its radius allows. Linear time.

// Length, in radii, of the shortest ring that bends no more tightly than its radius, with 5 % for
// polygons; a ring of 12 edges needs 2 %.
constexpr double min_length_of_ring = 1.05 * 2 * CGAL_PI;

// Moves each node by `strength` times the sum of its edges' directions, times the mean edge: by 1/2
// to the middle between its neighbors if its edges are that long. Slides it towards the longer one
// of its edges, since corners between uneven edges bend sharply (Rawdon's MinRad). A component that
// is not linked with others shrinks until it is a ring, and is widened if it is too small for one,
// where stiffness alone would shrink it further. `before` receives the former positions.
inline void pull(Rope& rope, double strength, std::vector<Vector>& before)
{
  // Of the difference of the edges. Where long and short edges alternate, 1/4 makes all equal,
  // since both ends of an edge slide, and 1/2 would exchange them.
  constexpr double evening = 0.25;
  constexpr double widening = 0.01; // in each iteration, since other strands may be around
  const std::vector<Rope::Component> components = rope.components();
  before = rope.x;
  for(std::size_t v = 0; v < rope.size(); ++v) {
    const Rope::Component& component = components[rope.component[v]];
    if(component.length < min_length_of_ring) {
      rope.x[v] += widening * (before[v] - component.center);
      continue;
    }
    const double edge = component.mean_edge();
    const Vector in = before[v] - before[rope.previous[v]], out = before[rope.next[v]] - before[v];
    const double length_in = in.norm(), length_out = out.norm();
    if(!(length_in > 0 && length_out > 0)) continue;
    const Vector ahead = out / length_out, behind = in / length_in;
    rope.x[v] += strength * edge * (ahead - behind);
    rope.x[v] += evening * (length_out - length_in) * (ahead + behind).normalized();
  }
}

// Opens corners until the arc that is tangent to both edges and touches the shorter one in its
// middle has radius 1: then |ahead - behind| = 2 sin(angle / 2), where tan(angle / 2) is half of
// the shorter edge. A node goes a third of the excess, its neighbors a sixth each.
inline void straighten(Rope& rope)
{
  for(std::size_t v = 0; v < rope.size(); ++v) {
    const std::size_t u = rope.previous[v], w = rope.next[v];
    const Vector in = rope.x[v] - rope.x[u], out = rope.x[w] - rope.x[v];
    const double length_in = in.norm(), length_out = out.norm();
    if(!(length_in > 0 && length_out > 0)) continue;
    const double edge = (std::min)(length_in, length_out), tangent = edge / 2;
    const Vector bend = edge * (out / length_out - in / length_in);
    const double max = 2 * edge * tangent / std::sqrt(1 + tangent * tangent), size = bend.norm();
    if(!(size > max)) continue;
    const Vector sixth = (size - max) / (6 * size) * bend;
    rope.x[v] += 2 * sixth;
    rope.x[u] -= sixth;
    rope.x[w] -= sixth;
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H
