// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_GUARD_TEST_SUPPORT_H
#define VFC_TEST_GUARD_TEST_SUPPORT_H

#include "support/brute_force_curve.h"

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>

#include <random>
#include <vector>

// Small random curves on the lattice, and the ways between them and networks.
namespace guard_test {

using brute_force::Curve;
using brute_force::Integer;
using brute_force::Lattice_point;
using brute_force::operator+;
using brute_force::operator-;
using brute_force::operator*;
using Random = std::mt19937;
using Targets = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

inline std::size_t below(std::size_t n, Random& random)
{
  return random() % n;
}

template <typename Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>>
typename Traits::Point_3 to_point(const Lattice_point& p, const Traits& traits = Traits())
{
  return traits.construct_point_3_object()(static_cast<double>(p[0]), static_cast<double>(p[1]),
                                           static_cast<double>(p[2]));
}

template <typename Traits = CGAL::Volume_filling_curves::Curve_flow_traits_3<>>
CGAL::Volume_filling_curves::Curve_network_3<Traits> to_network(const Curve& curve,
                                                                const Traits& traits = Traits())
{
  std::vector<typename Traits::Point_3> points;
  for(const Lattice_point& p : curve.points) points.push_back(to_point(p, traits));
  return CGAL::Volume_filling_curves::Curve_network_3<Traits>(points, curve.edges, traits);
}

// how many indices nodes have, those of removed ones included
template <typename Network>
std::size_t number_of_node_indices(const Network& network)
{
  return network.number_of_nodes() + network.number_of_removed_nodes();
}

template <typename Network>
std::size_t number_of_edge_indices(const Network& network)
{
  return network.number_of_edges() + network.number_of_removed_edges();
}

// The live part of a network, its coordinates times `scale` (which makes them integers); the nodes
// keep their indices.
template <typename Network>
Curve to_curve(const Network& network, double scale = 1)
{
  Curve curve;
  for(std::size_t v = 0; v < number_of_node_indices(network); ++v) {
    const auto& p = network.point(v);
    const auto integer = [&](const auto& x) {
      return static_cast<Integer>(scale * CGAL::to_double(x));
    };
    curve.points.push_back({integer(p.x()), integer(p.y()), integer(p.z())});
  }
  for(const std::size_t e : network.edges())
    curve.edges.push_back({network.source(e), network.target(e)});
  return curve;
}

// Everything a network holds, to be compared bit by bit.
template <typename Network>
std::vector<double> contents(const Network& network)
{
  std::vector<double> all;
  const auto add = [&](auto x) { all.push_back(static_cast<double>(x)); };
  for(std::size_t v = 0; v < number_of_node_indices(network); ++v) {
    add(CGAL::to_double(network.point(v).x()));
    add(CGAL::to_double(network.point(v).y()));
    add(CGAL::to_double(network.point(v).z()));
    add(network.origin(v));
    add(network.is_pinned(v));
    add(network.component(v));
    for(std::size_t k = 0; k < network.degree(v); ++k) add(network.incident_edge(v, k));
  }
  for(std::size_t e = 0; e < number_of_edge_indices(network); ++e) {
    add(network.source(e));
    add(network.target(e));
  }
  add(network.has_garbage());
  return all;
}

// adds a path of n nodes, closed or not, that starts at a given node if there is one
inline void add_strand(Curve& curve, std::size_t n, bool is_closed, std::size_t start)
{
  const std::size_t first = start == brute_force::no_node ? curve.points.size() : start;
  std::size_t last = first;
  curve.points.resize(curve.points.size() + n - (first == start));
  for(std::size_t v = curve.points.size() - n + 1; v < curve.points.size(); ++v) {
    curve.edges.push_back({last, v});
    last = v;
  }
  if(is_closed) curve.edges.push_back({last, first});
}

// The graph of a ring, a path, two of them, a star, a ring with a ray, or a theta.
inline Curve random_graph(Random& random)
{
  constexpr std::size_t no_node = brute_force::no_node;
  Curve curve;
  const std::size_t n = 3 + below(6, random);
  switch(below(7, random)) {
  case 0:
    add_strand(curve, n, true, no_node);
    break;
  case 1:
    add_strand(curve, n, false, no_node);
    break;
  case 2:
    add_strand(curve, 3 + below(2, random), true, no_node);
    add_strand(curve, 3 + below(2, random), true, no_node);
    break;
  case 3:
    add_strand(curve, 3 + below(3, random), true, no_node);
    add_strand(curve, 2 + below(3, random), false, no_node);
    break;
  case 4:
    for(std::size_t k = 0; k < 4; ++k)
      add_strand(curve, 2 + below(2, random), false, k == 0 ? no_node : 0);
    break;
  case 5:
    add_strand(curve, n, true, no_node);
    add_strand(curve, 2 + below(2, random), false, 0);
    break;
  default:
    add_strand(curve, n + 1, true, no_node);
    add_strand(curve, 2, false, 0);
    curve.edges.push_back({curve.points.size() - 1, 2});
  }
  return curve;
}

// A point of the lattice {0, ..., side - 1}^3, or of its bottom if it is to be planar.
inline Lattice_point random_point(std::size_t side, bool is_planar, Random& random)
{
  const auto coordinate = [&] { return static_cast<Integer>(below(side, random)); };
  const Integer x = coordinate(), y = coordinate();
  return {x, y, is_planar ? 0 : coordinate()};
}

// An embedded curve with nodes on the lattice.
inline Curve random_curve(std::size_t side, bool is_planar, Random& random)
{
  for(;;) {
    Curve curve = random_graph(random);
    for(int attempt = 0; attempt < 20; ++attempt) {
      for(Lattice_point& p : curve.points) p = random_point(side, is_planar, random);
      if(is_embedded(curve)) return curve;
    }
  }
}

} // namespace guard_test

#endif // VFC_TEST_GUARD_TEST_SUPPORT_H
