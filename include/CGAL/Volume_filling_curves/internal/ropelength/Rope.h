// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <algorithm>
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

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_ROPELENGTH_ROPE_H
