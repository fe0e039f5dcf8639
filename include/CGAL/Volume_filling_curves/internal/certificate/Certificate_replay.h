// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_REPLAY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_REPLAY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Replayed_curve.h>
#include <CGAL/Volume_filling_curves/internal/certificate/rational_geometry.h>
#include <CGAL/Volume_filling_curves/internal/certificate/separating_directions.h>

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

// Says why an operation is no isotopy, or makes no sense.
struct Refusal : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Carries out the operations of a certificate, one after another, each only if it is an elementary
// move of knot theory (Reidemeister 1926): the triangles that the edges sweep may meet the rest of
// the curve in the nodes that they have in common with it, and nowhere else. Independent of the guard:
// nothing is shared with what has made the certificate, and what double arithmetic cannot prove is
// decided with rational numbers. Constant time per operation if edges have similar lengths.
class Certificate_replay
{
  using Kind = Certificate_operation::Kind;

public:
  Certificate_replay(const std::vector<Position>& points,
                     const std::vector<std::array<std::uint64_t, 2>>& edges)
      : m_curve(points, edges)
  {}

  const Replayed_curve& curve() const { return m_curve; }

  // \throws Refusal unless any two edges meet at most in a common node
  void require_embedded()
  {
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const std::size_t a = m_curve.source(e), b = m_curve.target(e);
      if(a == b || point(a) == point(b)) refuse("edge ", e, " has no length");
      Extent box;
      box.add(point(a));
      box.add(point(b));
      m_curve.for_each_near(box, [&](std::size_t f) {
        if(e < f && do_edges_meet(e, f)) refuse("edge ", f, " meets edge " + name(e));
      });
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
    case Kind::SCALE:
      return scale(operation.exponent);
    case Kind::END:
      return;
    }
  }

private:
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

  // All edges at b move. While it is on its way, b must not come to one of its neighbors, nor to the
  // line through two of them but strictly between them, and the triangles must be free.
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
    m_curve.for_each_near(box, [&](std::size_t f) {
      if(m_curve.is_at(f, b)) return;
      for(const std::size_t e : edges) {
        const std::size_t a = m_curve.opposite(b, e);
        require_free({point(a), point(b), target}, a, Replayed_curve::none, f);
      }
    });
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
    m_curve.for_each_near(box, [&](std::size_t f) {
      if(!is_taken_out(f)) require_free({point(a), b, point(c)}, a, c, f);
    });
  }

  // Edge f may meet the triangle only in those of its corners a (the first) and c (the last) that
  // are its nodes. \throws Refusal
  void require_free(const std::array<Position, 3>& triangle,
                    std::size_t a,
                    std::size_t c,
                    std::size_t f) const
  {
    const auto is_in_cone = [&](std::size_t apex, const Position& q, const Position& r) {
      const Position& s = point(m_curve.opposite(apex, f));
      return !is_surely_outside_cone(point(apex), s, q, r) &&
             is_in_cone_exactly(point(apex), s, q, r);
    };
    const bool is_at_a = m_curve.is_at(f, a), is_at_c = m_curve.is_at(f, c);
    const bool is_met = is_at_a   ? is_in_cone(a, triangle[1], triangle[2]) || is_at_c
                        : is_at_c ? is_in_cone(c, triangle[0], triangle[1])
                                  : do_meet(f, triangle);
    if(is_met) refuse("edge ", f, " is in the way");
  }

  bool do_meet(std::size_t e, const std::array<Position, 3>& triangle) const
  {
    const std::array<Position, 2> segment = {point(m_curve.source(e)), point(m_curve.target(e))};
    Extent segment_box, box;
    for(const Position& p : segment) segment_box.add(p);
    for(const Position& p : triangle) box.add(p);
    return box.meets(segment_box) && !are_surely_apart(segment, triangle) &&
           do_meet_exactly(segment[0], segment[1], triangle);
  }

  // outside of a common node
  bool do_edges_meet(std::size_t e, std::size_t f) const
  {
    for(const std::size_t v : {m_curve.source(e), m_curve.target(e)})
      if(m_curve.is_at(f, v)) {
        const Position &p = point(m_curve.opposite(v, e)), &q = point(m_curve.opposite(v, f));
        return p == point(v) || q == point(v) ||
               (!is_surely_outside_cone(point(v), p, q, q) &&
                is_in_cone_exactly(point(v), p, q, q));
      }
    const Position &p = point(m_curve.source(f)), &q = point(m_curve.target(f));
    return do_meet(e, {p, q, q});
  }

  void scale(std::int64_t exponent)
  {
    constexpr std::int64_t largest = 4096; // more than from the least number to the largest
    if(exponent < -largest || exponent > largest ||
       !m_curve.scale_by_power_of_two(static_cast<int>(exponent)))
      throw Refusal("scaling would not be exact");
  }

  Replayed_curve m_curve;
};

} // namespace replay
} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CERTIFICATE_CERTIFICATE_REPLAY_H
