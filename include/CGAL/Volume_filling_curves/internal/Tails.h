// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_TAILS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_TAILS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_parameters.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/Medial_thickness.h>
#include <CGAL/Volume_filling_curves/internal/Tail_directions.h>
#include <CGAL/Volume_filling_curves/internal/Tail_turn_test.h>
#include <CGAL/Volume_filling_curves/internal/strands.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A knot in an open curve lasts only if no strand slips off an end. While they flow, components whose
// ends are all pinned therefore have tails: pinned nodes that run straight from each end to beyond a
// sphere around everything. As long as the curve stays inside, the type of the curve, closed outside
// of the sphere, cannot change. The usual closure of an open knot goes from the ends away from the
// mean of the nodes, and so do the tails, at first and on request. They vanish with this object.
// Components with a free end have none: there a strand can slip off anyway. Near-linear.
template <typename Network>
class Tails
{
  using Traits = typename Network::Traits;
  using Point_3 = typename Traits::Point_3;
  using Guard = Isotopy_guard_3<Traits>;

public:
  // Adds nothing yet.
  explicit Tails(Network& curve) : m_curve(curve) { find_ends(); }

  Tails(const Tails&) = delete;
  Tails& operator=(const Tails&) = delete;
  ~Tails() { remove_from(m_curve); }

  // returns a copy of a curve that has tails, without them
  static Network without(const Network& curve)
  {
    Network copy(curve);
    copy.m_record.reset();
    remove_from(copy);
    return copy;
  }

  bool are_needed() const { return !m_ends.empty(); }

  // Adds the tails for a flow, and sets its thickness if none is given, since the measure must not
  // see them. Does nothing if a length is not positive and finite: the flow will refuse it.
  // \pre the curve is embedded and has no garbage
  template <typename ConcurrencyTag>
  void grow(Curve_flow_parameters& parameters)
  {
    if(!are_needed() || parameters.number_of_directions == 0) return;
    if(parameters.thickness == 0)
      parameters.thickness =
          Medial_thickness<Network, ConcurrencyTag>(m_curve, parameters.number_of_directions)();
    const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
    if(!is_positive(parameters.thickness) || !is_positive(parameters.spacing)) return;
    set_ball(parameters.thickness);
    const std::vector<Point_3> tips = Tail_directions<Network>(m_curve, m_ends, m_ball).tips();
    for(std::size_t k = 0; k < m_ends.size(); ++k) append(m_ends[k], tips[k]);
    divide(largest_spacing * parameters.spacing * parameters.thickness);
    Guard(m_curve).collect_garbage();
  }

  // Turns the tails by a small angle to where they point away from the mean of the nodes as they are
  // now, as far as that is certified. Returns whether they moved. \pre there is no garbage
  bool turn_outwards(double clearance)
  {
    Guard guard(m_curve);
    guard.set_clearance(clearance);
    const Vector center = own_mean();
    bool have_moved = false;
    for(const std::size_t tip : tips(m_curve)) {
      Vector_field x = coordinates(m_curve);
      turn(tip, center, x);
      have_moved |= guard.move_nodes(x, least_fraction) > 0;
    }
    return have_moved;
  }

  // the length of all tails
  double length() const { return m_length; }

  // Tells whether the curve is inside the sphere, and a step farther in, so that it was all the time.
  bool hold() const
  {
    if(m_length == 0) return true;
    for(std::size_t v = 0; v < m_curve.number_of_nodes(); ++v)
      if(!m_curve.is_pinned(v) &&
         !((to_vector(m_curve.point(v)) - m_ball.center).norm() < m_inner_radius))
        return false;
    return true;
  }

  // Tells whether the usual closure of the curve as it stands has the type that it had: whether the
  // tails could turn and point away from where the mean of the nodes is now, and meet nothing.
  bool can_turn_outwards() const
  {
    Tail_turn_test<Network> test(m_curve, m_ball, own_mean());
    for(const std::size_t tip : tips(m_curve)) test.add_tail(nodes_from(tip));
    return test();
  }

private:
  static constexpr double radius_over_size = 1.25, margin_over_thickness = 5;
  static constexpr double largest_spacing = 1.5; // in units of the flow's, which splits from 2 on
  static constexpr double least_fraction = 1. / 64;

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
    m_ball.center = x.colwise().mean().transpose();
    const double size = (x.rowwise() - m_ball.center.transpose()).rowwise().norm().maxCoeff();
    const double margin = (std::min)(margin_over_thickness * thickness, 100 * size);
    m_ball.radius = radius_over_size * size + margin;
    m_inner_radius = m_ball.radius - (std::min)(thickness, margin / 2);
  }

  void append(std::size_t end, const Point_3& tip)
  {
    m_length += (to_vector(tip) - to_vector(m_curve.point(end))).norm();
    const std::size_t v = m_curve.m_topology.add_leaf(end);
    m_curve.m_points.push_back(tip);
    if(m_curve.m_record) m_curve.m_record->add_obstacle();
    m_curve.set_pinned(v);
  }

  // Certified, since the middle of an edge is rounded. Leaves garbage.
  void divide(double length)
  {
    Guard guard(m_curve);
    for(const std::size_t tip : tips(m_curve)) divide(guard, m_curve.incident_edge(tip, 0), length);
  }

  void divide(Guard& guard, std::size_t e, double length)
  {
    if(edge_vector(m_curve, e).norm() <= length) return;
    const Vector a = to_vector(m_curve.point(m_curve.source(e)));
    const Vector b = to_vector(m_curve.point(m_curve.target(e)));
    if(!guard.insert_node(e, to_point(Vector((a + b) / 2), m_curve.traits()))) return;
    m_curve.set_pinned(m_curve.number_of_nodes() - 1);
    const std::size_t f = m_curve.number_of_edges() - 1;
    divide(guard, e, length);
    divide(guard, f, length);
  }

  // Of ends, those of the curve itself come from the input.
  static bool is_tip(const Network& curve, std::size_t v)
  {
    return curve.degree(v) == 1 && curve.origin(v) == curve.null_node();
  }

  static std::vector<std::size_t> tips(const Network& curve)
  {
    std::vector<std::size_t> result;
    for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
      if(is_tip(curve, v)) result.push_back(v);
    return result;
  }

  // returns the nodes of a tail, from the tip to the end of the curve
  std::vector<std::size_t> nodes_from(std::size_t tip) const
  {
    std::vector<std::size_t> nodes = {tip, m_curve.neighbor(tip, 0)};
    while(m_curve.origin(nodes.back()) == m_curve.null_node()) {
      const std::size_t v = nodes.back(), before = nodes[nodes.size() - 2];
      nodes.push_back(m_curve.neighbor(v, m_curve.neighbor(v, 0) == before ? 1 : 0));
    }
    return nodes;
  }

  // the mean of the nodes of the curve itself
  Vector own_mean() const
  {
    Vector sum = coordinates(m_curve).colwise().sum().transpose();
    auto n = static_cast<double>(m_curve.number_of_nodes());
    for(const std::size_t tip : tips(m_curve)) {
      std::vector<std::size_t> nodes = nodes_from(tip);
      nodes.pop_back();
      for(const std::size_t v : nodes) sum -= to_vector(m_curve.point(v));
      n -= static_cast<double>(nodes.size());
    }
    return sum / n;
  }

  void turn(std::size_t tip, const Vector& center, Vector_field& x) const
  {
    constexpr double largest_tangent = 0.05;
    std::vector<std::size_t> nodes = nodes_from(tip);
    const Vector end = row(x, nodes.back());
    nodes.pop_back();
    const Vector old_direction = (row(x, tip) - end).normalized();
    const Vector outwards = (end - center).normalized();
    const double along = old_direction.dot(outwards);
    const Vector across = outwards - along * old_direction;
    const double tangent = across.norm() / along;
    const Vector direction =
        along > 0 && tangent < largest_tangent
            ? outwards
            : Vector((old_direction + largest_tangent * across.normalized()).normalized());
    for(const std::size_t v : nodes)
      x.row(static_cast<Eigen::Index>(v)) =
          (end + (row(x, v) - end).norm() * direction).transpose();
  }

  static void remove_from(Network& curve)
  {
    const std::vector<std::size_t> all_tips = tips(curve);
    for(std::size_t v : all_tips)
      while(is_tip(curve, v)) {
        const std::size_t next = curve.neighbor(v, 0);
        curve.m_topology.remove_leaf(v);
        v = next;
      }
    if(!all_tips.empty()) Guard(curve).collect_garbage();
  }

  Network& m_curve;
  std::vector<std::size_t> m_ends; // as they were numbered at first
  Ball m_ball;
  double m_inner_radius = 0, m_length = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_TAILS_H
