// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/strands.h"

namespace vfc {
namespace {

bool has_junction(const Curve& curve, std::size_t component)
{
  for(std::size_t v = curve.first_node(component); v < curve.first_node(component + 1); ++v)
    if(curve.degree(v) > 2) return true;
  return false;
}

// \pre there is no junction; a path has its start as first node
Strand walk_along(const Curve& curve, std::size_t component)
{
  Strand strand{{}, curve.is_closed(component)};
  const std::size_t start = curve.first_node(component);
  std::size_t v = start;
  do {
    std::size_t k = 0;
    while(k < curve.degree(v) && curve.source(curve.incident_edge(v, k)) != v) ++k;
    if(k == curve.degree(v)) break; // the end of a path
    strand.edges.push_back(curve.incident_edge(v, k));
    v = curve.target(strand.edges.back());
  } while(v != start);
  return strand;
}

} // namespace

std::vector<Strand> strands_of(const Curve& curve)
{
  std::vector<Strand> strands;
  std::vector<bool> is_cut(curve.number_of_components());
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    is_cut[c] = has_junction(curve, c);
    if(is_cut[c]) continue;
    Strand strand = walk_along(curve, c);
    if(!strand.edges.empty()) strands.push_back(strand);
  }
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
    if(is_cut[curve.component(curve.source(e))]) strands.push_back({{e}, false});
  return strands;
}

} // namespace vfc
