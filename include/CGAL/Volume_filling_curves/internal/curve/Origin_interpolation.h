// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_ORIGIN_INTERPOLATION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_ORIGIN_INTERPOLATION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_topology.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/Curve_network_3.h
 *
 * \brief The class `Curve_origin` is the point of the input that a node of a result corresponds to:
 * an edge of the input, and a position on it.
 *
 * The point is `(1 - parameter) * p + parameter * q`, where `p` and `q` are the points of the input
 * with the indices `source` and `target`. Colors, times and other data along the input can be
 * interpolated at the result in the same way.
 */
struct Curve_origin
{
  /// the index in the input of the edge's first node, see `Curve_network_3::origin()`
  std::size_t source;

  /// the index in the input of the edge's second node
  std::size_t target;

  /// the position on the edge, from 0 at `source` to 1 at `target`
  double parameter;
};

namespace internal {

// Origins of the nodes of a curve in its input, as numbers along a chain of the input: 2.5 is the
// middle of its third edge. Remaining nodes of the input keep their numbers; between two of them,
// numbers are interpolated by the present arc length, hence they never run backwards. Linear time.
template <typename Network>
class Origin_interpolation
{
public:
  explicit Origin_interpolation(const Network& curve)
      : m_curve(curve),
        m_topology(curve.m_topology),
        m_origins(curve.number_of_nodes(),
                  Curve_origin{Network::null_node(), Network::null_node(), 0})
  {
    find_ranks();
    for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
      if(m_topology.has_junction(c))
        walk_chains(c);
      else
        walk_component(c);
    }
  }

  // one per node
  const std::vector<Curve_origin>& origins() const { return m_origins; }

private:
  // A node of a walk that was a node of the input, at a rank of its chain.
  struct Anchor
  {
    std::size_t step;
    double rank;
  };

  using Label = Input_chains::Label;

  const Input_chains& input() const { return m_topology.input(); }

  // The ends of chains between junctions have several ranks, of which none is needed.
  void find_ranks()
  {
    std::size_t number_of_points = 0;
    for_each_input_node([&](std::size_t v, std::size_t) {
      number_of_points = (std::max)(number_of_points, v + 1);
    });
    m_ranks.resize(number_of_points);
    for_each_input_node([&](std::size_t v, std::size_t rank) { m_ranks[v] = rank; });
  }

  template <typename Function>
  void for_each_input_node(const Function& f) const
  {
    const std::size_t number_of_chains = input().first_chain(m_curve.number_of_components());
    for(std::size_t chain = 0; chain < number_of_chains; ++chain)
      for(std::size_t rank = 0; rank < input().size(chain); ++rank)
        f(input().node(chain, rank), rank);
  }

  bool is_from_input(std::size_t v) const { return m_curve.origin(v) != Network::null_node(); }

  double rank_of(std::size_t v) const { return static_cast<double>(m_ranks[m_curve.origin(v)]); }

  void walk_component(std::size_t c)
  {
    m_walk.resize(m_curve.first_node(c + 1) - m_curve.first_node(c));
    std::iota(m_walk.begin(), m_walk.end(), m_curve.first_node(c));
    std::vector<Anchor> anchors;
    for(std::size_t i = 0; i < m_walk.size(); ++i)
      if(is_from_input(m_walk[i])) anchors.push_back({i, rank_of(m_walk[i])});
    const std::size_t chain = input().first_chain(c);
    if(m_curve.is_closed(c)) close(anchors, chain);
    interpolate(anchors, chain);
  }

  // Leads the walk around a closed curve, from an anchor back to it. Without any anchor the curve
  // starts where the input did.
  void close(std::vector<Anchor>& anchors, std::size_t chain)
  {
    if(anchors.empty()) anchors.push_back({0, 0});
    const std::size_t start = anchors.front().step;
    std::rotate(m_walk.begin(), m_walk.begin() + static_cast<std::ptrdiff_t>(start), m_walk.end());
    m_walk.push_back(m_walk.front());
    const double turn = static_cast<double>(input().size(chain));
    for(Anchor& anchor : anchors) {
      anchor.step -= start;
      if(anchor.rank < anchors.front().rank) anchor.rank += turn;
    }
    anchors.push_back({m_walk.size() - 1, anchors.front().rank + turn});
  }

  // Chains lie between nodes that are no inner nodes of one: junctions, ends, and the ends of the
  // input if the curve goes on there for the time being.
  void walk_chains(std::size_t c)
  {
    std::vector<bool> is_walked(m_curve.number_of_edges(), false);
    for(std::size_t v = m_curve.first_node(c); v < m_curve.first_node(c + 1); ++v) {
      if(is_inside_chain(v)) continue;
      for(std::size_t k = 0; k < m_curve.degree(v); ++k) {
        const std::size_t e = m_curve.incident_edge(v, k);
        if(!is_walked[e] && m_topology.input().label(e).chain != Label::none)
          walk_chain(v, e, is_walked);
      }
    }
  }

  bool is_inside_chain(std::size_t v) const
  {
    return m_curve.degree(v) == 2 &&
           m_topology.input().label(m_curve.incident_edge(v, 0)).chain ==
               m_topology.input().label(m_curve.incident_edge(v, 1)).chain;
  }

  void walk_chain(std::size_t v, std::size_t e, std::vector<bool>& is_walked)
  {
    const Label label = m_topology.input().label(e);
    const bool is_backwards = (m_curve.source(e) != v) != label.is_reversed;
    m_walk.assign(1, v);
    for(;;) {
      is_walked[e] = true;
      v = m_topology.opposite(v, e);
      m_walk.push_back(v);
      if(!is_inside_chain(v)) break;
      e = m_curve.incident_edge(v, m_curve.incident_edge(v, 0) == e ? 1 : 0);
    }
    if(is_backwards) std::reverse(m_walk.begin(), m_walk.end());
    std::vector<Anchor> anchors(1, Anchor{0, 0});
    for(std::size_t i = 1; i + 1 < m_walk.size(); ++i)
      if(is_from_input(m_walk[i])) anchors.push_back({i, rank_of(m_walk[i])});
    anchors.push_back({m_walk.size() - 1, static_cast<double>(input().size(label.chain) - 1)});
    interpolate(anchors, label.chain);
  }

  void interpolate(const std::vector<Anchor>& anchors, std::size_t chain)
  {
    for(std::size_t k = 1; k < anchors.size(); ++k) interpolate(anchors[k - 1], anchors[k], chain);
    for(const Anchor& anchor : anchors) set_origin(anchor.step, chain, anchor.rank);
  }

  void interpolate(const Anchor& a, const Anchor& b, std::size_t chain)
  {
    double length = 0, done = 0;
    for(std::size_t i = a.step; i < b.step; ++i) length += step_length(i);
    for(std::size_t i = a.step + 1; i < b.step; ++i) {
      done += step_length(i - 1);
      const double share = length > 0 ? done / length : 0;
      set_origin(i, chain, (std::min)(a.rank + share * (b.rank - a.rank), b.rank));
    }
  }

  double step_length(std::size_t i) const
  {
    return (to_vector(m_curve.point(m_walk[i + 1])) - to_vector(m_curve.point(m_walk[i]))).norm();
  }

  void set_origin(std::size_t step, std::size_t chain, double rank)
  {
    const std::size_t v = m_walk[step], n = input().size(chain);
    const bool is_closed = m_curve.is_closed(m_curve.component(v));
    if(is_closed && rank >= static_cast<double>(n)) rank -= static_cast<double>(n);
    const std::size_t last_edge = is_closed ? n - 1 : n - 2;
    const std::size_t k = (std::min)(static_cast<std::size_t>(rank), last_edge);
    m_origins[v] = {input().node(chain, k), input().node(chain, (k + 1) % n),
                    rank - static_cast<double>(k)};
  }

  const Network& m_curve;
  const Curve_topology& m_topology;
  std::vector<std::size_t> m_ranks; // of the nodes of the input in their chains
  std::vector<std::size_t> m_walk;  // the nodes along the chain that is looked at
  std::vector<Curve_origin> m_origins;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_ORIGIN_INTERPOLATION_H
