// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_KNOT_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_KNOT_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Frame.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A place where a projected knot crosses itself. Arcs run from one pass below to the next one and
// are numbered along the knot.
struct Diagram_crossing
{
  std::size_t over, under_in, under_out; // arcs
  bool is_positive; // whether the upper strand, turned counterclockwise, points along the lower one
};

// The crossings of a knot that is seen from a direction without symmetries. In double arithmetic:
// good for guesses, and no part of any proof. Quadratic time.
class Knot_diagram
{
public:
  // \pre the curve is a single closed component, and has no garbage
  template <typename Network>
  explicit Knot_diagram(const Network& curve)
  {
    const Frame frame = generic_frame();
    for(const auto& p : curve.points()) m_points.push_back(frame(to_vector(p)));
    const std::size_t n = m_points.size();
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = i + 2; j < n; ++j)
        if((j + 1) % n != i) cross(i, j);
    number_arcs();
  }

  const std::vector<Diagram_crossing>& crossings() const { return m_crossings; }

private:
  struct Pass
  {
    std::size_t edge;
    double parameter; // along the edge
    std::size_t crossing;
    bool is_over;
  };

  const Vector& start(std::size_t e) const { return m_points[e]; }
  Vector along(std::size_t e) const { return start((e + 1) % m_points.size()) - start(e); }

  void cross(std::size_t i, std::size_t j)
  {
    const Vector u = along(i), v = along(j), w = start(j) - start(i);
    const double area = u.x() * v.y() - u.y() * v.x();
    const double s = (w.x() * v.y() - w.y() * v.x()) / area;
    const double t = (w.x() * u.y() - w.y() * u.x()) / area;
    if(!(s >= 0 && s < 1 && t >= 0 && t < 1)) return; // parallel edges, too
    const bool is_first_over = s * u.z() > w.z() + t * v.z();
    m_passes.push_back({i, s, m_crossings.size(), is_first_over});
    m_passes.push_back({j, t, m_crossings.size(), !is_first_over});
    m_crossings.push_back({0, 0, 0, (area > 0) == is_first_over});
  }

  void number_arcs()
  {
    std::sort(m_passes.begin(), m_passes.end(), [](const Pass& a, const Pass& b) {
      return std::tie(a.edge, a.parameter) < std::tie(b.edge, b.parameter);
    });
    std::size_t arc = 0;
    for(const Pass& pass : m_passes) {
      Diagram_crossing& crossing = m_crossings[pass.crossing];
      if(pass.is_over) {
        crossing.over = arc;
        continue;
      }
      crossing.under_in = arc;
      arc = (arc + 1) % m_crossings.size();
      crossing.under_out = arc;
    }
  }

  std::vector<Vector> m_points;
  std::vector<Pass> m_passes;
  std::vector<Diagram_crossing> m_crossings;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_KNOT_DIAGRAM_H
