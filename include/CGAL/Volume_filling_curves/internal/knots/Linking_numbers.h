// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINKING_NUMBERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINKING_NUMBERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/search/Nearest_pair_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Linking numbers of closed components: half the sum of the signs of their crossings, seen from a
// point far outside. Four exact orientation tests decide whether two edges cross, and a fifth gives
// the sign of the crossing; hence the result is exact. Doubles only select the candidates, by boxes
// of the central projection with a margin. If a test is degenerate, another viewpoint is used; few
// viewpoints with 53-bit coordinates are coplanar with an edge and a node, even for curves on a
// lattice. O(n log n + k + c^2) for k candidates and c components.
template <typename Network>
class Linking_numbers
{
  using Point_3 = typename Network::Point_3;

public:
  using Matrix = std::vector<std::vector<int>>;

  explicit Linking_numbers(const Network& curve, Run_watch* watch = nullptr)
      : m_curve(curve),
        m_watch(watch),
        m_orientation(curve.traits().orientation_3_object()),
        m_viewpoint(to_point(Vector(0, 0, 0), curve.traits()))
  {}

  // Returns nothing if every viewpoint is degenerate, as may be the case if components meet.
  // \throws Run_stopped if a watch requests it
  std::optional<Matrix> operator()()
  {
    const std::size_t n = m_curve.number_of_components();
    Matrix matrix(n, std::vector<int>(n, 0));
    if(n < 2) return matrix;
    for(int attempt = 0; attempt < max_viewpoints; ++attempt) {
      for(auto& numbers : matrix) numbers.assign(n, 0);
      check(m_watch);
      look_from(attempt);
      if(!count_crossings(matrix)) continue;
      for(auto& numbers : matrix)
        for(int& number : numbers) number /= 2;
      return matrix;
    }
    return std::nullopt;
  }

  // If there is no result: two components with a degenerate test from the last viewpoint. They
  // meet, unless all viewpoints were degenerate by accident.
  const std::array<std::size_t, 2>& meeting_components() const { return m_degenerate; }

private:
  static constexpr int max_viewpoints = 8;    // valid curves hardly ever need a second
  static constexpr double view_distance = 3;  // box diagonals from the box's center
  static constexpr double box_margin = 1e-12; // of a projection of size 1/3; its rounding is 1e-15

  void look_from(int attempt)
  {
    // arbitrary directions without symmetries
    m_frame = frame_of_quaternion(0.613 + 0.1 * attempt, 0.297, -0.531, 0.7717);
    Box box;
    for(std::size_t v = 0; v < m_curve.number_of_nodes(); ++v)
      box.extend(to_vector(m_curve.point(v)));
    const Vector sizes = box.sizes();
    const double distance = view_distance * stable_norm(sizes);
    m_eye = (box.min() + box.max()) / 2 + distance * m_frame.third;
    m_viewpoint = to_point(m_eye, m_curve.traits());
  }

  // returns false if the viewpoint is degenerate; the counts are then worthless
  bool count_crossings(Matrix& matrix)
  {
    bool is_generic = true;
    unsigned pairs = 0;
    const auto count = [&](std::size_t e, std::size_t f) {
      check_sometimes(m_watch, pairs);
      const std::size_t a = m_curve.component(m_curve.source(e));
      const std::size_t b = m_curve.component(m_curve.source(f));
      if(a == b || !m_curve.is_closed(a) || !m_curve.is_closed(b)) return;
      const auto sign = crossing(e, f);
      if(!sign) {
        is_generic = false;
        m_degenerate = {(std::min)(a, b), (std::max)(a, b)};
        return;
      }
      matrix[a][b] += *sign;
      matrix[b][a] += *sign;
    };
    for_each_overlapping_pair(Box_tree(projected_edges()), count);
    return is_generic;
  }

  Vector projection(std::size_t v) const
  {
    const Vector p = m_frame(to_vector(m_curve.point(v)) - m_eye);
    return {p.x() / p.z(), p.y() / p.z(), 0};
  }

  std::vector<Bbox_3> projected_edges() const
  {
    std::vector<Bbox_3> boxes;
    boxes.reserve(m_curve.number_of_edges());
    for(std::size_t e = 0; e < m_curve.number_of_edges(); ++e) {
      const Vector p = projection(m_curve.source(e)), q = projection(m_curve.target(e));
      boxes.push_back(to_bbox(inflated(Box(p).extend(q), box_margin)));
    }
    return boxes;
  }

  // returns the sign of the crossing of edges e and f, 0 if they do not cross, or nothing if the
  // viewpoint is degenerate or the edges meet
  std::optional<int> crossing(std::size_t e, std::size_t f) const
  {
    const Point_3 &p = m_curve.point(m_curve.source(e)), &q = m_curve.point(m_curve.target(e));
    const Point_3 &r = m_curve.point(m_curve.source(f)), &s = m_curve.point(m_curve.target(f));
    const std::array<Orientation, 4> sides{
        m_orientation(m_viewpoint, p, q, r), m_orientation(m_viewpoint, p, q, s),
        m_orientation(m_viewpoint, r, s, p), m_orientation(m_viewpoint, r, s, q)};
    for(Orientation side : sides)
      if(side == COPLANAR) return std::nullopt;
    if(sides[0] == sides[1] || sides[2] == sides[3]) return 0;
    const Orientation sign = m_orientation(p, q, r, s);
    return sign == COPLANAR ? std::nullopt : std::optional<int>(sign); // coplanar: they meet
  }

  const Network& m_curve;
  Run_watch* m_watch; // none if null
  const typename Network::Traits::Orientation_3 m_orientation;
  Frame m_frame; // whose third row points from the curve to the eye
  Vector m_eye;
  Point_3 m_viewpoint;
  std::array<std::size_t, 2> m_degenerate = {}; // components
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_LINKING_NUMBERS_H
