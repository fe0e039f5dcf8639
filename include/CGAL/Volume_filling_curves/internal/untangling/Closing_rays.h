// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CLOSING_RAYS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CLOSING_RAYS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Network_editor.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/spheres/Default_thickness.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Ray_turn.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_flow_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The sphere out of which closing rays lead.
struct Ray_sphere
{
  Ball ball;
  double inner_radius = 0;   // of the ball that the curves must not leave
  double length_of_rays = 0; // of all of them
};

// Closing rays, which preserve the knot of an open curve: without them a strand could slip off an
// end. While components with pinned ends flow, a straight ray of pinned nodes leads from each end
// out of a sphere around all curves. As long as the curve stays inside the sphere, the type of the
// curve, closed outside, cannot change. Like the usual closure of an open knot, the rays point away
// from the mean of the nodes, at first and on request. They vanish with this object. Components
// with a free end have none, since strands can slip off there anyway. Near-linear time.
template <typename Guard>
class Closing_rays
{
  using Network = typename Guard::Curve_network;
  using Point_3 = typename Guard::Point_3;

public:
  // Adds no rays yet.
  explicit Closing_rays(Guard& guard) : m_guard(guard), m_curve(guard.curve()) { find_ends(); }

  Closing_rays(const Closing_rays&) = delete;
  Closing_rays& operator=(const Closing_rays&) = delete;
  ~Closing_rays() { m_guard.remove_rays(); }

  bool are_needed() const { return !m_ends.empty(); }

  // Adds the rays for a flow, and sets its thickness if none is given, since it must be measured
  // without rays. Does nothing if a length is not positive and finite, or so small that there would
  // be too many nodes: the flow will refuse it.
  // \pre the curve is embedded and has no garbage
  // \throws Run_stopped if the guard's watch ends the measuring
  template <typename ConcurrencyTag>
  void grow(Curve_flow_parameters& parameters)
  {
    if(!are_needed() || parameters.number_of_directions == 0) return;
    if(parameters.thickness == 0)
      parameters.thickness = Default_thickness<Network, ConcurrencyTag>(
          m_curve, parameters.number_of_directions, m_guard.watch())();
    if(!is_positive(parameters.thickness) || !is_positive(parameters.spacing) ||
       has_too_many_nodes(total_length(m_curve), parameters.spacing, parameters.thickness))
      return;
    set_ball(parameters.thickness);
    add_rays();
    divide(max_spacing * parameters.spacing * parameters.thickness);
    m_guard.collect_garbage();
  }

  // Turns the rays by a small angle, as far as certified, to point away from the current mean of
  // the nodes. Returns whether they moved. \pre there is no garbage
  bool turn_outwards(double clearance)
  {
    const Clearance_scope<Guard> scope(m_guard, clearance);
    const Vector center = own_mean();
    bool have_moved = false;
    for(const std::size_t tip : tips_of_rays(m_curve)) {
      Vector_field x = coordinates(m_curve);
      turn(tip, center, x);
      have_moved |= m_guard.move_nodes(x, Step_size::min_fraction) > 0;
    }
    return have_moved;
  }

  // the length of all rays
  double length() const { return m_sphere.length_of_rays; }

  // Returns whether the curve is inside the sphere, at least a step from it, and hence always was.
  bool hold() const
  {
    if(m_sphere.length_of_rays == 0) return true;
    for(std::size_t v = 0; v < m_curve.number_of_nodes(); ++v)
      if(!m_curve.is_pinned(v) &&
         !((to_vector(m_curve.point(v)) - m_sphere.ball.center).norm() < m_sphere.inner_radius))
        return false;
    return true;
  }

  // Returns whether the usual closure of the current curve has its former type: whether the rays
  // could turn away from the present mean of the nodes without meeting anything.
  bool can_turn_outwards() const
  {
    Ray_turn<Network> test(m_curve, m_sphere.ball, own_mean());
    for(const std::size_t tip : tips_of_rays(m_curve)) test.add_ray(nodes_from_tip(m_curve, tip));
    return test();
  }

  const Ray_sphere& sphere() const { return m_sphere; }
  void set_sphere(const Ray_sphere& sphere) { m_sphere = sphere; }

private:
  // The curve must stay inside the sphere: a larger one leaves it more room, but rays have more
  // nodes.
  static constexpr double radius_over_size = 1.25, margin_over_thickness = 5;
  static constexpr int max_attempts = 100;   // to find a direction
  static constexpr int halvings = 12;        // the first direction after a refusal is off by 2^-11
  static constexpr double max_spacing = 1.5; // in units of the flow's, which splits from 2 on

  void find_ends()
  {
    for(std::size_t c = 0; c < m_curve.number_of_components(); ++c) {
      const std::size_t first = m_ends.size();
      bool are_pinned = true;
      for(std::size_t v = m_curve.first_node(c); v < m_curve.first_node(c + 1); ++v) {
        if(m_curve.degree(v) != 1) continue;
        are_pinned = are_pinned && m_curve.is_pinned(v);
        m_ends.push_back(v);
      }
      if(!are_pinned) m_ends.resize(first);
    }
  }

  void set_ball(double thickness)
  {
    const Vector_field x = coordinates(m_curve);
    m_sphere.ball.center = centroid(x);
    double size = 0;
    for(Eigen::Index v = 0; v < x.rows(); ++v)
      size = (std::max)(size, (row(x, v) - m_sphere.ball.center).norm());
    const double margin = (std::min)(margin_over_thickness * thickness, 100 * size);
    m_sphere.ball.radius = radius_over_size * size + margin;
    m_sphere.inner_radius = m_sphere.ball.radius - (std::min)(thickness, margin / 2);
  }

  // Rays point away from the center of the ball or, if this is refused, in the nearest accepted one
  // of some random directions.
  void add_rays()
  {
    Random_source random(0);
    std::vector<std::size_t> ends = m_ends;
    for(int attempt = 0; !ends.empty(); ++attempt) {
      if(attempt == max_attempts)
        throw std::invalid_argument("node " + std::to_string(ends[0]) +
                                    ", an end, is enclosed by the curves");
      std::vector<std::size_t> refused_ends;
      for(const std::size_t v : ends) {
        const Vector tilt =
            attempt == 0
                ? Vector()
                : Vector(std::ldexp(1., (std::min)(attempt - halvings, 1)) * random.direction());
        if(!m_guard.add_ray(v, tip(v, tilt))) refused_ends.push_back(v);
      }
      ends = refused_ends;
    }
    for(const std::size_t v : m_ends)
      m_sphere.length_of_rays += edge_vector(m_curve, m_curve.incident_edge(v, 1)).norm();
  }

  Point_3 tip(std::size_t end, const Vector& tilt) const
  {
    const Vector p = to_vector(m_curve.point(end)), outwards = p - m_sphere.ball.center;
    const Vector direction = outwards.norm() > 0 ? outwards.normalized() : Vector(1, 0, 0);
    return to_point(m_sphere.ball.tip(p, (direction + tilt).normalized()), m_curve.traits());
  }

  // Leaves garbage.
  void divide(double length)
  {
    const Clearance_scope<Guard> scope(m_guard, 0);
    for(const std::size_t tip : tips_of_rays(m_curve))
      divide(m_curve.incident_edge(tip, 0), length);
  }

  void divide(std::size_t e, double length)
  {
    if(edge_vector(m_curve, e).norm() <= length) return;
    if(!halve_edge(m_guard, e)) return;
    const std::size_t middle = m_curve.target(e);
    m_guard.set_pinned(middle);
    divide(e, length);
    divide(m_curve.incident_edge(middle, 1), length);
  }

  // the mean of the nodes of the curve itself
  Vector own_mean() const
  {
    auto n = static_cast<double>(m_curve.number_of_nodes());
    Vector sum;
    for(const auto& p : m_curve.points()) sum += to_vector(p);
    for(const std::size_t tip : tips_of_rays(m_curve)) {
      std::vector<std::size_t> nodes = nodes_from_tip(m_curve, tip);
      nodes.pop_back();
      for(const std::size_t v : nodes) sum -= to_vector(m_curve.point(v));
      n -= static_cast<double>(nodes.size());
    }
    return sum / n;
  }

  void turn(std::size_t tip, const Vector& center, Vector_field& x) const
  {
    constexpr double max_tangent = 0.05; // 3 degrees; larger turns sweep over more strands
    std::vector<std::size_t> nodes = nodes_from_tip(m_curve, tip);
    const Vector end = row(x, nodes.back());
    nodes.pop_back();
    const Vector old_direction = (row(x, tip) - end).normalized();
    const Vector outwards = (end - center).normalized();
    const double along = old_direction.dot(outwards);
    const Vector across = outwards - along * old_direction;
    const double tangent = across.norm() / along;
    const Vector direction =
        along > 0 && tangent < max_tangent
            ? outwards
            : Vector((old_direction + max_tangent * across.normalized()).normalized());
    for(const std::size_t v : nodes) set_row(x, v, end + (row(x, v) - end).norm() * direction);
  }

  Guard& m_guard;
  const Network& m_curve;
  std::vector<std::size_t> m_ends; // with their initial numbers
  Ray_sphere m_sphere;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_CLOSING_RAYS_H
