// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/Filling_result.h>
#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/Length_window.h>
#include <CGAL/Volume_filling_curves/internal/Region_paths.h>
#include <CGAL/Volume_filling_curves/internal/filling_task.h>

#include <CGAL/Real_timer.h>

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

// Grows a curve until it fills a domain. Coarse to fine: with a multiple of the thickness first, which
// takes few nodes and long steps, then with halves of it. While the curve grows, a large cap of the
// medial radii pulls it into empty space, and lambda is large, which makes the preconditioner close to
// the Hessian; at last it settles with what was asked for.
template <typename Flow, typename Samples, typename Visitor>
class Filler
{
  using Network = typename Flow::Curve_network;
  using Point_3 = typename Flow::Point_3;
  using Thickness_field = typename Flow::Thickness_field;
  using Paths = Region_paths<Network, Samples>;
  using Task = Filling_task<Point_3>;
  using Result = Filling_result<Point_3>;

public:
  // The timer has been started.
  Filler(Network& curve,
         const Samples& samples,
         const Task& task,
         const Real_timer& timer,
         Visitor& visitor)
      : m_task(task),
        m_timer(timer),
        m_samples(samples),
        m_flow(curve, samples.domain(), task.parameters),
        m_visitor(visitor)
  {}

  Result operator()()
  {
    m_visitor.on_start(m_flow);
    grow();
    settle();
    return result();
  }

private:
  // How a part of the run goes, and when it ends.
  struct Stage
  {
    double screening;        // in units of the one asked for
    double max_radius;       // in units of the thickness; the most
    double max_displacement; // likewise
    double cooling;          // by which the largest displacement is multiplied after each step
    std::size_t window;      // the stage ends if over that many iterations
    double change_of_length; // the length changed by less than this fraction of it
  };

  // Found on the bunny and a torus (2026-11-21). With lambda = 0.3 / r^2 alone the bunny takes 400
  // iterations instead of 80 to come within 2 % of its length. Without cooling the length of the torus
  // goes on trembling by 0.4 % for good.
  static constexpr Stage coarse_growth = {30, 6, 0.5, 1, 10, 2e-2};
  static constexpr Stage growth = {30, 6, 0.5, 1, 10, 1e-2};
  static constexpr Stage final_stage = {1, 2, 0.1, 0.97, 20, 1e-3};
  static constexpr double length_tolerance = 5e-3; // of a length asked for
  static constexpr int max_corrections_of_thickness = 8;
  static constexpr double kept_thinness = 0.5;
  static constexpr double driven_share = 0.9; // regions are driven at before they count as empty
  static constexpr int max_steps_without_motion = 5;

  void grow()
  {
    double factor = 1;
    while(2 * factor * m_task.parameters.thickness <= m_task.coarsest_thickness) factor *= 2;
    for(; factor > 1; factor /= 2) run(coarse_growth, factor);
    run(growth);
    reach_empty_regions();
  }

  void settle()
  {
    run(final_stage);
    return_to_empty_regions();
    if(!(m_task.length > 0)) return;
    for(int k = 0; k < max_corrections_of_thickness && !m_end; ++k) {
      const double excess = m_flow.length() / m_task.length;
      if(std::abs(excess - 1) < length_tolerance) return;
      // the strands' cross sections fill the volume
      m_task.parameters.thickness *= std::sqrt(excess);
      run(final_stage);
    }
  }

  // Where the curve does not get to by itself, as through a neck that is too narrow for a loop, it
  // is led along a path on which it may be thinner for a while.
  void reach_empty_regions()
  {
    for(const double thinness : {0.5, 0.25}) {
      if(!find_paths(thinness)) return;
      run(growth, 1, thinning(thinness));
      run(growth);
    }
  }

  // Where the curve has drawn back, since the place is too thin for the thickness asked for, it stays
  // thinner.
  void return_to_empty_regions()
  {
    if(!find_paths(kept_thinness)) return;
    m_thinning = thinning(kept_thinness);
    run(growth);
    run(final_stage);
  }

  // returns whether there are empty regions, and paths to them
  bool find_paths(double thinness)
  {
    if(m_end) return false;
    find_empty_regions(driven_share);
    m_paths = std::make_shared<const Paths>(m_flow.curve(), m_samples, m_empty_regions,
                                            thinness * m_task.parameters.thickness);
    return !m_paths->are_empty();
  }

  Thickness_field thinning(double thinness) const
  {
    return [paths = m_paths, thinness](const Point_3& p) { return paths->thinning(p, thinness); };
  }

  // Takes the thickness in units of the one asked for.
  void find_empty_regions(double share)
  {
    const auto thickness = [&](const Point_3& p) {
      return share * (m_task.thickness ? m_task.thickness(p) : m_task.parameters.thickness);
    };
    m_empty_regions = empty_regions(m_flow.curve(), m_samples,
                                    sample_distances(m_flow.curve(), m_samples), thickness);
  }

  void run(const Stage& stage, double factor = 1) { run(stage, factor, m_thinning); }

  // Runs a stage with a multiple of the thickness, which may vary.
  void run(const Stage& stage, double factor, Thickness_field multiple)
  {
    if(m_end) return;
    start(stage, factor, std::move(multiple));
    Length_window lengths;
    lengths.add(m_flow.length());
    while(!(m_end = end_before_step()) &&
          !lengths.has_settled(stage.window, stage.change_of_length)) {
      m_steps_without_motion = m_flow.step() ? 0 : m_steps_without_motion + 1;
      lengths.add(m_flow.length());
      m_flow.set_max_displacement(m_displacement *= stage.cooling);
      m_visitor.on_iteration(m_flow);
    }
  }

  void start(const Stage& stage, double factor, Thickness_field multiple)
  {
    Curve_flow_parameters p = m_task.parameters;
    p.screening *= stage.screening;
    p.max_radius = (std::min)(p.max_radius, stage.max_radius);
    p.max_displacement = m_displacement = stage.max_displacement;
    p.thickness *= factor;
    if(!m_task.thickness && !multiple)
      m_flow.set_parameters(p);
    else
      m_flow.set_parameters(p, [=, this_thickness = m_task.thickness,
                                r = m_task.parameters.thickness](const Point_3& x) {
        return factor * (this_thickness ? this_thickness(x) : r) * (multiple ? multiple(x) : 1);
      });
  }

  std::optional<Filling_status> end_before_step()
  {
    if(m_flow.statistics().iterations >= m_task.rules.max_iterations ||
       m_timer.time() >= m_task.rules.time_limit)
      return Filling_status::LIMIT;
    if(m_steps_without_motion >= max_steps_without_motion) return Filling_status::STALLED;
    if(!m_visitor.go_further(m_flow)) return Filling_status::INTERRUPTED;
    return std::nullopt;
  }

  Result result()
  {
    Result result;
    result.status = m_end.value_or(Filling_status::CONVERGED);
    find_empty_regions(1);
    result.empty_regions = m_empty_regions;
    result.thickness = m_task.thickness ? m_flow.thickness() : m_task.parameters.thickness;
    result.medial_radius = m_flow.mean_medial_radius(final_stage.max_radius * m_flow.thickness());
    result.gradient_norm = m_flow.gradient_norm();
    result.statistics = m_flow.statistics();
    return result;
  }

  Task m_task;
  const Real_timer& m_timer;
  const Samples& m_samples;
  Flow m_flow;
  Visitor& m_visitor;
  std::vector<Empty_region_3<Point_3>> m_empty_regions;
  std::shared_ptr<const Paths> m_paths; // to them
  Thickness_field m_thinning;           // for good, where the domain is too thin
  std::optional<Filling_status> m_end;  // if it is not because the curve has settled
  double m_displacement = 0;            // the largest, in units of the thickness
  int m_steps_without_motion = 0;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLER_H
