// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROWDING_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROWDING_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/segment_distance.h>
#include <CGAL/Volume_filling_curves/internal/measures/Least_clearance.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/search/Broad_phase.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A thickness is a number or a function of the point. Throws std::invalid_argument, at once or for
// a point, if it is not positive and finite.
template <typename Thickness>
auto thickness_function(const Thickness& thickness)
{
  if constexpr(std::is_arithmetic<Thickness>::value) {
    const double r = static_cast<double>(thickness);
    if(!is_positive(r)) refuse_value(internal_np::thickness_t(), r, demand(Range::POSITIVE));
    return [r](const auto&) { return r; };
  } else {
    return [&thickness](const auto& p) {
      return checked_thickness(static_cast<double>(thickness(p)), p);
    };
  }
}

// Distances between the strands of a curve of thickness r. Two edges belong to different strands if
// at least pi r of the curve lies between them: in a round bend of radius r the curve faces itself
// after that length. If r varies, a pair of edges has the mean of r at their middles. Near-linear
// in the number of edges and of pairs nearer than r.
template <typename Network>
class Crowding
{
public:
  template <typename Thickness>
  Crowding(const Network& curve, const Thickness& thickness)
      : m_curve(curve),
        m_radii(radii_of_edges(curve, thickness_function(thickness))),
        m_clearance(curve, scaled(CGAL_PI, m_radii))
  {}

  // Two points on different strands, and their edges: null ones if there is only one strand.
  struct Strands
  {
    double distance;
    std::array<std::size_t, 2> edges;
    std::array<Vector, 2> points;
  };

  // returns the closest ones; all edges of different components are of different strands
  Strands closest(Run_watch* watch = nullptr) const
  {
    const auto [distance, edges] = m_clearance.nearest(watch);
    if(edges[0] == Curve_interval::null) return {distance, edges, {}};
    const auto [a, b] = ends(edges[0]);
    const auto [c, d] = ends(edges[1]);
    const auto [s, t] = nearest_points(a, b, c, d);
    return {distance, edges, {Vector(a + s * (b - a)), Vector(c + t * (d - c))}};
  }

  // returns the share of the length, by whole edges, along which another strand is nearer than r
  template <typename ConcurrencyTag>
  double fraction(Run_watch* watch = nullptr) const
  {
    const Watched_scope scope(watch ? watch : Watched_scope::current());
    const Vector_field x = coordinates(m_curve);
    const auto are_crowded = [&](std::size_t e, std::size_t f) {
      const double r = (m_radii[e] + m_radii[f]) / 2;
      return squared_distance(e, f) < r * r && !m_clearance.are_neighbors(e, f);
    };
    const auto pairs = Broad_phase(ConcurrencyTag(), m_curve, x, x, m_radii)
                           .template pairs<ConcurrencyTag>(are_crowded);
    std::vector<bool> is_crowded(m_radii.size(), false);
    for(const auto& [e, f] : pairs) is_crowded[e] = is_crowded[f] = true;
    double crowded = 0, length = 0;
    for(std::size_t e = 0; e < is_crowded.size(); ++e) {
      const double edge_length = edge_vector(m_curve, e).norm();
      length += edge_length;
      if(is_crowded[e]) crowded += edge_length;
    }
    return length > 0 ? crowded / length : 0;
  }

private:
  template <typename Thickness>
  static std::vector<double> radii_of_edges(const Network& curve, const Thickness& thickness)
  {
    std::vector<double> radii;
    radii.reserve(curve.number_of_edges());
    for(std::size_t e = 0; e < curve.number_of_edges(); ++e) {
      const Vector middle =
          (to_vector(curve.point(curve.source(e))) + to_vector(curve.point(curve.target(e)))) / 2;
      radii.push_back(thickness(to_point(middle, curve.traits())));
    }
    return radii;
  }

  static std::vector<double> scaled(double factor, std::vector<double> values)
  {
    for(double& value : values) value *= factor;
    return values;
  }

  std::array<Vector, 2> ends(std::size_t e) const
  {
    return {to_vector(m_curve.point(m_curve.source(e))),
            to_vector(m_curve.point(m_curve.target(e)))};
  }

  double squared_distance(std::size_t e, std::size_t f) const
  {
    const auto [a, b] = ends(e);
    const auto [c, d] = ends(f);
    return squared_segment_distance(a, b, c, d);
  }

  const Network& m_curve;
  const std::vector<double> m_radii; // the r of each edge
  const Least_clearance<Network> m_clearance;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_CROWDING_H
