// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_RUNNER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_RUNNER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_state.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Runner of the stages of a filling, one after another, each with its own parameters, until the
// curve has settled or the run ends. A resumed run makes the same decisions, skips the stages that
// were complete, and continues in the middle of the next one.
template <typename Flow>
class Filling_stage_runner
{
  using Guard = typename Flow::Guard;
  using Thickness = typename Flow::Thickness;
  using Parameters = Filling_parameters<typename Flow::Point_3>;

public:
  // Takes the thickness to start from. If the run resumes, the curve is that of its state.
  Filling_stage_runner(Guard& guard,
                       const Parameters& parameters,
                       const Thickness& thickness,
                       Run_watch& watch,
                       Run_visitor<Flow>& visitor,
                       Filling_state& state)
      : m_parameters(parameters),
        m_shape(shape_goal(parameters)),
        m_watch(watch),
        m_flow(guard, parameters, thickness, state.stage > 0),
        m_visitor(visitor),
        m_state(state),
        m_resumed_stage(std::exchange(state.stage, 0))
  {
    if(m_resumed_stage > 0) {
      m_flow.resume(state.flow, parameters, thickness);
    } else {
      m_visitor.on_start(m_flow);
    }
  }

  const Flow& flow() const { return m_flow; }

  // the reason to end before the curve has settled, if any
  const std::optional<Filling_status>& end() const { return m_end; }

  // the record of the current stage, empty unless that polishes
  const Polishing_record& polishing() const { return m_state.polishing; }

  // how much the curve has grown in the current stage
  double growth() const { return m_state.lengths.growth(); }

  // Returns a number decided between stages, by this run or by the one that it resumes.
  template <typename Decide>
  double decide(const Decide& decide)
  {
    std::vector<double>& numbers = m_state.numbers;
    if(m_next_number == numbers.size()) numbers.push_back(static_cast<double>(decide()));
    return numbers[m_next_number++];
  }

  // The same, for a decision that takes long. If it is cut short, which ends the run, it is false,
  // and a resumed run decides anew.
  template <typename Decide>
  bool decide_in_time(const Decide& decide)
  {
    if(m_next_number < m_state.numbers.size()) return m_state.numbers[m_next_number++] != 0;
    const bool decision = in_time(decide);
    if(m_end) return false;
    m_state.numbers.push_back(decision);
    ++m_next_number;
    return decision;
  }

  // Likewise some points, or none.
  template <typename Decide>
  std::vector<Vector> decide_points(const Decide& decide_points)
  {
    if(m_next_points == m_state.point_counts.size()) {
      const std::vector<Vector> points = in_time(decide_points);
      if(m_end) return {};
      m_state.points.insert(m_state.points.end(), points.begin(), points.end());
      m_state.point_counts.push_back(points.size());
    }
    const auto begin = m_state.points.begin() + m_next_point;
    m_next_point += static_cast<std::ptrdiff_t>(m_state.point_counts[m_next_points++]);
    return {begin, m_state.points.begin() + m_next_point};
  }

  // Runs a stage, with the required thickness.
  void run(const Filling_stage& stage, const Thickness& thickness_asked_for)
  {
    const Thickness thickness = stage.thickness * thickness_asked_for;
    if(m_end || ++m_state.stage < m_resumed_stage) return;
    m_flow.set_direction_field(m_parameters.direction_field,
                               stage.direction_weight * m_parameters.direction_weight);
    m_flow.set_shape(m_shape.in_units_of(stage.thickness).with_bends_of(stage.roundness),
                     stage.phase);
    if(m_state.stage == m_resumed_stage)
      resume(stage, thickness);
    else
      start(stage, thickness);
    while(!(m_end = end_between_steps(stage)) && !is_over(stage)) {
      const bool has_moved = step();
      m_state.idle_steps.note(has_moved);
      note();
      record(stage, has_moved);
      m_flow.set_max_displacement(m_state.max_displacement *= stage.cooling);
      m_visitor.on_iteration(m_flow);
    }
  }

private:
  // whether there is time for another step
  bool is_time_left() const { return m_watch.leaves(m_seconds_of_step); }

  // Decides, and ends the run if that is cut short.
  template <typename Decide>
  auto in_time(const Decide& decide)
  {
    if(m_watch.is_saving()) m_state.flow = m_flow.state();
    m_watch.checkpoint(Run_watch::Checkpoint::PART);
    const auto decision = decide();
    if(m_watch.must_stop()) {
      m_end = m_watch.is_interrupted() ? Filling_status::INTERRUPTED : Filling_status::LIMIT;
      m_watch.checkpoint(Run_watch::Checkpoint::END_IN_PART);
    }
    return decision;
  }

  void note()
  {
    m_state.statistics = m_flow.statistics();
    m_state.gradient_norm = m_flow.gradient_norm();
    m_watch.note_fraction(static_cast<double>(m_state.statistics.iterations) /
                          expected_iterations());
    m_watch.note(m_flow);
  }

  // A tree of fingers opens, settles and is refined in 21 steps, or opens, bends and is polished in
  // 19 or 20, or in 23 or 24 where it cannot be dense, unless it jams, which is rare; a circle
  // grows in 150 to 500. A required length takes several times as many.
  double expected_iterations() const
  {
    const double of_tree = m_shape.is_given() ? 20 : 21;
    const double all = m_parameters.start == Filling_start::TREE ? of_tree : 300;
    return (std::min)(all, static_cast<double>(m_parameters.number_of_iterations));
  }

  Curve_flow_parameters parameters_of(const Filling_stage& stage) const
  {
    Curve_flow_parameters p = m_parameters;
    p.screening *= stage.screening;
    p.number_of_directions = (std::min)(p.number_of_directions, stage.directions);
    p.coupling *= stage.coupling;
    constexpr double max_spacing = 1; // of a flow
    p.spacing = (std::min)((std::max)(p.spacing / stage.thickness, stage.spacing), max_spacing);
    p.max_radius = (std::min)(p.max_radius, stage.max_radius);
    p.max_displacement = (std::min)(p.max_displacement / stage.thickness, stage.max_displacement);
    return p;
  }

  void start(const Filling_stage& stage, const Thickness& thickness)
  {
    const Curve_flow_parameters p = parameters_of(stage);
    m_flow.keep_apart(stage.separation);
    m_state.max_displacement = p.max_displacement;
    if(stage.phase == Shape_phase::POLISHING)
      m_flow.go_on(p, thickness); // edges stay as they are
    else
      m_flow.set_parameters(p, thickness);
    m_state.idle_steps = {};
    m_state.lengths = {};
    m_state.polishing = {};
    record(stage, true);
  }

  // A step that the guard refuses says nothing of the room for the limits: the next may move.
  void record(const Filling_stage& stage, bool has_moved)
  {
    m_state.lengths.add(m_flow.length());
    if(stage.phase == Shape_phase::POLISHING && has_moved)
      m_state.polishing.add(m_flow.check_shape().exceeding_nodes.size(),
                            m_flow.curve().number_of_nodes());
  }

  // Whether the stage is complete, or would not get further: where the limits are out of reach,
  // polishing would empty the domain.
  bool is_over(const Filling_stage& stage) const
  {
    if(m_state.lengths.has_settled(stage.window, stage.change_of_length)) return true;
    if(growth() > stage.max_growth) return true;
    return stage.phase == Shape_phase::POLISHING &&
           (m_state.idle_steps.are_too_many() || m_state.polishing.is_done() ||
            m_state.polishing.are_limits_out_of_reach());
  }

  // Goes on in the middle of a stage. The curve may have grown since the flow was checked, hence
  // the slack. \throws Run_state_error if the state would exhaust memory
  void resume(const Filling_stage& stage, const Thickness& thickness)
  {
    constexpr double slack = 8;
    Curve_flow_parameters p = parameters_of(stage);
    const auto& curve = m_flow.curve();
    const double length = length_in_units(curve, thickness.at_each(curve.points()));
    if(has_too_many_nodes(length / slack, p.spacing, 1))
      throw Run_state_error("the state contradicts itself: its thickness is too small");
    m_flow.keep_apart(stage.separation);
    p.max_displacement = m_state.max_displacement;
    m_flow.go_on(p, thickness);
    m_visitor.on_start(m_flow);
  }

  bool step()
  {
    m_seconds_of_step = 0;
    const Stage_timer timer(m_seconds_of_step);
    return m_flow.step();
  }

  // Asking again, as a resumed run does, changes nothing.
  std::optional<Filling_status> end_between_steps(const Filling_stage& stage)
  {
    const std::optional<Filling_status> end = end_before_step(stage);
    if(end == Filling_status::STALLED || !m_watch.is_saving()) return end;
    m_state.flow = m_flow.state();
    m_watch.checkpoint(end ? Run_watch::Checkpoint::END : Run_watch::Checkpoint::STEP);
    return end;
  }

  // A curve that cannot be polished further has settled, as near to its shape as it could. A limit
  // ends no stage that is over: the last one may have reached the goal.
  std::optional<Filling_status> end_before_step(const Filling_stage& stage)
  {
    if(m_watch.is_interrupted()) return Filling_status::INTERRUPTED;
    const bool is_at_limit =
        m_flow.statistics().iterations >= m_parameters.number_of_iterations || !is_time_left();
    if(is_at_limit && !is_over(stage)) return Filling_status::LIMIT;
    if(stage.phase != Shape_phase::POLISHING && m_state.idle_steps.are_too_many())
      return Filling_status::STALLED;
    if(!m_visitor.go_further(m_flow)) return Filling_status::INTERRUPTED;
    return std::nullopt;
  }

  const Parameters& m_parameters;
  const Shape_goal m_shape; // may be empty
  Run_watch& m_watch;
  Flow m_flow;
  Run_visitor<Flow>& m_visitor;
  Filling_state& m_state;
  std::size_t m_next_number = 0, m_next_points = 0; // of those decided
  std::ptrdiff_t m_next_point = 0;
  std::optional<Filling_status> m_end;
  double m_seconds_of_step = 0;      // of the last one
  const std::size_t m_resumed_stage; // 0 if the run has started anew
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_RUNNER_H
