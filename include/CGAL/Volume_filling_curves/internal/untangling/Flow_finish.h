// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/flow/Step_size.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/ropelength/Ropelength_descent.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/untangling/Flow_stop_rules.h>
#include <CGAL/Volume_filling_curves/internal/untangling/rescale_to_length.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Final motion of a simple loop: straight to a regular polygon of at least 64 nodes. The flow would
// take long, since its preconditioner keeps lengths of edges, not angles. The circle lies in the
// plane with the largest projected area, has the curve's length, and is rotated to minimize the
// motion of the nodes. Nodes move as far as certified, in a few steps.
template <typename Network>
class Round_polygon
{
public:
  // \pre the curve is a single closed component
  explicit Round_polygon(const Network& curve)
      : m_x(coordinates(curve)), m_length(total_length(curve)), m_center(centroid(m_x))
  {
    const Eigen::Index n = m_x.rows();
    Vector area;
    for(Eigen::Index v = 0; v < n; ++v) area += offset(v).cross(offset((v + 1) % n));
    m_first = area.unitOrthogonal();
    m_second = area.normalized().cross(m_first);
    double real = 0, imaginary = 0; // of the sum of the nodes, each turned back by its angle
    for(Eigen::Index v = 0; v < n; ++v) {
      const auto [c, s] = cos_sin(turns(v));
      const double x = offset(v).dot(m_first), y = offset(v).dot(m_second);
      real += c * x + s * y;
      imaginary += c * y - s * x;
    }
    const Vector first = (real * m_first + imaginary * m_second).normalized();
    m_second = (real * m_second - imaginary * m_first).normalized();
    m_first = first;
  }

  // one row per node
  Vector_field nodes() const
  {
    const auto n = static_cast<double>(m_x.rows());
    const double radius = m_length / (2 * n * cos_sin(0.5 / n)[1]);
    Vector_field result(m_x.rows(), 3);
    for(Eigen::Index v = 0; v < m_x.rows(); ++v) {
      const auto [c, s] = cos_sin(turns(v));
      set_row(result, v, m_center + radius * (c * m_first + s * m_second));
    }
    return result;
  }

private:
  Vector offset(Eigen::Index v) const { return row(m_x, v) - m_center; }

  double turns(Eigen::Index v) const
  {
    return static_cast<double>(v) / static_cast<double>(m_x.rows());
  }

  Vector_field m_x;
  double m_length;
  Vector m_center, m_first, m_second;
};

// Removes every other node until at most `most` remain or none can be removed.
template <typename Guard>
void thin_out(Guard& guard, std::size_t most)
{
  const auto& curve = guard.curve();
  for(std::size_t before = 0; before != curve.number_of_nodes() && curve.number_of_nodes() > most;
      guard.collect_garbage()) {
    before = curve.number_of_nodes();
    for(std::size_t v = 1; v < before; v += 2) guard.remove_node(v);
  }
}

// Halves edges until none is longer than `longest`.
template <typename Guard>
void halve_long_edges(Guard& guard, double longest)
{
  const auto& curve = guard.curve();
  for(bool is_coarse = true; is_coarse; guard.collect_garbage()) {
    is_coarse = false;
    for(const std::size_t e : curve.edges())
      if(edge_vector(curve, e).norm() > longest) is_coarse |= halve_edge(guard, e);
  }
}

// Returns whether the nodes have reached the circle.
template <typename Guard>
bool move_to_circle(Guard& guard)
{
  constexpr int max_moves = 100; // if each goes the least fraction, a fifth of the way is left
  for(int k = 0; k < max_moves; ++k) {
    const double fraction =
        guard.move_nodes(Round_polygon<typename Guard::Curve_network>(guard.curve()).nodes(),
                         Step_size::min_fraction);
    if(fraction == 1) return true;
    if(fraction == 0) return false;
  }
  return false;
}

// Returns whether the curve is round now; if not, it may have got rounder. Of many nodes, few go
// there, and the others between them: a triangle of 10,000 nodes had millions of pairs of edges
// that could meet, which took minutes.
// \pre the curve is a single closed component without pinned nodes and garbage
template <typename Guard>
bool make_round(Guard& guard)
{
  constexpr std::size_t min_number_of_nodes = 64; // a 64-gon is within 0.12 % of its circle
  constexpr std::size_t max_nodes_at_once = 512;
  const auto& curve = guard.curve();
  const std::size_t wanted = curve.number_of_nodes();
  const auto edge = [&](std::size_t n) { return total_length(curve) / static_cast<double>(n); };
  const Clearance_scope<Guard> scope(guard, 0);
  thin_out(guard, max_nodes_at_once);
  halve_long_edges(guard, edge(min_number_of_nodes));
  bool is_round = move_to_circle(guard);
  const auto n = [&] { return curve.number_of_nodes(); };
  for(std::size_t before = 0; before != n() && 3 * n() < 2 * wanted;) {
    before = n();
    halve_long_edges(guard, edge((std::min)(2 * before, wanted)));
    is_round = is_round && move_to_circle(guard);
  }
  return is_round;
}

// Work after a flow: a descent to a lower ropelength and, for unknots, shrinking to their final
// length and a round shape.
template <typename Flow>
class Flow_finish
{
  using Guard = typename Flow::Guard;
  using Rules = Flow_stop_rules<Flow>;

public:
  Flow_finish(const Untangling_context<Flow>& run,
              Flow& flow,
              const Flow_start& start,
              Rules& rules)
      : m_run(run), m_flow(flow), m_start(start), m_rules(rules)
  {}

  // The descent ignores boundaries.
  bool can_lower_ropelength(Untangling_status status) const
  {
    const bool is_at_end = status == Untangling_status::CONVERGED ||
                           (status == Untangling_status::STALLED && m_start.is_last);
    return !Guard::Boundary::is_bounded && m_run.parameters.lower_ropelength && is_at_end &&
           !m_rules.is_curve_too_thin() && !m_rules.is_at_limit() &&
           m_flow.curve().number_of_components() > 0 && is_closed_everywhere(m_flow.curve()) &&
           !has_constrained_node(m_flow.curve());
  }

  // Returns the status of the run: that of the flow, unless the descent is interrupted or unties a
  // stalled curve.
  Untangling_status lower_ropelength(Untangling_status status_of_flow)
  {
    m_run.watch.begin(Run_stage::TIGHTENING);
    Untangling_status status = status_of_flow;
    Ropelength_descent<Guard, typename Flow::Concurrency_tag> descend(m_run.guard,
                                                                      m_flow.thickness() / 2);
    m_is_ropelength_lowered = descend([&] {
      m_flow.note_step();
      m_run.watch.note(m_flow);
      m_run.visitor.on_iteration(m_flow);
      status = m_rules.status_beyond(status_of_flow);
      return status == status_of_flow;
    });
    if(descend.is_stopped() && status == status_of_flow) status = m_run.status_when_stopped();
    return status;
  }

  // Gives unknots their settled length, which the last step missed, and a round shape.
  void settle()
  {
    const bool stops_at_proof = m_run.parameters.stop_at_proof;
    const bool is_input = stops_at_proof && m_rules.is_unknot_from_start();
    const bool is_settling = stops_at_proof || m_rules.ends_round();
    if(is_settling && !is_input && m_flow.length() <= m_rules.settled_length())
      rescale_to_length(m_run.guard, m_rules.settled_length());
    if(m_rules.ends_round() || (m_start.makes_round && m_flow.curve().number_of_components() == 1))
      m_is_round = make_round(m_run.guard);
    m_flow.update();
  }

  bool is_round() const { return m_is_round; }
  bool is_ropelength_lowered() const { return m_is_ropelength_lowered; }

private:
  const Untangling_context<Flow>& m_run;
  Flow& m_flow;
  const Flow_start& m_start;
  Rules& m_rules;
  bool m_is_round = false, m_is_ropelength_lowered = false;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_FLOW_FINISH_H
