// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef VFC_FLOW_OBSERVER_H
#define VFC_FLOW_OBSERVER_H

#include "files/Frames.h"
#include "options/numbers.h"
#include "session/Progress.h"
#include "session/Session.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/internal/vocabulary/Curve_run_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Run_progress.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace vfc {

// Follows a flow: shows the progress, writes the frames, and stops it if the user interrupts.
class Flow_observer : public CGAL::Volume_filling_curves::Default_curve_flow_visitor
{
public:
  using Parameters = CGAL::Volume_filling_curves::Curve_run_parameters;

  // Takes the parameters of the run, and the gradient norm at which it ends, or 0.
  Flow_observer(const Session& session,
                const Parameters& parameters,
                double tolerance,
                Frames frames)
      : m_session(session),
        m_parameters(parameters),
        m_tolerance(tolerance),
        m_frames(std::move(frames)),
        m_progress(session.console())
  {}

  template <typename Flow>
  void on_start(const Flow& flow)
  {
    m_start_seconds = m_session.seconds();
    m_start_gradient = flow.gradient_norm();
    m_frames.add(flow.statistics().iterations, flow.curve());
  }

  void on_thin_domain(const CGAL::Volume_filling_curves::Thickness_fit& fit)
  {
    m_session.console().warn("the inside is too thin for the thickness " + to_text(fit.thickness) +
                             " in " + to_text(100 * fit.thin_fraction) +
                             " % of its volume; a thickness of " + to_text(fit.fitting_thickness) +
                             " would fit");
  }

  template <typename Flow>
  void on_iteration(const Flow& flow)
  {
    const std::size_t iteration = flow.statistics().iterations;
    m_frames.add(iteration, flow.curve());
    if(m_has_stages || !m_progress.is_due()) return;
    m_progress.show(part_done(iteration, flow.gradient_norm()),
                    counted(iteration, "iteration") + ", length " + to_text(flow.length()) +
                        ", gradient " + to_text(flow.gradient_norm()));
  }

  template <typename Flow>
  bool go_further(const Flow&)
  {
    return !is_interruption_requested();
  }

  // Shows a run by its stages, from its first moment on.
  bool on_progress(const CGAL::Volume_filling_curves::Run_progress& progress)
  {
    m_has_stages = true;
    if(progress.expected_nodes > 0 && !std::exchange(m_is_announced, true)) announce(progress);
    if(m_progress.is_due())
      m_progress.show(progress.fraction, std::string(to_string(progress.stage)) + ", " +
                                             two_digits(progress.seconds) + " s, " +
                                             std::to_string(progress.iterations) + " iterations, " +
                                             std::to_string(progress.nodes) + " nodes, length " +
                                             to_text(progress.length));
    return !is_interruption_requested();
  }

  // Completes what was written, when the run is over.
  void finish(std::size_t iterations, const Curve& result) { m_frames.finish(iterations, result); }

  bool on_search(const CGAL::Volume_filling_curves::Search_progress& progress)
  {
    if(m_progress.is_due())
      m_progress.show(0,
                      counted(progress.sweeps, "sweep") + ", " + counted(progress.edges, "edge"));
    return !is_interruption_requested();
  }

private:
  static std::string two_digits(double x)
  {
    const double unit = x > 0 ? std::pow(10., std::floor(std::log10(x)) - 1) : 1;
    return to_text(std::round(x / unit) * unit);
  }

  void announce(const CGAL::Volume_filling_curves::Run_progress& progress) const
  {
    if(progress.default_thickness > 0)
      m_session.console().warn(
          "the thickness is " + to_text(progress.thickness) + ", not " +
          to_text(progress.default_thickness) + ", a quarter of the radius of the widest ball " +
          "inside, since there would be more than 200000 nodes; --thickness takes any other");
    m_session.console().note("expected: length " + two_digits(progress.expected_length) + ", " +
                             two_digits(static_cast<double>(progress.expected_nodes)) + " nodes, " +
                             two_digits(progress.expected_seconds) + " s");
  }

  // The stop rule that is closest decides. The gradient falls exponentially in the end.
  double part_done(std::size_t iteration, double gradient) const
  {
    const double iterations =
        static_cast<double>(iteration) / static_cast<double>(m_parameters.number_of_iterations);
    const double time = (m_session.seconds() - m_start_seconds) / m_parameters.time_limit;
    const double fall =
        std::log(gradient / m_start_gradient) / std::log(m_tolerance / m_start_gradient);
    return (std::max)({iterations, time, std::isfinite(fall) ? fall : 0});
  }

  const Session& m_session;
  Parameters m_parameters;
  double m_tolerance;
  Frames m_frames;
  Progress m_progress;
  bool m_has_stages = false, m_is_announced = false; // of a filling
  double m_start_seconds = 0, m_start_gradient = 0;
};

} // namespace vfc

#endif // VFC_FLOW_OBSERVER_H
