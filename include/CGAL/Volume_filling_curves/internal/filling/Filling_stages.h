// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGES_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGES_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Length_window.h>
#include <CGAL/Volume_filling_curves/internal/flow/Idle_steps.h>
#include <CGAL/Volume_filling_curves/internal/state/Replay_log.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// The figures of a flow after its last complete step.
struct Filling_record
{
  Curve_flow_statistics statistics;
  double gradient_norm = std::numeric_limits<double>::quiet_NaN();
};

// The stages of a filling, one after another, each with parameters of its own, until they have
// settled or the run is to end. A run that resumes takes the same way, with the same decisions,
// leaves out the stages before the one that it was in, and goes on in the middle of that.
template <typename Flow, typename Visitor>
class Filling_stages
{
  using Guard = typename Flow::Guard;
  using Thickness = typename Flow::Thickness;
  using Parameters = Filling_parameters<typename Flow::Point_3>;

public:
  // Takes the thickness to start from. If the saver has a state to read, the curve is the one of
  // that state.
  Filling_stages(Guard& guard,
                 const Parameters& parameters,
                 const Thickness& thickness,
                 Run_watch& watch,
                 Visitor& visitor,
                 Run_saver& saver,
                 Filling_record& record)
      : m_parameters(parameters),
        m_watch(watch),
        m_guard(guard),
        m_flow(guard, parameters, thickness, saver.reader()),
        m_visitor(visitor),
        m_saver(saver),
        m_record(record)
  {
    if(State_reader* const reader = m_saver.reader())
      (*reader)(m_resumed_stage, m_decisions);
    else
      m_visitor.on_start(m_flow);
  }

  const Flow& flow() const { return m_flow; }

  // why the run is to end, if it is not because the curve has settled
  const std::optional<Filling_status>& end() const { return m_end; }

  // whether there is time for another step, or for what takes as long
  bool is_time_left() const { return m_watch.leaves(m_seconds_of_step); }

  // Returns what is decided between stages, by this run or the one that it goes on with.
  template <typename Decide>
  auto decide(const Decide& decide)
  {
    return m_decisions(decide);
  }

  void run(const Filling_stage& stage, const Thickness& thickness)
  {
    if(m_end || ++m_stage < m_resumed_stage) return;
    m_flow.set_direction_field(m_parameters.direction_field,
                               stage.direction_weight * m_parameters.direction_weight);
    if(m_stage == m_resumed_stage)
      resume(thickness);
    else
      start(stage, thickness);
    while(!(m_end = end_between_steps()) &&
          !m_lengths.has_settled(stage.window, stage.change_of_length)) {
      m_idle_steps.note(step());
      note();
      m_lengths.add(m_flow.length());
      m_flow.set_max_displacement(m_displacement *= stage.cooling);
      m_visitor.on_iteration(m_flow);
    }
  }

private:
  void note()
  {
    m_record.statistics = m_flow.statistics();
    m_record.gradient_norm = m_flow.gradient_norm();
    m_watch.note_fraction(static_cast<double>(m_record.statistics.iterations) /
                          expected_iterations());
    m_watch.note(m_flow);
  }

  // A tree of fingers opens, settles and is refined in 21; a circle grows in 150 to 500.
  double expected_iterations() const
  {
    const double all = m_parameters.start == Filling_start::TREE ? 21 : 300;
    return (std::min)(all, static_cast<double>(m_parameters.number_of_iterations));
  }

  // Goes on in the middle of a stage.
  void resume(const Thickness& thickness)
  {
    m_flow.resume(*m_saver.reader(), thickness);
    (*m_saver.reader())(m_lengths, m_displacement, m_idle_steps);
    m_visitor.on_start(m_flow);
  }

  void write_state(State_writer& writer) const
  {
    writer(m_flow.curve(), m_guard, m_stage, m_decisions);
    writer(m_flow, m_lengths, m_displacement, m_idle_steps);
  }

  void start(const Filling_stage& stage, const Thickness& thickness)
  {
    Curve_flow_parameters p = m_parameters;
    p.screening *= stage.screening;
    p.number_of_directions = (std::min)(p.number_of_directions, stage.directions);
    p.spacing = (std::max)(p.spacing, stage.spacing);
    p.max_radius = (std::min)(p.max_radius, stage.max_radius);
    m_flow.keep_apart(stage.separation);
    p.max_displacement = m_displacement = (std::min)(p.max_displacement, stage.max_displacement);
    m_flow.set_parameters(p, thickness);
    m_lengths = {};
    m_lengths.add(m_flow.length());
  }

  bool step()
  {
    m_seconds_of_step = 0;
    const Stage_timer timer(m_seconds_of_step);
    return m_flow.step();
  }

  // To ask again, as a run does that resumes, changes nothing.
  std::optional<Filling_status> end_between_steps()
  {
    const std::optional<Filling_status> end = end_before_step();
    if(end != Filling_status::STALLED)
      m_saver.offer(end.has_value(), [this](State_writer& writer) { write_state(writer); });
    return end;
  }

  std::optional<Filling_status> end_before_step()
  {
    if(m_watch.is_interrupted()) return Filling_status::INTERRUPTED;
    if(m_flow.statistics().iterations >= m_parameters.number_of_iterations || !is_time_left())
      return Filling_status::LIMIT;
    if(m_idle_steps.are_too_many()) return Filling_status::STALLED;
    if(!m_visitor.go_further(m_flow)) return Filling_status::INTERRUPTED;
    return std::nullopt;
  }

  const Parameters& m_parameters;
  Run_watch& m_watch;
  Guard& m_guard;
  Flow m_flow;
  Visitor& m_visitor;
  Run_saver& m_saver;
  Filling_record& m_record;
  Replay_log m_decisions;
  std::size_t m_stage = 0, m_resumed_stage = 0; // from 1; 0 if the run has started anew
  std::optional<Filling_status> m_end;
  double m_seconds_of_step = 0; // the last one took

  // of the stage
  Length_window m_lengths;
  double m_displacement = 0; // the largest, in units of the thickness
  Idle_steps m_idle_steps;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGES_H
