// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_REPLAY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_REPLAY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/replay/Edge_contacts.h>
#include <CGAL/Volume_filling_curves/internal/replay/Enclosure.h>
#include <CGAL/Volume_filling_curves/internal/replay/Replayed_curve.h>
#include <CGAL/Volume_filling_curves/internal/replay/rational_geometry.h>
#include <CGAL/Volume_filling_curves/internal/replay/separating_directions.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {
namespace replay {

// Fault of an operation that is not an isotopy, or is malformed.
struct Refusal : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Replay of the operations of a certificate, each only if it is an elementary move of knot theory
// (Reidemeister 1926): the triangles that the edges sweep may meet the rest of the curve only in
// common nodes. Independent of the guard: it shares no code with the certificate's author, and
// decides questions that double arithmetic cannot settle with rational numbers. Constant time per
// operation if edges have similar lengths.
class Certificate_replay
{
  using Kind = Certificate_operation::Kind;

public:
  // With an enclosure no operation may take the curve out of it.
  Certificate_replay(const std::vector<Position>& points,
                     const std::vector<std::array<std::uint64_t, 2>>& edges,
                     const Enclosure* enclosure = nullptr,
                     Run_watch* watch = nullptr)
      : m_curve(points, edges), m_enclosure(enclosure), m_watch(watch)
  {}

  const Replayed_curve& curve() const { return m_curve; }

  // \throws Refusal unless any two edges meet at most in a common node
  void require_embedded()
  {
    for(const std::size_t e : m_curve.edges()) {
      check(m_watch);
      const std::size_t a = m_curve.source(e), b = m_curve.target(e);
      if(a == b || point(a) == point(b)) refuse("edge ", e, " has no length");
      Extent box;
      box.add(point(a));
      box.add(point(b));
      m_curve.for_each_edge_meeting(box, [&](std::size_t f) {
        if(e < f && Edge_contacts(m_curve).do_meet(e, f))
          refuse("edge ", f, " meets edge " + name(e));
      });
    }
  }

  // \throws Refusal unless the curve lies inside the enclosure, if there is one: a node of each
  // component is inside, and no edge leads out
  void require_inside() const
  {
    if(m_enclosure == nullptr) return;
    const std::vector<std::size_t> nodes = m_curve.nodes();
    std::vector<bool> is_known(nodes.size(), false); // nothing has been removed yet
    for(const std::size_t v : nodes) {
      if(is_known[v]) continue;
      if(!m_enclosure->is_inside(point(v)))
        throw Refusal("node " + std::to_string(v) + " is not inside the domain");
      require_component_inside(v, is_known);
    }
  }

  // \throws Refusal
  void operator()(const Certificate_operation& operation)
  {
    switch(operation.kind) {
    case Kind::MOVE:
      return move_node(existing(operation.node), operation.position);
    case Kind::INSERT:
      return insert_node(existing(operation.node), existing(operation.other), operation.position);
    case Kind::REMOVE:
      return remove_node(existing(operation.node));
    case Kind::END:
      return;
    }
  }

private:
  void require_component_inside(std::size_t start, std::vector<bool>& is_known) const
  {
    std::vector<std::size_t> stack(1, start);
    is_known[start] = true;
    while(!stack.empty()) {
      check(m_watch);
      const std::size_t v = stack.back();
      stack.pop_back();
      for(const std::size_t e : m_curve.edges_at(v)) {
        const std::size_t w = m_curve.opposite(v, e);
        if(is_known[w] && v < w) continue; // seen from the other end
        if(!m_enclosure->is_triangle_inside({point(v), point(w), point(w)}))
          refuse("edge ", e, " is not inside the domain");
        if(!is_known[w]) stack.push_back(w);
        is_known[w] = true;
      }
    }
  }

  void require_swept_inside(const std::array<Position, 3>& triangle) const
  {
    if(m_enclosure != nullptr && !m_enclosure->is_triangle_inside(triangle))
      throw Refusal("the curve would leave the domain");
  }

  const Position& point(std::size_t v) const { return m_curve.point(v); }

  std::string name(std::size_t e) const
  {
    return "(" + std::to_string(m_curve.source(e)) + ", " + std::to_string(m_curve.target(e)) + ")";
  }

  [[noreturn]] void refuse(const char* what, std::size_t e, const std::string& and_what) const
  {
    throw Refusal(what + name(e) + and_what);
  }

  std::size_t existing(std::uint64_t v) const
  {
    if(!m_curve.is_node(v)) throw Refusal("there is no node " + std::to_string(v));
    return static_cast<std::size_t>(v);
  }

  // All edges at b move. While it is on its way, b must not come to one of its neighbors, nor to
  // the line through two of them but strictly between them, and the triangles must be free.
  void move_node(std::size_t b, const Position& target)
  {
    if(point(b) == target) return;
    const auto& edges = m_curve.edges_at(b);
    for(std::size_t i = 0; i < edges.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        require_passage(b, target, m_curve.opposite(b, edges[i]), m_curve.opposite(b, edges[j]));
    if(edges.size() == 1 &&
       is_on_segment_exactly(point(m_curve.opposite(b, edges[0])), point(b), target))
      throw Refusal("the node would run over its neighbor");
    Extent box;
    box.add(point(b));
    box.add(target);
    for(const std::size_t e : edges) box.add(point(m_curve.opposite(b, e)));
    m_curve.for_each_edge_meeting(box, [&](std::size_t f) {
      if(m_curve.is_at(f, b)) return;
      for(const std::size_t e : edges) {
        const std::size_t a = m_curve.opposite(b, e);
        require_free({point(a), point(b), target}, a, Replayed_curve::none, f);
      }
    });
    for(const std::size_t e : edges)
      require_swept_inside({point(b), target, point(m_curve.opposite(b, e))});
    m_curve.move_node(b, target);
  }

  void require_passage(std::size_t b, const Position& target, std::size_t a, std::size_t c) const
  {
    if(!surely_projects_between(point(b), target, point(a), point(c)) &&
       !passes_between_exactly(point(b), target, point(a), point(c)))
      throw Refusal("the node would not pass between its neighbors " + std::to_string(a) + " and " +
                    std::to_string(c));
  }

  void insert_node(std::size_t a, std::size_t c, const Position& position)
  {
    const std::size_t e = m_curve.edge_between(a, c);
    if(e == Replayed_curve::none)
      throw Refusal("there is no edge (" + std::to_string(a) + ", " + std::to_string(c) + ")");
    require_corner_move(a, position, c, [&](std::size_t f) { return f == e; });
    m_curve.insert_node(e, position);
  }

  void remove_node(std::size_t b)
  {
    const auto& edges = m_curve.edges_at(b);
    if(edges.size() != 2) throw Refusal("the node does not have two edges");
    const std::size_t a = m_curve.opposite(b, edges[0]), c = m_curve.opposite(b, edges[1]);
    if(m_curve.edge_between(a, c) != Replayed_curve::none)
      throw Refusal("its neighbors are joined by an edge already");
    require_corner_move(a, point(b), c, [&](std::size_t f) { return m_curve.is_at(f, b); });
    m_curve.remove_node(b);
  }

  // The edge ac is exchanged for ab, bc, or these for that.
  template <typename IsTakenOut>
  void require_corner_move(std::size_t a,
                           const Position& b,
                           std::size_t c,
                           const IsTakenOut& is_taken_out)
  {
    if(!are_surely_not_collinear(point(a), b, point(c)) &&
       are_collinear_exactly(point(a), b, point(c))) {
      if(!passes_between_exactly(b, b, point(a), point(c)))
        throw Refusal("the node is on the line of its neighbors, but not between them");
      return;
    }
    Extent box;
    for(const Position& p : {point(a), b, point(c)}) box.add(p);
    m_curve.for_each_edge_meeting(box, [&](std::size_t f) {
      if(!is_taken_out(f)) require_free({point(a), b, point(c)}, a, c, f);
    });
    require_swept_inside({point(a), b, point(c)});
  }

  // Edge f may meet the triangle only in those of its corners a (the first) and c (the last) that
  // are its nodes. \throws Refusal
  void require_free(const std::array<Position, 3>& triangle,
                    std::size_t a,
                    std::size_t c,
                    std::size_t f) const
  {
    if(Edge_contacts(m_curve).is_in_the_way(f, triangle, a, c))
      refuse("edge ", f, " is in the way");
  }

  Replayed_curve m_curve;
  const Enclosure* m_enclosure; // null for none
  Run_watch* m_watch;           // likewise
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_REPLAY_CERTIFICATE_REPLAY_H
