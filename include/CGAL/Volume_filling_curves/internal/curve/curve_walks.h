// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_WALKS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_WALKS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Kinds of nodes and components, and walks along curves: edges in their order, edge vectors and the
// corners between them, and strands from one end or junction to the next.

template <typename Network>
bool has_junction(const Network& curve, std::size_t c)
{
  for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v)
    if(curve.degree(v) > 2) return true;
  return false;
}

template <typename Network>
bool is_closed_everywhere(const Network& curve)
{
  for(std::size_t c = 0; c < curve.number_of_components(); ++c)
    if(!curve.is_closed(c)) return false;
  return true;
}

template <typename Network>
bool has_constrained_node(const Network& curve)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(!curve.is_free(v)) return true;
  return false;
}

template <typename Network>
bool has_sliding_node(const Network& curve)
{
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    if(curve.constraint(v).is_sliding()) return true;
  return false;
}

// Whether a node inserted between the adjacent nodes v and w slides: both slide on the same set, or
// one slides and the other one is pinned.
template <typename Network>
bool slides_between(const Network& curve, std::size_t v, std::size_t w)
{
  const Node_constraint &a = curve.constraint(v), &b = curve.constraint(w);
  return a.is_sliding() ? a == b || curve.is_pinned(w) : curve.is_pinned(v) && b.is_sliding();
}

// whether a node inserted anywhere in component `c` slides
template <typename Network>
bool slides_everywhere(const Network& curve, std::size_t c)
{
  for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v)
    for(std::size_t k = 0; k < curve.degree(v); ++k)
      if(!slides_between(curve, v, curve.neighbor(v, k))) return false;
  return true;
}

// returns the edges of component `c` in the order of the curve; none if it has a junction
template <typename Network>
std::vector<std::size_t> edges_along(const Network& curve, std::size_t c)
{
  std::vector<std::size_t> edges;
  if(has_junction(curve, c)) return edges;
  const std::size_t start = curve.first_node(c);
  std::size_t v = start;
  do {
    const std::size_t degree = curve.degree(v);
    std::size_t k = 0;
    while(k < degree && curve.source(curve.incident_edge(v, k)) != v) ++k;
    if(k == degree) break; // the end of a path
    edges.push_back(curve.incident_edge(v, k));
    v = curve.target(edges.back());
  } while(v != start);
  return edges;
}

template <typename Network>
Vector edge_vector(const Network& curve, std::size_t e)
{
  return to_vector(curve.point(curve.target(e))) - to_vector(curve.point(curve.source(e)));
}

// returns the diagonal of the box of all nodes
template <typename Network>
double box_diagonal(const Network& curve)
{
  if(curve.number_of_nodes() == 0) return 0;
  const Vector_field x = coordinates(curve);
  return sides(x).norm();
}

template <typename Network>
bool share_a_node(const Network& curve, std::size_t e, std::size_t f)
{
  return curve.source(e) == curve.source(f) || curve.source(e) == curve.target(f) ||
         curve.target(e) == curve.source(f) || curve.target(e) == curve.target(f);
}

// Calls f(in, out) with the edge vectors at every node inside a curve, in the order of the curve.
template <typename Network, typename Function>
void for_each_corner(const Network& curve, std::size_t c, const Function& f)
{
  const std::vector<std::size_t> edges = edges_along(curve, c);
  for(std::size_t i = 1; i < edges.size(); ++i)
    f(edge_vector(curve, edges[i - 1]), edge_vector(curve, edges[i]));
  if(curve.is_closed(c)) f(edge_vector(curve, edges.back()), edge_vector(curve, edges.front()));
}

// Closed component, or part of a network between two ends or junctions with none inside. The
// last node of a closed one is the first; so can be that of a part that returns to its junction.
struct Curve_strand
{
  std::vector<std::size_t> nodes, edges; // in their order along the strand
  bool is_closed = false;
};

// Returns the strand from a node along an edge, to the next end or junction or back to the node.
template <typename Network>
Curve_strand strand_from(const Network& curve, std::size_t start, std::size_t edge)
{
  Curve_strand strand{{start}, {}, curve.degree(start) == 2};
  for(std::size_t v = start;;) {
    strand.edges.push_back(edge);
    v = curve.source(edge) == v ? curve.target(edge) : curve.source(edge);
    strand.nodes.push_back(v);
    if(curve.degree(v) != 2 || v == start) return strand;
    edge = curve.incident_edge(v, curve.incident_edge(v, 0) == edge ? 1 : 0);
  }
}

// Strands of a network, component after component. Unlike `Curve_paths` they do not depend on
// the order and the directions of the edges, which networks with junctions keep from the input.
// Linear time. \pre the network has no garbage
template <typename Network>
std::vector<Curve_strand> strands(const Network& curve)
{
  std::vector<Curve_strand> result;
  std::vector<bool> is_passed(curve.number_of_edges(), false);
  const auto add = [&](std::size_t v, std::size_t e) {
    if(is_passed[e]) return;
    result.push_back(strand_from(curve, v, e));
    for(const std::size_t passed : result.back().edges) is_passed[passed] = true;
  };
  for(const std::size_t c : curve.components()) {
    if(curve.is_closed(c)) {
      const std::size_t v = curve.first_node(c), e = curve.incident_edge(v, 0);
      add(v, curve.source(e) == v ? e : curve.incident_edge(v, 1));
    }
    for(const std::size_t v : curve.nodes(c))
      for(std::size_t k = 0; k < curve.degree(v); ++k)
        if(curve.degree(v) != 2) add(v, curve.incident_edge(v, k));
  }
  return result;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_WALKS_H
