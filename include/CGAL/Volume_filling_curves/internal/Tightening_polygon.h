// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_POLYGON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_POLYGON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/Box.h>
#include <CGAL/Volume_filling_curves/internal/Box_blocks.h>
#include <CGAL/Volume_filling_curves/internal/Tightening_clearance.h>
#include <CGAL/Volume_filling_curves/internal/Triangle_test.h>
#include <CGAL/Volume_filling_curves/internal/segment_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The working copy of a curve for a search that makes millions of small changes: flat arrays of
// doubles, no allocation per change, double filters before exact predicates. The changes that it
// allows are those of Local_change_certifier for nodes with two edges, by the same criteria; all
// others stay.
// It keeps a clearance, which is no part of the proof: a change is refused if it brings edges
// without a common node closer than that and closer than they were, or folds a corner.
class Tightening_polygon
{
public:
  using Index = std::uint32_t;

  template <typename Network>
  explicit Tightening_polygon(const Network& curve)
      : m_next_name(static_cast<Index>(curve.number_of_nodes()))
  {
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) {
      Node node;
      node.position = to_vector(curve.point(v));
      node.name = static_cast<Index>(v);
      node.component = static_cast<Index>(curve.component(v));
      node.is_fixed = curve.degree(v) != 2 || curve.is_pinned(v);
      for(std::size_t k = 0; k < 2 && curve.degree(v) == 2; ++k)
        node.edges[k] = static_cast<Index>(curve.incident_edge(v, k));
      m_nodes.push_back(node);
    }
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e)
      m_edges.push_back({static_cast<Index>(curve.source(e)), static_cast<Index>(curve.target(e))});
    m_edges_of_component.assign(curve.number_of_components(), 0);
    for(const Edge& edge : m_edges) ++m_edges_of_component[m_nodes[edge.source].component];
    renumber();
  }

  // Nodes that may move are 0, ..., number_of_free_nodes() - 1 of this list, in no special order.
  std::size_t number_of_free_nodes() const { return m_free.size(); }
  Index free_node(std::size_t k) const { return m_free[k]; }

  // nodes that were removed included, until the next `renumber()`
  std::size_t number_of_nodes() const { return m_nodes.size(); }

  std::size_t number_of_edges() const { return m_number_of_edges; }
  const std::vector<Index>& edges_of_component() const { return m_edges_of_component; }
  const Vector& position(Index v) const { return m_nodes[v].position; }
  Index edge(Index v, std::size_t k) const { return m_nodes[v].edges[k]; }
  Index neighbor(Index v, std::size_t k) const { return opposite(m_nodes[v].edges[k], v); }
  Index source(Index e) const { return m_edges[e].source; }
  Index target(Index e) const { return m_edges[e].target; }

  double length() const
  {
    double sum = 0;
    for(const Edge& edge : m_edges)
      if(edge.source != null)
        sum += (m_nodes[edge.source].position - m_nodes[edge.target].position).norm();
    return sum;
  }

  // The number that Isotopy_guard_3 gives node v: that of the input, and on from there in the order
  // in which nodes are inserted.
  Index name(Index v) const { return m_nodes[v].name; }

  void keep_clear(double distance) { m_clearance = Tightening_clearance(distance); }

  // Calls f(e) for every edge.
  template <typename Function>
  void for_each_edge(const Function& f) const
  {
    for(Index e = 0; e < m_edges.size(); ++e)
      if(m_edges[e].source != null) f(e);
  }

  // Carries out a change if it is certified, and returns whether it is. \pre v is a free node
  bool move(Index v, const Vector& target)
  {
    const Node& node = m_nodes[v];
    const Index a = neighbor(v, 0), c = neighbor(v, 1);
    const Vector &x = m_nodes[a].position, &z = m_nodes[c].position;
    if(target == node.position) return false;
    if(a == c) return false;
    if(!passes_between(x, z, node.position, target)) return false;
    const std::array<Replacement, 2> sides = {Replacement{a, null, x, node.position, target},
                                              Replacement{c, null, z, node.position, target}};
    for(const Replacement& side : sides)
      if(!is_free(side, node.edges)) return false;
    if(m_clearance.does_fold(x, target, z, node.position)) return false;
    m_nodes[v].position = target;
    update_box(node.edges[0]);
    update_box(node.edges[1]);
    return true;
  }

  bool remove(Index v)
  {
    const Node& node = m_nodes[v];
    const Index a = neighbor(v, 0), c = neighbor(v, 1);
    if(a == c || !can_cut_corner(a, v, c)) return false;
    const Index e = node.edges[0], f = node.edges[1];
    replace_end(e, v, c);
    replace_edge(c, f, e);
    m_edges[f] = {null, null};
    m_boxes.clear(f);
    update_box(e);
    m_unused_edges.push_back(f);
    m_unused_nodes.push_back(v);
    --m_edges_of_component[node.component];
    --m_number_of_edges;
    const Index last = m_free.back(), place = node.place;
    m_free[place] = last;
    m_nodes[last].place = place;
    m_free.pop_back();
    return true;
  }

  // inserts a node at y in edge e. \pre a node at one end is free
  bool insert(Index e, const Vector& y)
  {
    const Index a = m_edges[e].source, c = m_edges[e].target;
    const Vector &x = m_nodes[a].position, &z = m_nodes[c].position;
    if(y == x || y == z || !can_widen(e, y)) return false;
    if(m_clearance.does_fold(x, y, z)) return false;
    const Index v = new_node(), f = new_edge();
    Node& node = m_nodes[v];
    node.position = y;
    node.name = m_next_name++;
    node.component = m_nodes[a].component;
    node.is_fixed = false;
    node.edges = {e, f};
    node.place = static_cast<Index>(m_free.size());
    m_free.push_back(v);
    m_edges[e] = {a, v};
    m_edges[f] = {v, c};
    replace_edge(c, e, f);
    update_box(e);
    update_box(f);
    ++m_edges_of_component[node.component];
    ++m_number_of_edges;
    return true;
  }

  // Closes the gaps that removed nodes left. Indices of nodes and edges change.
  void renumber()
  {
    std::vector<Index> node_number(m_nodes.size(), null), edge_number(m_edges.size(), null);
    std::vector<bool> is_unused(m_nodes.size(), false);
    for(Index v : m_unused_nodes) is_unused[v] = true;
    Index n = 0;
    for(Index v = 0; v < m_nodes.size(); ++v)
      if(!is_unused[v]) {
        node_number[v] = n;
        m_nodes[n++] = m_nodes[v];
      }
    m_nodes.resize(n);
    n = 0;
    for(Index e = 0; e < m_edges.size(); ++e)
      if(m_edges[e].source != null) {
        edge_number[e] = n;
        m_edges[n++] = {node_number[m_edges[e].source], node_number[m_edges[e].target]};
      }
    m_edges.resize(n);
    m_number_of_edges = n;
    m_unused_nodes.clear();
    m_unused_edges.clear();
    m_free.clear();
    for(Index v = 0; v < m_nodes.size(); ++v) {
      if(m_nodes[v].edges[0] != null)
        for(Index& e : m_nodes[v].edges) e = edge_number[e];
      if(m_nodes[v].is_fixed) continue;
      m_nodes[v].place = static_cast<Index>(m_free.size());
      m_free.push_back(v);
    }
    collect_boxes();
  }

private:
  static constexpr Index null = static_cast<Index>(-1);

  struct Node
  {
    Vector position;
    std::array<Index, 2> edges = {null, null}; // only of nodes with two
    Index name = 0, component = 0, place = 0;
    bool is_fixed = false;
  };

  struct Edge
  {
    Index source, target;
  };

  // Two sides of a triangle are exchanged: from the corner at node a to b, for that to c, where c is
  // a node or not.
  struct Replacement
  {
    Index node_a, node_c;
    Vector a, b, c;
  };

  Index opposite(Index e, Index v) const
  {
    return m_edges[e].source == v ? m_edges[e].target : m_edges[e].source;
  }

  void replace_end(Index e, Index from, Index to)
  {
    (m_edges[e].source == from ? m_edges[e].source : m_edges[e].target) = to;
  }

  void replace_edge(Index v, Index from, Index to)
  {
    for(Index& e : m_nodes[v].edges)
      if(e == from) e = to;
  }

  Index new_node()
  {
    if(m_unused_nodes.empty()) {
      m_nodes.emplace_back();
      return static_cast<Index>(m_nodes.size() - 1);
    }
    const Index v = m_unused_nodes.back();
    m_unused_nodes.pop_back();
    return v;
  }

  Index new_edge()
  {
    if(m_unused_edges.empty()) {
      m_edges.push_back({null, null});
      return static_cast<Index>(m_edges.size() - 1);
    }
    const Index e = m_unused_edges.back();
    m_unused_edges.pop_back();
    return e;
  }

  Box box_of(Index e) const
  {
    return Box::of(m_nodes[m_edges[e].source].position) += m_nodes[m_edges[e].target].position;
  }

  void update_box(Index e) { m_boxes.set(e, box_of(e)); }

  void collect_boxes()
  {
    Box frame = Box::of(m_nodes.empty() ? Vector(Vector::Zero()) : m_nodes[0].position);
    for(const Node& node : m_nodes) frame += node.position;
    m_boxes = Box_blocks(frame);
    for(Index e = 0; e < m_edges.size(); ++e) update_box(e);
  }

  // conditions (ii) and (iii) for a node that moves from b to its target between neighbors a and c
  static bool passes_between(const Vector& a,
                             const Vector& c,
                             const Vector& b,
                             const Vector& target)
  {
    if(Triangle_test(a, c, b).side(target) != 0) return true;
    const auto predicates = Triangle_test::predicates();
    const auto p = Triangle_test::point(a), r = Triangle_test::point(c);
    const auto q = Triangle_test::point(b), s = Triangle_test::point(target);
    return !predicates.is_on_segment(p, q, s) && !predicates.is_on_segment(r, q, s) &&
           !predicates.does_segment_meet_line_outside(q, s, p, r);
  }

  // Whether the triangle of a replacement at a node that moves meets the curve, but for the two edges
  // at the node, only in a, and the clearance from the new side ac is kept.
  bool is_free(const Replacement& side, const std::array<Index, 2>& taken_out) const
  {
    const Triangle_test triangle(side.a, side.b, side.c);
    const Box box = ((Box::of(side.a) += side.b) += side.c).inflated(m_clearance.distance());
    return m_boxes.for_each_near(box, [&](std::size_t k) {
      const Index e = static_cast<Index>(k);
      if(e == taken_out[0] || e == taken_out[1]) return true;
      const Index s = m_edges[e].source, t = m_edges[e].target;
      const Vector &p = m_nodes[s].position, &q = m_nodes[t].position;
      if(triangle.is_far_from_plane(p, q, m_clearance.distance())) return true;
      if(s == side.node_a || t == side.node_a) {
        const Vector& far = s == side.node_a ? q : p;
        return !triangle.meets_beyond_a(far) && !m_clearance.does_bend(far, side.a, side.c, side.b);
      }
      return !triangle.meets(p, q) && m_clearance.is_kept(p, q, side.a, side.c, [&] {
        return squared_segment_distance(p, q, side.a, side.b);
      });
    });
  }

  // Whether the corner at b can be cut.
  bool can_cut_corner(Index node_a, Index node_b, Index node_c) const
  {
    const Vector &a = m_nodes[node_a].position, &b = m_nodes[node_b].position;
    const Vector& c = m_nodes[node_c].position;
    const bool is_flat = Triangle_test::are_collinear(a, b, c);
    if(is_flat && !Triangle_test::is_strictly_between(a, b, c)) return false;
    const Triangle_test triangle(a, b, c);
    const Box box = ((Box::of(a) += b) += c).inflated(m_clearance.distance());
    const std::array<Index, 2>& taken_out = m_nodes[node_b].edges;
    return m_boxes.for_each_near(box, [&](std::size_t k) {
      const Index e = static_cast<Index>(k);
      if(e == taken_out[0] || e == taken_out[1]) return true;
      const Index s = m_edges[e].source, t = m_edges[e].target;
      const bool is_at_a = s == node_a || t == node_a, is_at_c = s == node_c || t == node_c;
      if(is_at_a && is_at_c) return false;
      if(is_flat) return true;
      const Vector &p = m_nodes[s].position, &q = m_nodes[t].position;
      if(triangle.is_far_from_plane(p, q, m_clearance.distance())) return true;
      if(is_at_a) {
        const Vector& far = s == node_a ? q : p;
        return !triangle.meets_beyond_a(far) && !m_clearance.does_bend(far, a, c, b);
      }
      if(is_at_c) {
        const Vector& far = s == node_c ? q : p;
        return !triangle.meets_beyond_c(far) && !m_clearance.does_bend(far, c, a, b);
      }
      return !triangle.meets(p, q) && m_clearance.is_kept(p, q, a, c, [&] {
        return (std::min)(squared_segment_distance(p, q, a, b),
                          squared_segment_distance(p, q, b, c));
      });
    });
  }

  // Whether a node can be inserted at b in an edge.
  bool can_widen(Index edge, const Vector& b) const
  {
    const Index node_a = m_edges[edge].source, node_c = m_edges[edge].target;
    const Vector &a = m_nodes[node_a].position, &c = m_nodes[node_c].position;
    if(Triangle_test::are_collinear(a, b, c)) return Triangle_test::is_strictly_between(a, b, c);
    const Triangle_test triangle(a, b, c);
    const Box box = ((Box::of(a) += b) += c).inflated(m_clearance.distance());
    return m_boxes.for_each_near(box, [&](std::size_t k) {
      const Index e = static_cast<Index>(k);
      if(e == edge) return true;
      const Index s = m_edges[e].source, t = m_edges[e].target;
      const bool is_at_a = s == node_a || t == node_a, is_at_c = s == node_c || t == node_c;
      if(is_at_a && is_at_c) return false;
      const Vector &p = m_nodes[s].position, &q = m_nodes[t].position;
      if(triangle.is_far_from_plane(p, q, m_clearance.distance())) return true;
      if(is_at_a) {
        const Vector& far = s == node_a ? q : p;
        return !triangle.meets_beyond_a(far) && !m_clearance.does_bend(far, a, b, c);
      }
      if(is_at_c) {
        const Vector& far = s == node_c ? q : p;
        return !triangle.meets_beyond_c(far) && !m_clearance.does_bend(far, c, b, a);
      }
      const auto before = [&] { return squared_segment_distance(p, q, a, c); };
      return !triangle.meets(p, q) && m_clearance.is_kept(p, q, a, b, before) &&
             m_clearance.is_kept(p, q, b, c, before);
    });
  }

  std::vector<Node> m_nodes;
  std::vector<Edge> m_edges; // null where unused
  std::vector<Index> m_free, m_unused_nodes, m_unused_edges;
  std::vector<Index> m_edges_of_component;
  std::size_t m_number_of_edges = 0;
  Index m_next_name;
  Box_blocks m_boxes;
  Tightening_clearance m_clearance;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TIGHTENING_POLYGON_H
