// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/strands.h"

namespace vfc {
namespace {

constexpr std::size_t no_edge = static_cast<std::size_t>(-1);

// the edge that leads on from an inner node of a path
std::size_t edge_out_of(const Curve& curve, std::size_t v)
{
  if(curve.degree(v) != 2) return no_edge;
  const std::size_t e = curve.incident_edge(v, 0), f = curve.incident_edge(v, 1);
  if((curve.source(e) == v) == (curve.source(f) == v)) return no_edge;
  return curve.source(e) == v ? e : f;
}

Strand walk_from(const Curve& curve, std::size_t start)
{
  Strand strand{{}, false};
  for(std::size_t e = start; e != no_edge && !strand.is_closed;) {
    strand.edges.push_back(e);
    e = edge_out_of(curve, curve.target(e));
    strand.is_closed = e == start;
  }
  return strand;
}

} // namespace

bool has_junction(const Curve& curve, std::size_t component)
{
  for(std::size_t v = curve.first_node(component); v < curve.first_node(component + 1); ++v)
    if(curve.degree(v) > 2) return true;
  return false;
}

std::vector<Strand> strands_of(const Curve& curve)
{
  std::vector<Strand> strands;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    for(std::size_t v = curve.first_node(c); v < curve.first_node(c + 1); ++v) {
      if(edge_out_of(curve, v) != no_edge) continue;
      for(std::size_t k = 0; k < curve.degree(v); ++k)
        if(const std::size_t e = curve.incident_edge(v, k); curve.source(e) == v)
          strands.push_back(walk_from(curve, e));
    }
    if(const std::size_t v = curve.first_node(c); curve.is_closed(c))
      strands.push_back(walk_from(curve, edge_out_of(curve, v)));
  }
  return strands;
}

} // namespace vfc
