// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/Stroke_layers.h"

#include <CGAL/box_intersection_d.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace vfc {
namespace {

// In picture units. Shading by depth is smooth with the longest pieces, colors with the shortest.
constexpr double max_piece_length = 12, min_piece_length = 1.5;

Kernel::Segment_2 in_the_plane(const Stroke_piece& piece)
{
  return {{piece.source.x(), piece.source.y()}, {piece.target.x(), piece.target.y()}};
}

// returns how far a lies over b where they cross in the picture, or else between their middles
double height_over(const Stroke_piece& a, const Stroke_piece& b)
{
  const Vector u = a.target - a.source, v = b.target - b.source, w = b.source - a.source;
  const auto cross = [](const Vector& p, const Vector& q) { return p.x() * q.y() - p.y() * q.x(); };
  const double area = cross(u, v), s = cross(w, v) / area, t = cross(w, u) / area;
  if(s >= 0 && s <= 1 && t >= 0 && t <= 1) return s * u.z() - w.z() - t * v.z();
  return (a.depth() - b.depth()) / 2;
}

} // namespace

Stroke_layers::Stroke_layers(const Drawn_curve& curve, double value_step)
    : m_reach(curve.width * (1 + 2 * gap_share)), m_value_step(value_step)
{
  for(const Strand& strand : curve.strands) cut_into_pieces(curve, strand);
  find_order();
  assign_layers();
  join_layers();
}

void Stroke_layers::cut_into_pieces(const Drawn_curve& curve, const Strand& strand)
{
  const std::size_t first = m_pieces.size(), number = m_courses.size();
  double length = 0;
  for(const std::size_t e : strand.edges) {
    const Drawn_edge& edge = curve.edges[e];
    const Vector &p = curve.points[edge.source], &q = curve.points[edge.target];
    const double edge_length = (q - p).norm();
    const int n = number_of_pieces(edge_length, std::abs(edge.values[1] - edge.values[0]));
    const auto value = [&](double t) {
      return edge.values[0] + t * (edge.values[1] - edge.values[0]);
    };
    for(int i = 0; i < n; ++i)
      m_pieces.push_back({p + (q - p) * i / n, p + (q - p) * (i + 1) / n, number,
                          value((i + 0.5) / n), length + edge_length * i / n,
                          length + edge_length * (i + 1) / n});
    length += edge_length;
  }
  for(std::size_t i = first; i + 1 < m_pieces.size(); ++i) link(i, i + 1);
  if(strand.is_closed) link(m_pieces.size() - 1, first);
  const std::size_t source = curve.edges[strand.edges.front()].source;
  const std::size_t target = curve.edges[strand.edges.back()].target;
  m_courses.push_back({length, strand.is_closed, {source, target}});
}

int Stroke_layers::number_of_pieces(double length, double change) const
{
  const double wanted = (std::max)(length / max_piece_length, change / m_value_step);
  return 1 + static_cast<int>((std::min)(wanted, length / min_piece_length));
}

void Stroke_layers::link(std::size_t i, std::size_t j)
{
  m_pieces[i].next = j;
  m_pieces[j].previous = i;
}

// Returns whether two pieces are too near along a strand, or at a junction, to cross.
bool Stroke_layers::are_neighbors(const Stroke_piece& a, const Stroke_piece& b) const
{
  if(a.strand != b.strand) return are_joined(a, b);
  const Course& course = m_courses[a.strand];
  const double first = (std::min)(a.end, b.end), second = (std::max)(a.begin, b.begin);
  const double whole = (std::max)(a.end, b.end) - (std::min)(a.begin, b.begin);
  if(second - first < 1.5 * m_reach) return true;
  return course.is_closed ? course.length - whole < 1.5 * m_reach : are_joined(a, b);
}

// Returns whether two pieces are near a common junction or end, where they do not cross. The
// smaller the angle of two branches, the longer their strokes lie side by side: from 29 degrees on,
// neither is drawn over the other.
bool Stroke_layers::are_joined(const Stroke_piece& a, const Stroke_piece& b) const
{
  for(const std::size_t i : {0u, 1u})
    for(const std::size_t j : {0u, 1u})
      if(m_courses[a.strand].ends[i] == m_courses[b.strand].ends[j] &&
         distance_to_end(a, i) + distance_to_end(b, j) < 4 * m_reach)
        return true;
  return false;
}

// Returns the distance along the strand to its first point (0) or its last (1).
double Stroke_layers::distance_to_end(const Stroke_piece& piece, std::size_t end) const
{
  return end == 0 ? piece.begin : m_courses[piece.strand].length - piece.end;
}

void Stroke_layers::find_order()
{
  using Flat_box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Index>;
  std::vector<Flat_box> boxes;
  for(Index i = 0; i < m_pieces.size(); ++i) {
    const Vector &p = m_pieces[i].source, &q = m_pieces[i].target;
    Vector low = p.cwiseMin(q).array() - m_reach / 2, high = p.cwiseMax(q).array() + m_reach / 2;
    boxes.emplace_back(low.data(), high.data(), i);
  }
  m_below.resize(m_pieces.size());
  m_above.resize(m_pieces.size());
  CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(), [&](const Flat_box& a, const Flat_box& b) {
        compare((std::min)(a.info(), b.info()), (std::max)(a.info(), b.info()));
      });
}

void Stroke_layers::compare(Index i, Index j)
{
  const Stroke_piece &a = m_pieces[i], &b = m_pieces[j];
  const double squared_distance = CGAL::squared_distance(in_the_plane(a), in_the_plane(b));
  if(squared_distance >= m_reach * m_reach || are_neighbors(a, b)) return;
  if(height_over(a, b) > 0) std::swap(i, j);
  m_pieces[j].is_over = true;
  m_above[i].push_back(j);
  m_below[j].push_back(i);
}

// Assigns ranks in the partial order, the lowest piece first. Three strokes that merely come close
// can form a cycle, which is broken at its lowest piece.
void Stroke_layers::assign_layers()
{
  const auto is_lower = [&](Index i, Index j) {
    return std::make_pair(m_pieces[i].depth(), i) < std::make_pair(m_pieces[j].depth(), j);
  };
  const auto is_higher = [&](Index i, Index j) { return is_lower(j, i); };
  std::vector<Index> by_depth(m_pieces.size());
  std::iota(by_depth.begin(), by_depth.end(), Index(0));
  std::sort(by_depth.begin(), by_depth.end(), is_lower);
  std::vector<std::size_t> open(m_pieces.size());
  std::vector<bool> is_done(m_pieces.size(), false);
  std::priority_queue<Index, std::vector<Index>, decltype(is_higher)> ready(is_higher);
  for(Index i = 0; i < m_pieces.size(); ++i) {
    open[i] = m_below[i].size();
    if(open[i] == 0) ready.push(i);
  }
  for(auto next = by_depth.begin(); next != by_depth.end();) {
    const Index i = ready.empty() ? *next++ : ready.top();
    if(!ready.empty()) ready.pop();
    if(is_done[i]) continue;
    is_done[i] = true;
    for(Index j : m_above[i]) {
      if(is_done[j]) continue;
      m_pieces[j].layer = (std::max)(m_pieces[j].layer, m_pieces[i].layer + 1);
      if(--open[j] == 0) ready.push(j);
    }
  }
}

void Stroke_layers::join_layers()
{
  for(Index i = 0; i < m_pieces.size(); ++i) follow(i, m_pieces[i].previous);
  for(Index i = static_cast<Index>(m_pieces.size()); i-- > 0;) follow(i, m_pieces[i].next);
}

// Moves piece i to the layer of its neighbor if all pieces below and above it remain so.
void Stroke_layers::follow(Index i, std::size_t neighbor)
{
  if(neighbor == Stroke_piece::none) return;
  const std::size_t layer = m_pieces[neighbor].layer, old = m_pieces[i].layer;
  const auto is_kept = [&](Index below, std::size_t lower, Index above, std::size_t upper) {
    return lower < upper || m_pieces[below].layer >= m_pieces[above].layer; // or was already broken
  };
  if(layer == old) return;
  for(Index j : m_below[i])
    if(!is_kept(j, m_pieces[j].layer, i, layer)) return;
  for(Index j : m_above[i])
    if(!is_kept(i, layer, j, m_pieces[j].layer)) return;
  m_pieces[i].layer = layer;
}

} // namespace vfc
