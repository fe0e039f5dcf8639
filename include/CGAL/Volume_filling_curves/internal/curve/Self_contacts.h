// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_SELF_CONTACTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_SELF_CONTACTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Exact_predicates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Contacts that violate embeddedness: pairs of edges without a common node that meet, and pairs
// with a common node that meet elsewhere. Decided exactly, after a broad phase with boxes: O(n
// log^2 n + k) for k pairs of edges with intersecting boxes.
template <typename Traits>
class Self_contacts
{
public:
  using Point_3 = typename Traits::Point_3;
  using Edge = std::array<std::size_t, 2>;

  // \pre coordinates are of type double; no edge has length zero, no two edges have the same nodes
  Self_contacts(const std::vector<Point_3>& points,
                const std::vector<Edge>& edges,
                const Traits& traits = Traits())
      : m_points(points), m_edges(edges), m_predicates(traits)
  {}

  // Finds all contacts but keeps only the lexicographically first ones. Gives up after a million,
  // since their number can be quadratic. \throws Run_stopped in a Watched_scope
  void find(std::size_t max_kept)
  {
    m_max_kept = max_kept;
    std::vector<Box> boxes;
    std::vector<const Box*> pointers;
    boxes.reserve(m_edges.size());
    pointers.reserve(m_edges.size());
    check_run();
    for(std::size_t e = 0; e < m_edges.size(); ++e) {
      boxes.emplace_back(bbox(m_edges[e][0]) + bbox(m_edges[e][1]), e);
      pointers.push_back(&boxes.back());
    }
    const auto check = [&](const Box* a, const Box* b) { check_pair(a->info(), b->info()); };
    try {
      box_self_intersection_d(pointers.begin(), pointers.end(), check, std::ptrdiff_t(cutoff));
    } catch(const Enough_contacts&) {
    }
    std::sort_heap(m_kept.begin(), m_kept.end());
  }

  bool has_all() const { return m_count < max_count; }

  // pairs of edges, sorted
  const std::vector<Edge>& kept() const { return m_kept; }

  std::size_t count() const { return m_count; }

  // returns whether the edges meet elsewhere than in a common node
  bool are_in_contact(std::size_t e, std::size_t f) const
  {
    auto [a, b] = m_edges[e];
    auto [c, d] = m_edges[f];
    if(a == d || b == d) std::swap(c, d);
    if(b == c) std::swap(a, b);
    if(a == c) return m_predicates.have_same_direction(m_points[a], m_points[b], m_points[d]);
    return m_predicates.do_segments_intersect(m_points[a], m_points[b], m_points[c], m_points[d]);
  }

  // Describes how two edges meet, and returns the nodes that locate the contact.
  std::pair<std::string, std::vector<std::size_t>> describe(std::size_t e, std::size_t f) const
  {
    const auto [a, b] = m_edges[e];
    const auto [c, d] = m_edges[f];
    for(const auto& [v, w] : {Edge{a, c}, Edge{a, d}, Edge{b, c}, Edge{b, d}})
      if(v != w && m_predicates.are_equal(m_points[v], m_points[w]))
        return {"two nodes coincide that are no neighbors", {(std::min)(v, w), (std::max)(v, w)}};
    if(are_collinear(a, b, c) && are_collinear(a, b, d))
      return {"two edges overlap", distinct({a, b, c, d})};
    for(const auto& [v, p, q] :
        {Triple{c, a, b}, Triple{d, a, b}, Triple{a, c, d}, Triple{b, c, d}})
      if(m_predicates.is_on_segment(m_points[v], m_points[p], m_points[q]))
        return {"a node lies on an edge", {v, p, q}};
    return {"two edges cross", {a, b, c, d}};
  }

private:
  using Triple = std::array<std::size_t, 3>;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

  struct Enough_contacts
  {};

  static constexpr std::size_t max_count = 1000000;

  // Below this number of boxes the broad phase compares all with all. (A million edges: 1.6 s, with
  // a cutoff of 10 it was 3.1 s, with 200 1.8 s; 2026-11-21.)
  static constexpr int cutoff = 50;

  Bbox_3 bbox(std::size_t v) const
  {
    const Vector p = to_vector(m_points[v]);
    return {p.x(), p.y(), p.z(), p.x(), p.y(), p.z()};
  }

  // The broad phase finds pairs in no useful order; a heap keeps the first ones.
  void check_pair(std::size_t e, std::size_t f)
  {
    check_run();
    if(!are_in_contact(e, f)) return;
    ++m_count;
    m_kept.push_back({(std::min)(e, f), (std::max)(e, f)});
    std::push_heap(m_kept.begin(), m_kept.end());
    if(m_kept.size() > m_max_kept) {
      std::pop_heap(m_kept.begin(), m_kept.end());
      m_kept.pop_back();
    }
    if(!has_all()) throw Enough_contacts();
  }

  bool are_collinear(std::size_t a, std::size_t b, std::size_t c) const
  {
    return m_predicates.are_collinear(m_points[a], m_points[b], m_points[c]);
  }

  static std::vector<std::size_t> distinct(std::vector<std::size_t> nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  const std::vector<Point_3>& m_points;
  const std::vector<Edge>& m_edges;
  Exact_predicates<Traits> m_predicates;
  std::vector<Edge> m_kept;
  std::size_t m_count = 0, m_max_kept = 0;
};

// Squares of lengths must not underflow.
template <typename Network>
void check_size(const Network& curve)
{
  if(curve.number_of_nodes() == 0) return;
  const Vector_field x = coordinates(curve);
  if(!(sides(x).maxCoeff() >= min_extent))
    throw std::invalid_argument("the size of the curve is below 1e-150");
}

// Describes an edge of length zero, or two edges that meet elsewhere than in a common node; returns
// an empty text if the curve is embedded. Exact.
template <typename Network>
std::string first_contact(const Network& curve)
{
  using Traits = typename Network::Traits;
  std::vector<typename Traits::Point_3> points;
  std::vector<std::array<std::size_t, 2>> edges;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v) points.push_back(curve.point(v));
  const auto names = [&](std::size_t e) {
    return std::to_string(curve.source(e)) + " and " + std::to_string(curve.target(e));
  };
  const Exact_predicates<Traits> predicates(curve.traits());
  for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
    edges.push_back({curve.source(e), curve.target(e)});
    if(predicates.are_equal(points[edges[e][0]], points[edges[e][1]]))
      return "the nodes " + names(e) + " of an edge coincide";
  }
  Self_contacts<Traits> contacts(points, edges, curve.traits());
  contacts.find(1);
  if(contacts.count() == 0) return {};
  return "the edge of nodes " + names(contacts.kept()[0][0]) + " meets the edge of nodes " +
         names(contacts.kept()[0][1]);
}

// Throws std::invalid_argument if nothing can be certified of a curve.
template <typename Network>
void check_embedded(const Network& curve)
{
  check_size(curve);
  const std::string contact = first_contact(curve);
  if(!contact.empty()) throw std::invalid_argument(contact);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_CURVE_SELF_CONTACTS_H
