// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_EDITOR_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_EDITOR_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_observer_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Input_chains.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Node_constraint.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Editor of the points and edges of a network, which does not test for isotopy: Isotopy_guard_3
// owns an editor and certifies each change first. Other code only edits its own copies. Observers
// are called after every change of points or edges, as in the mutation manager of geometry-central.
// Constant time for changes of one node.
template <typename Network>
class Network_editor
{
public:
  using Point_3 = typename Network::Point_3;
  using Observer = Curve_network_observer_3<typename Network::Traits>;

  // The network must outlive the editor. Throws std::logic_error if it has another one.
  explicit Network_editor(Network& network) : m_network(network)
  {
    m_network.m_editor_claim.take();
  }

  ~Network_editor() { m_network.m_editor_claim.give_back(); }

  Network_editor(const Network_editor&) = delete;
  Network_editor& operator=(const Network_editor&) = delete;

  // Observers must outlive the editor or be removed before.
  void add(Observer& observer) { m_observers.push_back(&observer); }

  void remove(Observer& observer)
  {
    const auto found = std::find(m_observers.begin(), m_observers.end(), &observer);
    if(found != m_observers.end()) m_observers.erase(found);
  }

  void move_node(std::size_t v, const Point_3& target)
  {
    m_network.m_points[v] = target;
    notify([&](Observer& observer) { observer.on_move(v); });
  }

  // \pre there is a round, and each of them has a position per node
  void move_nodes(const typename Observer::Rounds& rounds)
  {
    const std::vector<Point_3> before = std::exchange(m_network.m_points, rounds.positions.back());
    notify([&](Observer& observer) { observer.on_motion(before, rounds); });
  }

  // Splits edge e = (a, c) into e = (a, b) and a new last edge (b, c); b is the new last node.
  void insert_node(std::size_t e, const Point_3& b)
  {
    const std::size_t v = m_network.m_topology.insert_node(e);
    m_network.m_points.push_back(b);
    notify([&](Observer& observer) { observer.on_insertion(v); });
  }

  // Joins the neighbors of node v by an edge. \pre it has two that are not joined yet
  void remove_node(std::size_t v)
  {
    const std::size_t e = m_network.m_topology.remove_node(v);
    notify([&](Observer& observer) { observer.on_removal(v, e); });
  }

  // Lengthens a strand at its end by an edge to a new last node, which is pinned.
  void append_leaf(std::size_t end, const Point_3& position)
  {
    const std::size_t v = m_network.m_topology.add_leaf(end);
    m_network.m_points.push_back(position);
    set_pinned(v, true);
    notify([&](Observer& observer) { observer.on_new_ray(v); });
  }

  // Removes a node with one edge, and this edge. \pre its neighbor has another one
  void remove_leaf(std::size_t v)
  {
    const std::size_t e = m_network.incident_edge(v, 0);
    m_network.m_topology.remove_leaf(v);
    notify([&](Observer& observer) { observer.on_shorter_ray(v, e); });
  }

  void set_pinned(std::size_t v, bool is_pinned) { m_network.set_pinned(v, is_pinned); }

  void set_constraint(std::size_t v, const Node_constraint& constraint)
  {
    m_network.set_constraint(v, constraint);
  }

  // Replaces the network by another one that has come from the same input, see
  // Curve_topology::with_edges(); its nodes are free. Observers are not called: there must be none.
  void replace(const std::vector<Point_3>& points,
               const std::vector<std::array<std::size_t, 2>>& edges,
               const std::vector<std::size_t>& origins,
               const std::vector<Input_chains::Label>& labels)
  {
    m_network.m_topology = m_network.m_topology.with_edges(edges, origins, labels);
    m_network.m_points = points;
  }

  // the chains of the input that the edges of a network come from
  static const std::vector<Input_chains::Label>& labels(const Network& network)
  {
    return network.m_topology.input().labels();
  }

  // Closes the gaps in the numbering; returns the former index of each node.
  std::vector<std::uint32_t> collect_garbage()
  {
    std::vector<std::uint32_t> former = m_network.m_topology.compact();
    std::vector<Point_3> points;
    points.reserve(former.size());
    for(const std::uint32_t v : former) points.push_back(m_network.m_points[v]);
    m_network.m_points = std::move(points);
    notify([&](Observer& observer) { observer.on_renumbering(former); });
    return former;
  }

private:
  template <typename Message>
  void notify(const Message& message) const
  {
    for(Observer* observer : m_observers) message(*observer);
  }

  Network& m_network;
  std::vector<Observer*> m_observers;
};

// Rays of a curve, identified by their nodes: a ray leads from its tip, a node of degree one
// without an origin, through nodes without an origin to an end of the curve itself.

template <typename Network>
bool is_tip_of_ray(const Network& curve, std::size_t v)
{
  return curve.degree(v) == 1 && curve.origin(v) == curve.null_node();
}

template <typename Network>
std::vector<std::size_t> tips_of_rays(const Network& curve)
{
  std::vector<std::size_t> tips;
  for(const std::size_t v : curve.nodes())
    if(is_tip_of_ray(curve, v)) tips.push_back(v);
  return tips;
}

// Returns whether a ray begins at node v. Rays begin at nodes with an origin. Linear in the number
// of nodes without one next to it.
template <typename Network>
bool has_ray(const Network& curve, std::size_t v)
{
  if(curve.origin(v) == curve.null_node()) return false;
  for(std::size_t k = 0; k < curve.degree(v); ++k) {
    std::size_t before = v, w = curve.neighbor(v, k);
    while(curve.degree(w) == 2 && curve.origin(w) == curve.null_node())
      before = std::exchange(w, curve.neighbor(w, curve.neighbor(w, 0) == before ? 1 : 0));
    if(is_tip_of_ray(curve, w)) return true;
  }
  return false;
}

// returns the nodes of a ray, from the tip to the end of the curve
template <typename Network>
std::vector<std::size_t> nodes_from_tip(const Network& curve, std::size_t tip)
{
  std::vector<std::size_t> nodes = {tip, curve.neighbor(tip, 0)};
  while(curve.origin(nodes.back()) == curve.null_node()) {
    const std::size_t v = nodes.back(), before = nodes[nodes.size() - 2];
    nodes.push_back(curve.neighbor(v, curve.neighbor(v, 0) == before ? 1 : 0));
  }
  return nodes;
}

// Takes away all rays, and leaves no garbage.
template <typename Network>
void remove_rays(const Network& curve, Network_editor<Network>& editor)
{
  const std::vector<std::size_t> tips = tips_of_rays(curve);
  for(std::size_t v : tips)
    while(is_tip_of_ray(curve, v)) {
      const std::size_t next = curve.neighbor(v, 0);
      editor.remove_leaf(v);
      v = next;
    }
  if(curve.has_garbage()) editor.collect_garbage();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_NETWORK_EDITOR_H
