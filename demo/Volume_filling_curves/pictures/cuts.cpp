// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "pictures/cuts.h"

#include <algorithm>
#include <map>
#include <utility>

namespace vfc {
namespace {

// Cuts the strands of a curve one after the other.
class Curve_cutter
{
public:
  Curve_cutter(Drawn_curve& curve, const Half_space& half_space)
      : m_curve(curve), m_half_space(half_space), m_edges(std::move(curve.edges))
  {
    m_curve.edges.clear();
  }

  void operator()()
  {
    auto& ends = m_curve.ends;
    ends.erase(std::remove_if(ends.begin(), ends.end(), [&](std::size_t v) { return !is_in(v); }),
               ends.end());
    for(Strand& strand : std::exchange(m_curve.strands, {})) cut(strand);
  }

private:
  bool is_in(std::size_t v) const { return m_half_space.height(m_curve.points[v]) <= 0; }

  void cut(Strand& strand)
  {
    const auto enters = [&](std::size_t e) { return !is_in(m_edges[e].source); };
    const auto entry = std::find_if(strand.edges.begin(), strand.edges.end(), enters);
    if(strand.is_closed) // starts outside, if any part is outside
      std::rotate(strand.edges.begin(), entry, strand.edges.end());
    Strand piece{{}, strand.is_closed && entry == strand.edges.end()};
    for(const std::size_t e : strand.edges) {
      Drawn_edge edge = m_edges[e];
      const bool starts_in = is_in(edge.source), ends_in = is_in(edge.target);
      if(!starts_in && ends_in) replace(edge, 0);
      if(starts_in && !ends_in) replace(edge, 1);
      if(starts_in || ends_in) {
        piece.edges.push_back(m_curve.edges.size());
        m_curve.edges.push_back(edge);
      }
      if(!ends_in) finish(piece);
    }
    finish(piece);
  }

  // Moves the source (0) or the target (1) of the edge to the plane.
  void replace(Drawn_edge& edge, std::size_t end)
  {
    const Vector &p = m_curve.points[edge.source], &q = m_curve.points[edge.target];
    const double t = m_half_space.height(p) / (m_half_space.height(p) - m_half_space.height(q));
    const Vector at = p + t * (q - p);
    edge.values[end] = edge.values[0] + t * (edge.values[1] - edge.values[0]);
    (end == 0 ? edge.source : edge.target) = m_curve.points.size();
    m_curve.ends.push_back(m_curve.points.size());
    m_curve.points.push_back(at);
    m_curve.numbers.push_back(0);
  }

  void finish(Strand& piece)
  {
    if(!piece.edges.empty()) m_curve.strands.push_back(piece);
    piece.edges.clear();
  }

  Drawn_curve& m_curve;
  const Half_space& m_half_space;
  const std::vector<Drawn_edge> m_edges;
};

// Cuts a surface triangle by triangle; triangles on both sides of an edge share its new point.
class Surface_cutter
{
public:
  Surface_cutter(const Triangle_soup& surface, const Half_space& half_space)
      : m_surface(surface), m_half_space(half_space)
  {}

  Cut_surface operator()()
  {
    m_result.soup.points = m_surface.points;
    for(const auto& triangle : m_surface.triangles) cut(triangle);
    return std::move(m_result);
  }

private:
  double height(std::size_t v) const { return m_half_space.height(m_surface.points[v]); }

  // The remainder of a triangle is a polygon with 3 or 4 corners, at most two of them new.
  void cut(const std::array<std::size_t, 3>& triangle)
  {
    std::vector<std::size_t> polygon, rim;
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = triangle[k], w = triangle[(k + 1) % 3];
      const bool is_in = height(v) <= 0;
      if(is_in) polygon.push_back(v);
      if(is_in == (height(w) <= 0)) continue;
      polygon.push_back(point_between(v, w));
      rim.insert(is_in ? rim.end() : rim.begin(), polygon.back());
    }
    for(std::size_t k = 2; k < polygon.size(); ++k)
      m_result.soup.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
    if(rim.size() == 2) m_result.rim.push_back({rim[0], rim[1]});
  }

  std::size_t point_between(std::size_t v, std::size_t w)
  {
    if(w < v) std::swap(v, w);
    const auto [found, is_new] = m_points.insert({{v, w}, m_result.soup.points.size()});
    if(!is_new) return found->second;
    const Vector &p = m_surface.points[v], &q = m_surface.points[w];
    m_result.soup.points.push_back(p + height(v) / (height(v) - height(w)) * (q - p));
    return found->second;
  }

  const Triangle_soup& m_surface;
  const Half_space& m_half_space;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_points; // on edges
  Cut_surface m_result;
};

} // namespace

void cut(Drawn_curve& curve, const Half_space& half_space)
{
  Curve_cutter(curve, half_space)();
}

Cut_surface cut(const Triangle_soup& surface, const Half_space& half_space)
{
  return Surface_cutter(surface, half_space)();
}

} // namespace vfc
