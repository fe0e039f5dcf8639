// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/Filling_result.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Length_window.h>
#include <CGAL/Volume_filling_curves/internal/filling/Region_paths.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thinned_paths.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_thickness.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/parameters/with_thickness.h>
#include <CGAL/Volume_filling_curves/internal/state/Decisions.h>
#include <CGAL/Volume_filling_curves/internal/state/Run_saver.h>
#include <CGAL/Volume_filling_curves/internal/state/State_reader.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/step/Idle_steps.h>
#include <CGAL/Volume_filling_curves/internal/support/Deadline.h>
#include <CGAL/Volume_filling_curves/internal/support/Stage_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Lets a curve fill a domain. If fingers have reached out all over it, the curve opens in a few
// iterations; otherwise it grows, coarse to fine: with a multiple of the thickness first, which
// takes few nodes and long steps, then with halves of it. While it opens or grows, a large cap of
// the medial radii pulls it into empty space, and lambda is large, which makes the preconditioner
// close to the Hessian; at last it settles with what was asked for.
template <typename Flow, typename Samples, typename Visitor>
class Filler
{
  using Network = typename Flow::Curve_network;
  using Guard = typename Flow::Guard;
  using Point_3 = typename Flow::Point_3;
  using Thickness_field = typename Flow::Thickness_field;
  using Paths = Region_paths<Network, Samples>;
  using Parameters = Filling_parameters<Point_3>;
  using Result = Filling_result<Point_3>;

public:
  // Takes the thickness to start from, and the radius of the widest ball inside. If the saver has a
  // state to read, the curve is the one of that state.
  Filler(Guard& guard,
         const Samples& samples,
         const std::vector<double>& boundary_distances,
         const Parameters& parameters,
         double thickness,
         double widest_radius,
         const Deadline& deadline,
         Visitor& visitor,
         Run_saver& saver)
      : m_parameters(parameters),
        m_thickness(thickness),
        m_coarsest_thickness(coarsest_share * widest_radius),
        m_deadline(deadline),
        m_samples(samples),
        m_boundary_distances(boundary_distances),
        m_guard(guard),
        m_flow(guard, with_thickness(parameters, thickness), saver.reader()),
        m_visitor(visitor),
        m_saver(saver)
  {}

  Result operator()()
  {
    if(State_reader* const reader = m_saver.reader())
      (*reader)(m_resumed_stage, m_decisions);
    else
      m_visitor.on_start(m_flow);
    m_thickness = m_decisions([this] { return m_thickness; });
    grow();
    settle();
    return result();
  }

private:
  static constexpr double coarsest_share = 0.25; // of the widest ball: the curve needs room to grow
  // of a length asked for, to end the search for it
  static constexpr double length_tolerance = 5e-3;
  static constexpr double promised_tolerance = 2e-2; // likewise, to call it reached
  static constexpr int max_corrections_of_thickness = 8;
  static constexpr double kept_thinness = 0.5;
  static constexpr double driven_share = 0.9; // regions are driven at before they count as empty

  void grow()
  {
    if(m_parameters.start == Filling_start::TREE) {
      run(Filling_stage::opening());
      return_to_empty_regions();
      if(is_much_unfilled()) reach_empty_regions(); // beyond necks that no finger got through
      return;
    }
    double factor = 1;
    while(2 * factor * m_thickness <= m_coarsest_thickness) factor *= 2;
    for(; factor > 1; factor /= 2) run(Filling_stage::coarse_growth(), factor);
    run(Filling_stage::growth());
    reach_empty_regions();
  }

  void settle()
  {
    run(Filling_stage::settling());
    if(return_to_empty_regions()) run(Filling_stage::settling());
    run(Filling_stage::refining());
    if(!(m_parameters.length > 0)) return;
    for(int k = 0; k < max_corrections_of_thickness && !m_end; ++k) {
      const double excess = m_decisions([&] { return m_flow.length() / m_parameters.length; });
      if(std::abs(excess - 1) < length_tolerance) return;
      // the strands' cross sections fill the volume
      m_thickness *= std::sqrt(excess);
      run(Filling_stage::opening()); // the shrinking steps alone do not follow the thickness
      run(Filling_stage::settling());
      run(Filling_stage::refining());
    }
  }

  bool is_much_unfilled()
  {
    return !m_end && m_decisions([&] { return is_much_unfilled_now(); });
  }

  // A thin ear of a bunny is less than a hundredth of the volume, but far away.
  bool is_much_unfilled_now() const
  {
    const std::vector<double> distances = distances_to_fill();
    const auto farther_than = [&](double multiple) {
      return unfilled_fraction(m_samples, distances,
                               [&](const Point_3& p) { return multiple / 2 * thickness_at(p); });
    };
    return farther_than(2) > tolerated_unfilled_fraction || farther_than(3) > 0;
  }

  // Where the curve does not get to by itself, as through a neck that is too narrow for a loop, it
  // is led along a path on which it may be thinner for a while.
  void reach_empty_regions()
  {
    for(const double thinness : {0.5, 0.25}) {
      if(!find_paths(thinness)) return;
      run(Filling_stage::growth(), 1, thinning(thinness));
      run(Filling_stage::growth());
    }
  }

  // Where the curve has drawn back, since the place is too thin for the thickness asked for, it
  // stays thinner. Returns whether there is such a place.
  bool return_to_empty_regions()
  {
    if(!find_paths(kept_thinness)) return false;
    m_thinning = [last = m_thinning, now = thinning(kept_thinness)](const Point_3& p) {
      return last ? (std::min)(last(p), now(p)) : now(p);
    };
    run(m_parameters.start == Filling_start::TREE ? Filling_stage::opening()
                                                  : Filling_stage::growth());
    return true;
  }

  // returns whether there are empty regions, and paths to them
  bool find_paths(double thinness)
  {
    if(m_end) return false;
    m_paths = std::make_shared<const Thinned_paths>(m_decisions([&] {
      return Paths(m_flow.curve(), m_samples, empty_regions_to_drive_at(), thinness * m_thickness,
                   &m_deadline)
          .paths();
    }));
    return !m_paths->are_empty();
  }

  Thickness_field thinning(double thinness) const
  {
    return [paths = m_paths, thinness](const Point_3& p) { return paths->thinning(p, thinness); };
  }

  double thickness_at(const Point_3& p) const
  {
    return m_parameters.thickness_field ? m_parameters.thickness_field(p) : m_thickness;
  }

  std::vector<Empty_region_3<Point_3>> empty_regions_to_drive_at() const
  {
    const auto thickness = [&](const Point_3& p) { return driven_share * thickness_at(p); };
    return find_empty_regions(m_flow.curve(), m_samples, distances_to_fill(), &m_boundary_distances,
                              thickness);
  }

  // Of the samples from the curve; 0 where it is to keep clear of the boundary. Driven there, it
  // would be compressed, and stay so.
  std::vector<double> distances_to_fill() const
  {
    std::vector<double> distances = sample_distances(m_flow.curve(), m_samples);
    if(m_parameters.wall == Wall::KEEP_CLEAR)
      for(std::size_t k = 0; k < distances.size(); ++k)
        if(m_boundary_distances[k] < 2 * thickness_at(m_samples.points()[k])) distances[k] = 0;
    return distances;
  }

  void run(const Filling_stage& stage, double factor = 1) { run(stage, factor, m_thinning); }

  // Runs a stage with a multiple of the thickness, which may vary.
  void run(const Filling_stage& stage, double factor, Thickness_field multiple)
  {
    if(m_end || ++m_stage < m_resumed_stage) return;
    m_flow.set_direction_field(m_parameters.direction_field,
                               stage.direction_weight * m_parameters.direction_weight);
    if(m_stage == m_resumed_stage)
      resume(thickness_field(factor, std::move(multiple)));
    else
      start(stage, factor, std::move(multiple));
    while(!(m_end = end_between_steps()) &&
          !m_lengths.has_settled(stage.window, stage.change_of_length)) {
      m_idle_steps.note(step());
      m_lengths.add(m_flow.length());
      m_flow.set_max_displacement(m_displacement *= stage.cooling);
      m_visitor.on_iteration(m_flow);
    }
  }

  // Goes on in the middle of a stage.
  void resume(const Thickness_field& thickness)
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

  bool step()
  {
    m_seconds_of_step = 0;
    const Stage_timer timer(m_seconds_of_step);
    return m_flow.step();
  }

  void start(const Filling_stage& stage, double factor, Thickness_field multiple)
  {
    Curve_flow_parameters p = with_thickness(m_parameters, factor * m_thickness);
    p.screening *= stage.screening;
    p.spacing = (std::max)(p.spacing, stage.spacing);
    p.max_radius = (std::min)(p.max_radius, stage.max_radius);
    m_flow.keep_apart(stage.separation);
    p.max_displacement = m_displacement = (std::min)(p.max_displacement, stage.max_displacement);
    m_flow.set_parameters(p, thickness_field(factor, std::move(multiple)));
    m_lengths = {};
    m_lengths.add(m_flow.length());
  }

  // None if the thickness is the same everywhere.
  Thickness_field thickness_field(double factor, Thickness_field multiple) const
  {
    if(!m_parameters.thickness_field && !multiple) return nullptr;
    return [factor, multiple = std::move(multiple), field = m_parameters.thickness_field,
            r = m_thickness](const Point_3& x) {
      return factor * (field ? field(x) : r) * (multiple ? multiple(x) : 1);
    };
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
    if(m_flow.statistics().iterations >= m_parameters.number_of_iterations ||
       !m_deadline.leaves(m_seconds_of_step))
      return Filling_status::LIMIT;
    if(m_idle_steps.are_too_many()) return Filling_status::STALLED;
    if(!m_visitor.go_further(m_flow)) return Filling_status::INTERRUPTED;
    return std::nullopt;
  }

  bool misses_length() const
  {
    return m_parameters.length > 0 &&
           !(std::abs(m_flow.length() / m_parameters.length - 1) <= promised_tolerance);
  }

  Filling_status status_of_settled(const Result& result) const
  {
    if(misses_length()) return Filling_status::LENGTH_NOT_REACHED;
    return result.unfilled_fraction > tolerated_unfilled_fraction ? Filling_status::PARTIAL
                                                                  : Filling_status::CONVERGED;
  }

  void measure_coverage(Result& result)
  {
    const auto thickness = [&](const Point_3& p) { return thickness_at(p); };
    result.coverage = coverage(m_samples, sample_distances(m_flow.curve(), m_samples), thickness);
    const std::vector<double> distances = distances_to_fill();
    result.unfilled_fraction = unfilled_fraction(m_samples, distances, thickness);
    if(!m_deadline.leaves(m_seconds_of_step)) return; // the search for them can take seconds
    result.empty_regions =
        find_empty_regions(m_flow.curve(), m_samples, distances, &m_boundary_distances, thickness);
  }

  Result result()
  {
    Result result;
    measure_coverage(result);
    result.status = m_end.value_or(status_of_settled(result));
    result.thickness = m_parameters.thickness_field ? m_flow.thickness() : m_thickness;
    result.medial_radius =
        m_flow.mean_medial_radius(Filling_stage::settling().max_radius * m_flow.thickness());
    result.gradient_norm = m_flow.gradient_norm();
    result.statistics = m_flow.statistics();
    return result;
  }

  const Parameters& m_parameters;
  double m_thickness; // the one that is asked for, or that is to lead to the length asked for
  const double m_coarsest_thickness; // with which the curve starts to grow
  const Deadline& m_deadline;
  const Samples& m_samples;
  const std::vector<double>& m_boundary_distances; // of the samples
  Guard& m_guard;
  Flow m_flow;
  Visitor& m_visitor;
  Run_saver& m_saver;
  Decisions m_decisions;
  std::size_t m_stage = 0, m_resumed_stage = 0; // from 1; 0 if the run has started anew
  Length_window m_lengths;                      // of the stage
  std::shared_ptr<const Thinned_paths> m_paths; // to empty regions
  Thickness_field m_thinning;                   // for good, where the domain is too thin
  std::optional<Filling_status> m_end;          // if it is not because the curve has settled
  double m_displacement = 0;                    // the largest, in units of the thickness
  double m_seconds_of_step = 0;                 // the last one took
  Idle_steps m_idle_steps;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H
