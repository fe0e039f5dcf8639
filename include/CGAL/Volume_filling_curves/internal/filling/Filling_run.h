// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/domain/containment.h>
#include <CGAL/Volume_filling_curves/internal/filling/Domain_survey.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filler.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>
#include <CGAL/Volume_filling_curves/internal/filling/Neck_search.h>
#include <CGAL/Volume_filling_curves/internal/filling/Port_arcs.h>
#include <CGAL/Volume_filling_curves/internal/filling/Start_curves.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/scale.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/guard/Garbage_scope.h>
#include <CGAL/Volume_filling_curves/internal/guard/Motion_record.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Run of fill() in a surveyed domain: warns if it is too thin, places arcs between the ports, or a
// circle in each part if no curves are given, grows fingers unless the curves should grow from
// circles, fills the domain, and reports unfilled regions and their cause.
template <typename Traits, typename Domain, typename ConcurrencyTag>
class Filling_run
{
  using Network = Curve_network_3<Traits>;
  using Point_3 = typename Traits::Point_3;
  using Survey = Domain_survey<Traits, Domain, ConcurrencyTag>;
  using Flow = Curve_flow_3<Traits, Domain, ConcurrencyTag>;
  using Unfilled = Unfilled_space<Network, typename Survey::Samples, ConcurrencyTag>;
  using Result = Filling_result<Point_3>;

public:
  // Takes the unit of the domain and of all lengths, in the caller's unit, the unit of the result.
  Filling_run(Network& curves, const Survey& survey, Run_visitor<Flow>& visitor, double unit)
      : m_curves(curves),
        m_survey(survey),
        m_domain(survey.samples().domain()),
        m_parameters(survey.parameters()),
        m_watch(survey.watch()),
        m_visitor(visitor),
        m_unit(unit),
        m_start(curves, survey, unit),
        m_fit(m_survey.thickness_fit()),
        m_saver(m_parameters, curves, m_watch, [this] { return fingerprint(); })
  {}

  // The curves remain unchanged if they, or the state to resume from, are refused.
  Result operator()()
  {
    Network input = m_curves;
    try {
      return fill();
    } catch(const std::invalid_argument&) {
      m_curves = std::move(input);
      throw;
    }
  }

private:
  Result fill()
  {
    check_box();
    if(m_fit.thin_fraction > tolerated_unfilled_fraction) m_visitor.on_thin_domain(m_fit);
    m_start.place();
    announce();
    Result result = can_grow() ? grow() : stopped_at_start();
    result.necks = m_start.necks();
    check_necks(m_curves, result.necks);
    report_survey(result);
    scale_and_give_reason(result);
    return result;
  }

  // Whether there was time to survey the domain and to check the curves. After a survey that was
  // cut short, the run ends without saving a state: the circles may differ from those of a full
  // survey. A resumed run already has its curve.
  bool can_grow()
  {
    const bool is_surveyed = !m_watch.must_stop();
    return (m_start.check_in_time() && is_surveyed) || m_saver.is_resuming();
  }

  void announce()
  {
    const double r = m_survey.thickness().number();
    Run_progress& progress = m_watch.progress();
    progress.thickness = r;
    progress.default_thickness = m_survey.refused_thickness();
    progress.expected_length = m_survey.size().length(r);
    // a survey that was cut short has not checked the number
    constexpr double most = static_cast<double>(std::numeric_limits<std::size_t>::max() / 2);
    progress.expected_nodes =
        static_cast<std::size_t>((std::min)(m_survey.size().number_of_nodes(r), most));
    progress.expected_seconds = m_survey.size().seconds(r);
    m_watch.report();
  }

  // Distances that are up to twice too large are tolerated here.
  void check_box() const
  {
    const Bbox_3 box = m_domain.bbox();
    const double side = Space_of<Domain>::is_plane
                            ? (std::min)(box.x_span(), box.y_span())
                            : (std::min)({box.x_span(), box.y_span(), box.z_span()});
    if(m_survey.widest_radius() > side)
      throw std::invalid_argument("the domain contradicts itself: it reaches beyond its box");
  }

  // Fields enter by their values at the samples.
  std::string fingerprint() const
  {
    std::vector<double> fields;
    for(const Point_3& p : m_survey.samples().points()) {
      if(m_survey.thickness().varies()) fields.push_back(m_survey.thickness()(p));
      if(!m_parameters.direction_field) continue;
      for(const double x : m_parameters.direction_field(p)) fields.push_back(x);
    }
    Byte_archive archive;
    archive(fields);
    return run_fingerprint("fill", m_parameters) + domain_line(m_domain, m_curves.traits()) +
           hash_line("field", archive);
  }

  // The layer along the boundary that counts as outside for the flow. Thereby strands settle as
  // they would without a wall distance; strands pressed against it are crowded. A box of 20 x 10 x
  // 10 r ends uncrowded for distances of 1, 1.5 and 3 r; without a layer 2 to 22 % of the length
  // are crowded, with one as large as the distance 29 to 64 %.
  double layer() const
  {
    const double settled = m_parameters.wall == Wall::COVER ? 0.5 : 1.5; // in units of r
    const double r = m_survey.thickness().number();
    return (std::max)(m_parameters.wall_distance - settled * r, 0.);
  }

  Result grow()
  {
    m_saver.resume_curve(m_curves,
                         [this](const Network& curves) { check_inside(curves, m_domain); });
    Isotopy_guard_3<Traits, Domain> guard(m_curves, m_domain);
    const Garbage_scope scope(guard);
    guard.set_wall_distance(m_parameters.wall_distance, layer());
    if(m_parameters.certificate) guard.start_recording();
    m_saver.resume(m_curves, guard, m_state);
    // a survey that was cut short would mislead the decisions of a resumed run
    const bool is_cut_short = m_saver.is_resuming() && m_watch.must_stop();
    if(is_cut_short)
      m_watch.checkpoint(Run_watch::Checkpoint::END);
    else if(m_parameters.start == Filling_start::TREE && m_state.is_start())
      grow_first_tree(guard);
    const Result result = is_cut_short ? stopped(m_survey.thickness()) : run_stages(guard);
    if(m_parameters.certificate) *m_parameters.certificate = guard.certificate();
    return result;
  }

  // If the run is stopped meanwhile, a resumed run grows the tree anew.
  void grow_first_tree(Isotopy_guard_3<Traits, Domain>& guard)
  {
    m_watch.checkpoint(Run_watch::Checkpoint::PART);
    grow_tree(guard, m_survey);
    if(!m_watch.must_stop()) return;
    m_watch.checkpoint(Run_watch::Checkpoint::END_IN_PART);
    m_watch.set_checkpoint(nullptr);
  }

  // Interrupts steps, unless states are saved: they are copied between steps.
  Result run_stages(Isotopy_guard_3<Traits, Domain>& guard)
  {
    std::optional<Filler<Flow, Survey>> filler;
    try {
      const Watched_scope scope(m_watch.is_saving() ? nullptr : &m_watch);
      m_watch.begin(Run_stage::FLOWING);
      return filler.emplace(guard, m_survey, m_visitor, m_state)();
    } catch(const Run_stopped&) {
      if(m_curves.has_garbage()) guard.collect_garbage();
      return stopped(filler ? filler->thickness() : m_survey.thickness());
    }
  }

  Result stopped_at_start() const
  {
    certify_no_change(m_curves, m_parameters.certificate);
    return stopped(m_survey.thickness());
  }

  // The result of a run that was stopped within a step, or before the first one.
  Result stopped(const Thickness<Point_3>& thickness) const
  {
    Result result;
    result.status = m_watch.is_interrupted() ? Filling_status::INTERRUPTED : Filling_status::LIMIT;
    result.thickness = thickness.averaged_at(m_curves.points()).number();
    result.medial_radius = std::numeric_limits<double>::quiet_NaN();
    result.gradient_norm = m_state.gradient_norm;
    result.statistics = m_state.statistics;
    const Unfilled unfilled(m_survey.samples(), m_survey.distances_to_boundary(), m_parameters.wall,
                            m_parameters.wall_distance);
    measure_filling(result, unfilled, m_curves, thickness, m_watch, [] {});
    return result;
  }

  void report_survey(Result& result) const
  {
    result.parts = m_survey.number_of_wide_parts();
    if(!m_start.are_circles()) // otherwise each of them has a circle
      result.unreachable_parts = m_survey.number_of_wide_parts_without(m_curves);
    result.thickness_fit = m_fit;
    result.default_thickness = m_survey.refused_thickness();
    result.start = m_start.placed();
  }

  // Scales the result to the unit of the caller, and says why it falls short. Missed regions are
  // searched before, in the unit of the run.
  void scale_and_give_reason(Result& result) const
  {
    const bool has_settled_short = result.status == Filling_status::PARTIAL ||
                                   result.status == Filling_status::CONSTRAINT_NOT_REACHED ||
                                   result.status == Filling_status::STALLED;
    const bool has_gaps = has_settled_short && is_partial(result);
    const Missed_regions missed = has_gaps ? missed_regions(result) : Missed_regions();
    const bool is_crowded = has_gaps && result.crowded_fraction > tolerated_crowded_fraction;
    const double uncrowded = is_crowded ? m_unit * m_survey.uncrowded_thickness() : 0;
    scale<Space_of<Domain>>(result, m_unit, m_curves.traits());
    if(result.status == Filling_status::LENGTH_NOT_REACHED)
      result.reason = length_reason(m_unit * total_length(m_curves), m_unit * m_parameters.length);
    if(has_settled_short) result.reason = shape_reason(result.shape_excesses);
    if(has_gaps)
      result.reason +=
          (result.reason.empty() ? "" : "; ") + unfilled_reason(result, missed, uncrowded);
  }

  Missed_regions missed_regions(const Result& result) const
  {
    std::vector<Point_3> middles;
    for(const auto& region : result.empty_regions) middles.push_back(region.point);
    Neck_search<Network, Domain> necks(m_curves, m_domain, [this] { return m_watch.must_stop(); });
    Missed_regions missed;
    for(const Point_3& p : m_survey.points_in_parts_of(m_curves, middles))
      ++(necks.is_behind_neck(to_vector(p), m_survey.thickness()(p)) ? missed.behind_necks
                                                                     : missed.others);
    return missed;
  }

  Network& m_curves;
  const Survey& m_survey;
  const Domain& m_domain;
  const Filling_parameters<Point_3>& m_parameters;
  Run_watch& m_watch;
  Run_visitor<Flow>& m_visitor;
  const double m_unit;
  Start_curves<Network, Survey, ConcurrencyTag> m_start;
  const Thickness_fit m_fit;
  Run_saver m_saver;
  Filling_state m_state;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_RUN_H
