// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_SURVEY_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_SURVEY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/Boundary.h>
#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Domain_parts.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_size.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thin_walls.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Box.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/search/Surface_area_order.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

inline double diagonal(const Bbox_3& box)
{
  return stable_norm(Vector(box.x_span(), box.y_span(), box.z_span()));
}

// Survey of a domain before a curve grows in it: its connected parts, the start in each, and
// whether the domain is wide enough for the thickness.
template <typename Traits, typename Domain, typename ConcurrencyTag>
class Domain_survey
{
  using Point_3 = typename Traits::Point_3;
  using Parts = Domain_parts<Traits, Domain>;
  using Space = Space_of<Domain>;

public:
  using Samples = Domain_samples_3<Traits, Domain>;
  using Parameters = Filling_parameters<Point_3>;

  Domain_survey(const Domain& domain,
                const Parameters& parameters,
                const Traits& traits,
                Run_watch& watch,
                double unit = 1)
      : m_parameters(parameters),
        m_watch(watch),
        m_samples(domain,
                  Samples::default_number,
                  parameters.random_seed,
                  traits,
                  [&] { return goes_on_sampling(); }),
        m_thickness(parameters.length > 0 ? thickness_of_length() : given_thickness()),
        m_distances(domain, m_samples.points(), sufficient_distance(), &watch, ConcurrencyTag()),
        m_parts(m_samples, m_distances, watch),
        m_widest_radius(m_parts.max_radius()),
        m_size(m_samples.volume(),
               m_distances.up_to_limit(),
               parameters.spacing,
               Space::dimension,
               shape_goal(parameters).is_given())
  {
    const bool is_asked_for = is_thickness_asked_for();
    if(!is_asked_for) m_thickness = default_thickness();
    if(parameters.length > 0)
      m_thickness.set_number((std::min)(m_thickness.number(), max_thickness_of_length()));
    m_thickness =
        m_thickness.raised_to(min_thickness_for(parameters)).averaged_at(m_samples.points());
    if(!watch.must_stop())
      m_size.check(thickness_with_as_many_nodes(),
                   is_asked_for ? Filling_size::max_nodes
                                : Filling_size::max_nodes_of_thin_by_default,
                   unit);
    for(const auto& ball : m_parts.widest_balls())
      m_is_wide.push_back(is_wide(ball.center(), ball.radius()));
  }

  const Parameters& parameters() const { return m_parameters; }

  // The largest thickness tried to reach a length: with more, a curve shrinks to a triangle. In a
  // plate strands may be farther apart than the widest ball is wide.
  double max_thickness_of_length() const { return diagonal(m_samples.domain().bbox()) / 2; }

  Run_watch& watch() const { return m_watch; }
  const Samples& samples() const { return m_samples; }

  // of the samples
  const Boundary_distances<Domain>& distances_to_boundary() const { return m_distances; }

  // the radius of the widest ball inside
  double widest_radius() const { return m_widest_radius; }

  // the thickness to start from, with the mean in the domain as its number if it varies
  const Thickness<Point_3>& thickness() const { return m_thickness; }

  // the default thickness, if it is replaced by a larger one to limit the number of nodes; else 0
  double refused_thickness() const { return m_refused_thickness; }

  // the estimated size of the filling
  const Filling_size& size() const { return m_size; }

  // A circle in each part that is wide enough for a curve, as closed polylines: a few in the order
  // of the parts, many in an order in space.
  std::vector<std::vector<Point_3>> circles() const
  {
    std::vector<std::vector<Point_3>> circles;
    for(std::size_t k = 0; k < m_is_wide.size(); ++k)
      if(m_is_wide[k]) circles.push_back(circle(m_parts.widest_balls()[k]));
    return circles.size() > few_circles ? in_spatial_order(circles) : circles;
  }

  std::size_t number_of_wide_parts() const
  {
    return static_cast<std::size_t>(std::count(m_is_wide.begin(), m_is_wide.end(), true));
  }

  // returns how many of the wide parts hold no component of the curve
  std::size_t number_of_wide_parts_without(const Curve_network_3<Traits>& curve) const
  {
    const std::vector<bool> hold_curve = parts_that_hold(curve);
    std::size_t number = 0;
    for(std::size_t k = 0; k < m_is_wide.size(); ++k) number += m_is_wide[k] && !hold_curve[k];
    return number;
  }

  // returns the points in parts with a component of the curve, and points of unknown part
  std::vector<Point_3> points_in_parts_of(const Curve_network_3<Traits>& curve,
                                          const std::vector<Point_3>& points) const
  {
    const std::vector<bool> hold_curve = parts_that_hold(curve);
    std::vector<Point_3> result;
    for(const Point_3& p : points)
      if(hold_curve[m_parts.part(p)]) result.push_back(p);
    return result;
  }

  Thickness_fit thickness_fit() const
  {
    const Thin_walls walls(m_samples, m_distances.up_to_limit(), m_thickness, m_watch);
    Thickness_fit fit;
    fit.thickness = m_thickness.number();
    fit.thin_fraction = walls.fraction(1);
    const bool is_thin = fit.thin_fraction > tolerated_unfilled_fraction;
    fit.fitting_thickness = is_thin ? uncrowded_thickness() : fit.thickness;
    if(m_watch.must_stop())
      fit.thin_fraction = fit.fitting_thickness = std::numeric_limits<double>::quiet_NaN();
    return fit;
  }

  // returns the largest thickness with which strands can keep their distance from one another, at
  // most the required one
  double uncrowded_thickness() const
  {
    const Thin_walls walls(m_samples, m_distances.up_to_limit(), m_thickness, m_watch,
                           uncrowded_width);
    const bool is_crowded = walls.fraction(1) > tolerated_unfilled_fraction;
    return m_thickness.number() * (is_crowded ? walls.fitting_scale() : 1);
  }

private:
  // A state to save or to resume from depends on all samples: a run with states takes them even if
  // it is to stop.
  bool goes_on_sampling() const
  {
    const Run_state* const former = m_parameters.resume_from;
    const bool has_state = m_parameters.checkpoint || (former && !former->is_empty());
    return has_state || !m_watch.must_stop();
  }

  bool is_thickness_asked_for() const { return m_thickness.is_given() || m_parameters.length > 0; }

  Thickness<Point_3> given_thickness() const
  {
    return Thickness<Point_3>(m_parameters.thickness, m_parameters.thickness_field);
  }

  Thickness<Point_3> thickness_of_length() const
  {
    const double content = m_samples.volume(), length = m_parameters.length;
    return Thickness<Point_3>(
        Space::is_plane
            ? thickness_of_planar_filling(content, length)
            : thickness_of_filling(content, length, shape_goal(m_parameters).is_given()));
  }

  // returns the constant thickness that leads to as many nodes; their number is proportional to
  // 1 / r^3, or to 1 / r^2 in the plane
  double thickness_with_as_many_nodes() const
  {
    if(!m_thickness.varies()) return m_thickness.number();
    const std::vector<double> values = m_thickness.at_each(m_samples.points());
    const double least = *std::min_element(values.begin(), values.end());
    double sum = 0;
    for(const double r : values) sum += Space::content(least / r);
    const double mean = sum / static_cast<double>(values.size());
    return least / (Space::is_plane ? std::sqrt(mean) : std::cbrt(mean));
  }

  // A share of the widest ball; more if there would be too many nodes, but no more than fits.
  Thickness<Point_3> default_thickness()
  {
    constexpr double default_share = 0.25; // a ball then holds a length of 75 r
    const double usual = default_share * m_widest_radius;
    const double large = m_size.thickness_with(Filling_size::max_nodes_by_default);
    const double grown = (std::max)(usual, (std::min)(large, m_widest_radius));
    if(grown > usual) m_refused_thickness = usual;
    return Thickness<Point_3>(grown);
  }

  // Whether each part holds a component; the last entry, true, stands for points of unknown part.
  // If the run is to stop, all are true: without a surface a component takes milliseconds.
  std::vector<bool> parts_that_hold(const Curve_network_3<Traits>& curve) const
  {
    std::vector<bool> result(m_is_wide.size(), false);
    result.push_back(true);
    for(std::size_t c = 0; c < curve.number_of_components(); ++c) {
      if(m_watch.must_stop()) return std::vector<bool>(result.size(), true);
      result[m_parts.part(curve.point(curve.first_node(c)))] = true;
    }
    return result;
  }

  // returns the distance to the boundary that is enough for a sample not to lie in thin walls;
  // larger distances need not be known
  double sufficient_distance() const
  {
    const bool is_thickness_known = is_thickness_asked_for() && !m_thickness.varies();
    if(!has_surface(m_samples.domain()) || !is_thickness_known || m_parameters.wall != Wall::COVER)
      return Boundary_distances<Domain>::no_limit;
    return needed_width * (std::max)(m_thickness.number(), min_thickness_for(m_parameters));
  }

  // Radius of the smallest ball in which a curve starts, in units of the thickness, or of the
  // widest ball if that is smaller. Smaller parts are ignored.
  static constexpr double min_radius = 0.125;

  // The root of a tree is a hexagon as wide as the tips of fingers; fingers grow from its edges,
  // half as long. If the run is to stop, nobody has checked that the thickness is large enough.
  std::vector<Point_3> circle(const typename Parts::Widest& ball) const
  {
    constexpr double share_of_clearance = 0.9; // of what the distance to the wall leaves
    const double wall = m_parameters.wall_distance;
    const double radius = wall > 0 ? share_of_clearance * (ball.radius() - wall) : ball.radius();
    const bool is_root = m_parameters.start == Filling_start::TREE && !m_watch.must_stop();
    if(!is_root) return ball.circle(radius);
    constexpr double radius_of_root = 0.7; // in units of the thickness
    constexpr std::size_t nodes_of_root = 6;
    const double r = m_thickness(to_point(ball.center(), m_samples.traits()));
    return ball.circle((std::min)(radius_of_root * r, radius), nodes_of_root);
  }

  // Trees of edges rely on the order of the curves, but parts come in the order of random samples:
  // 100, 900 and 1,600 separate squares of 57 nodes took 1.05, 1.9 and 2.7 times as long to fill.
  static std::vector<std::vector<Point_3>> in_spatial_order(
      const std::vector<std::vector<Point_3>>& circles)
  {
    std::vector<Bbox_3> boxes;
    for(const auto& circle : circles) {
      Box box;
      for(const Point_3& p : circle) box.extend(to_vector(p));
      boxes.push_back(to_bbox(box));
    }
    return Surface_area_order(boxes).sorted(circles);
  }

  static constexpr std::size_t few_circles = 32; // need no order

  bool is_wide(const Vector& center, double radius) const
  {
    const double thickness = m_thickness(to_point(center, m_samples.traits()));
    const double wall = m_parameters.wall_distance;
    return radius > wall &&
           radius - wall >= min_radius * (std::min)(thickness, m_widest_radius - wall);
  }

  const Parameters& m_parameters;
  Run_watch& m_watch;
  Samples m_samples;
  Thickness<Point_3> m_thickness;
  Boundary_distances<Domain> m_distances; // of the samples
  Parts m_parts;
  double m_widest_radius;
  Filling_size m_size;
  double m_refused_thickness = 0;
  std::vector<bool> m_is_wide; // of each part
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_SURVEY_H
