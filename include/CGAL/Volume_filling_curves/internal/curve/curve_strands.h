// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_STRANDS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_STRANDS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

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

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_CURVE_STRANDS_H
