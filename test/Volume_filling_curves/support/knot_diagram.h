// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_TEST_KNOT_DIAGRAM_H
#define VFC_TEST_KNOT_DIAGRAM_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// Test support, on purpose without any code of the package: the crossings of closed polygons in a
// generic projection, in plain double arithmetic. A direction in which some crossing is not clearly
// one is given up for another.
namespace knot_test {

using Point = std::array<double, 3>;
using Loop = std::vector<Point>;

// returns the closed components of a curve network
template <typename Curve>
std::vector<Loop> loops_of(const Curve& curve)
{
  std::vector<Loop> loops;
  for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
    if(!curve.is_closed(c)) throw std::invalid_argument("knot_test: a component is not closed");
    Loop loop;
    std::size_t v = curve.first_node(c);
    do {
      const auto& p = curve.point(v);
      loop.push_back({p.x(), p.y(), p.z()});
      std::size_t k = 0;
      while(curve.source(curve.incident_edge(v, k)) != v) ++k;
      v = curve.target(curve.incident_edge(v, k));
    } while(v != curve.first_node(c));
    loops.push_back(std::move(loop));
  }
  return loops;
}

inline std::vector<Loop> mirrored(std::vector<Loop> loops)
{
  for(Loop& loop : loops)
    for(Point& p : loop) p[2] = -p[2];
  return loops;
}

// A crossing joins four pieces of the diagram; pieces run from one pass through a crossing to the
// next one along their component.
struct Crossing
{
  int sign = 0; // 1 if the upper strand, turned counterclockwise, points along the lower one
  std::size_t over_in = 0, over_out = 0, under_in = 0, under_out = 0;
  std::size_t over_component = 0, under_component = 0;
};

struct Diagram
{
  std::vector<Crossing> crossings;
  std::size_t number_of_pieces = 0; // twice the number of crossings
  std::size_t number_of_components = 0;

  int writhe() const
  {
    int sum = 0;
    for(const Crossing& crossing : crossings) sum += crossing.sign;
    return sum;
  }

  // These have no pieces; each is an unknot, split off from everything else.
  std::size_t number_of_components_without_crossings() const
  {
    std::vector<bool> has_crossing(number_of_components, false);
    for(const Crossing& crossing : crossings)
      has_crossing[crossing.over_component] = has_crossing[crossing.under_component] = true;
    return static_cast<std::size_t>(std::count(has_crossing.begin(), has_crossing.end(), false));
  }
};

class Projection
{
public:
  Projection(const std::vector<Loop>& loops, unsigned direction) : m_loops(loops)
  {
    rotate(direction);
    for(std::size_t c = 0; c < m_loops.size(); ++c)
      for(std::size_t i = 0; i < m_loops[c].size(); ++i) m_edges.push_back({c, i});
    find_crossings();
  }

  bool is_generic() const { return m_is_generic; }

  Diagram diagram() const
  {
    Diagram result;
    result.number_of_components = m_loops.size();
    result.crossings = m_crossings;
    std::vector<Pass> passes = m_passes;
    std::sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) {
      return std::make_pair(a.edge, a.parameter) < std::make_pair(b.edge, b.parameter);
    });
    for(std::size_t first = 0, last = 0; first < passes.size(); first = last) {
      const std::size_t component = m_edges[passes[first].edge].first;
      while(last < passes.size() && m_edges[passes[last].edge].first == component) ++last;
      for(std::size_t i = first; i < last; ++i) {
        Crossing& crossing = result.crossings[passes[i].crossing];
        const std::size_t out = i + 1 < last ? i + 1 : first;
        (passes[i].is_over ? crossing.over_in : crossing.under_in) = i;
        (passes[i].is_over ? crossing.over_out : crossing.under_out) = out;
        (passes[i].is_over ? crossing.over_component : crossing.under_component) = component;
      }
    }
    result.number_of_pieces = passes.size();
    return result;
  }

private:
  static constexpr double margin = 1e-9; // relative; what is closer to a tie is not generic

  struct Pass
  {
    std::size_t edge, crossing;
    double parameter;
    bool is_over;
  };

  // a random rotation by a unit quaternion
  void rotate(unsigned direction)
  {
    std::mt19937_64 engine(12345 + direction);
    std::array<double, 4> q;
    double norm = 0;
    do {
      norm = 0;
      for(double& x : q) {
        x = static_cast<double>(engine() >> 11) * 0x1p-52 - 1;
        norm += x * x;
      }
    } while(norm > 1 || norm < 0.1);
    for(double& x : q) x /= std::sqrt(norm);
    const auto [w, x, y, z] = q;
    const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    for(Loop& loop : m_loops)
      for(Point& p : loop) {
        const Point old = p;
        for(std::size_t i = 0; i < 3; ++i)
          p[i] = m[i][0] * old[0] + m[i][1] * old[1] + m[i][2] * old[2];
      }
  }

  const Point& source(std::size_t e) const { return m_loops[m_edges[e].first][m_edges[e].second]; }
  const Point& target(std::size_t e) const
  {
    const Loop& loop = m_loops[m_edges[e].first];
    return loop[(m_edges[e].second + 1) % loop.size()];
  }

  bool are_adjacent(std::size_t e, std::size_t f) const
  {
    if(m_edges[e].first != m_edges[f].first) return false;
    const std::size_t n = m_loops[m_edges[e].first].size();
    const std::size_t difference = (m_edges[f].second + n - m_edges[e].second) % n;
    return difference == 0 || difference == 1 || difference == n - 1;
  }

  void find_crossings()
  {
    const auto overlap = [&](std::size_t e, std::size_t f, std::size_t k) {
      const auto [a, b] = std::minmax(source(e)[k], target(e)[k]);
      const auto [c, d] = std::minmax(source(f)[k], target(f)[k]);
      return a <= d && c <= b;
    };
    for(std::size_t e = 0; e < m_edges.size() && m_is_generic; ++e)
      for(std::size_t f = e + 1; f < m_edges.size(); ++f)
        if(overlap(e, f, 0) && overlap(e, f, 1) && !are_adjacent(e, f)) cross(e, f);
  }

  void cross(std::size_t e, std::size_t f)
  {
    const Point &p = source(e), &q = target(e), &r = source(f), &s = target(f);
    const double ux = q[0] - p[0], uy = q[1] - p[1], vx = s[0] - r[0], vy = s[1] - r[1];
    const double wx = r[0] - p[0], wy = r[1] - p[1], area = ux * vy - uy * vx;
    const double size = std::hypot(ux, uy) + std::hypot(vx, vy);
    if(std::abs(area) <= margin * std::hypot(ux, uy) * std::hypot(vx, vy)) {
      const double distance = std::abs(ux * wy - uy * wx) / std::hypot(ux, uy);
      if(!(distance > margin * size)) m_is_generic = false; // parallel edges on one line
      return;
    }
    const double along_e = (wx * vy - wy * vx) / area, along_f = (wx * uy - wy * ux) / area;
    const auto is_outside = [](double t) { return t < -margin || t > 1 + margin; };
    if(is_outside(along_e) || is_outside(along_f)) return;
    const auto is_at_end = [](double t) { return t <= margin || t >= 1 - margin; };
    const double gap = p[2] + along_e * (q[2] - p[2]) - r[2] - along_f * (s[2] - r[2]);
    if(is_at_end(along_e) || is_at_end(along_f) || std::abs(gap) <= margin * size) {
      m_is_generic = false;
      return;
    }
    Crossing crossing;
    crossing.sign = (area > 0) == (gap > 0) ? 1 : -1;
    m_passes.push_back({e, m_crossings.size(), along_e, gap > 0});
    m_passes.push_back({f, m_crossings.size(), along_f, gap < 0});
    m_crossings.push_back(crossing);
  }

  std::vector<Loop> m_loops;
  std::vector<std::pair<std::size_t, std::size_t>> m_edges; // component and node
  std::vector<Crossing> m_crossings;
  std::vector<Pass> m_passes;
  bool m_is_generic = true;
};

// returns the generic diagram with the fewest crossings among several directions
inline Diagram diagram_of(const std::vector<Loop>& loops, unsigned number_of_directions = 12)
{
  Diagram best;
  bool is_found = false;
  for(unsigned k = 0; k < number_of_directions || (!is_found && k < 100); ++k) {
    const Projection projection(loops, k);
    if(!projection.is_generic()) continue;
    Diagram diagram = projection.diagram();
    if(!is_found || diagram.crossings.size() < best.crossings.size()) best = std::move(diagram);
    is_found = true;
  }
  if(!is_found) throw std::runtime_error("knot_test: no generic projection; do strands touch?");
  return best;
}

} // namespace knot_test

#endif // VFC_TEST_KNOT_DIAGRAM_H
