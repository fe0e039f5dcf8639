// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Curve_flow_3.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_stage_runner.h>
#include <CGAL/Volume_filling_curves/internal/filling/Filling_state.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_tree.h>
#include <CGAL/Volume_filling_curves/internal/filling/Thinned_paths.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_visitor.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Grows fingers from a curve through the whole domain, and returns whether any grew. No watch
// interrupts them: growing stops by itself in time.
template <typename Guard, typename Survey>
bool grow_tree(Guard& guard, const Survey& survey)
{
  const Watched_scope scope(nullptr);
  survey.watch().begin(Run_stage::BRANCHING);
  const auto& parameters = survey.parameters();
  Finger_tree tree(guard, survey.samples().domain(), survey.thickness(), parameters.random_seed,
                   survey.watch());
  tree.follow(parameters.direction_field, parameters.direction_weight);
  tree.divide_volume(parameters.volume_shares);
  tree.grow();
  return tree.number_of_fingers() > 0;
}

// Growth of a curve until it fills a domain. If fingers reach through the whole domain, the curve
// opens in a few iterations. Otherwise it grows, coarse to fine: first with a multiple of the
// thickness, which takes few nodes and long steps, then with halves of it; fingers reach the rest.
// While the curve opens or grows, a large cap of the medial radii pulls it into empty space, and a
// large screening brings the preconditioner close to the Hessian; then bends are rounded, or,
// without `round_bends`, the curve settles with the required parameters.
template <typename Flow, typename Survey>
class Filler
{
  using Network = typename Flow::Curve_network;
  using Guard = typename Flow::Guard;
  using Point_3 = typename Flow::Point_3;
  using Thickness = typename Flow::Thickness;
  using Result = Filling_result<Point_3>;

public:
  Filler(Guard& guard, const Survey& survey, Run_visitor<Flow>& visitor, Filling_state& state)
      : m_guard(guard),
        m_survey(survey),
        m_parameters(survey.parameters()),
        m_shape(shape_goal(m_parameters)),
        m_watch(survey.watch()),
        m_unfilled(survey.samples(),
                   survey.distances_to_boundary(),
                   m_parameters.wall,
                   m_parameters.wall_distance),
        m_thickness(survey.thickness().averaged_at(guard.curve().points())),
        m_runner(guard, m_parameters, Thickness(m_thickness.number()), m_watch, visitor, state)
  {
    m_thickness.set_number(m_runner.decide([this] { return m_thickness.number(); }));
  }

  Result operator()()
  {
    grow();
    settle();
    return result();
  }

  // the thickness that the curve is to end with
  const Thickness& thickness() const { return m_thickness; }

private:
  static constexpr double coarsest_share = 0.25; // of the widest ball: the curve needs room to grow
  // relative, of a required length, to end the search for it
  static constexpr double length_tolerance = 5e-3;
  static constexpr double promised_tolerance = 2e-2; // likewise, to call it reached
  // A curve that opens again changes its length: a length of 40 in a cube of side 4 takes 130
  // iterations, and 176 if the curve opens each time (2026-11-23).
  static constexpr double excess_to_open_for = 0.05;
  // With the same thickness, the lengths of curves of 120 nodes differ by 4 %: after these, what is
  // promised is enough. Of 32 fillings of a box with a length, 6 missed it otherwise (2026-11-27).
  static constexpr int corrections_to_try = 3;
  // With eight, 9 of 16 fillings of a plate thinner than r reached their length, now all do, in a
  // tenth more iterations (2026-11-28).
  static constexpr int max_corrections_of_thickness = 14;
  static constexpr int max_loosenings = 2;
  static constexpr double kept_thinness = 0.5;
  // In units of the thickness with which the curve is pushed into regions. With 0.9 a spike of the
  // anapsidea (seed 2) stays 4.1 r from the curve, with 0.8 it is 2.8 r; with 0.7, near the size of
  // ordinary gaps, the bunny (seed 3) is thinned at many points, and the curve is an eighth longer
  // (2026-11-23).
  static constexpr double pushed_share = 0.8;

  void grow()
  {
    if(m_parameters.start == Filling_start::TREE) {
      run(Filling_stage::opening());
    } else {
      grow_coarse_to_fine();
      if(grow_more_fingers()) run(Filling_stage::opening());
    }
    if(!m_shape.is_given() && thin_in_narrow_regions()) run(Filling_stage::opening());
  }

  void grow_coarse_to_fine()
  {
    double factor = 1;
    while(2 * factor * m_thickness.number() <= coarsest_share * m_survey.widest_radius())
      factor *= 2;
    for(; factor > 1; factor /= 2) run(Filling_stage::coarse_growth(), factor);
    run(Filling_stage::growth());
  }

  // Returns whether fingers have grown into regions that the curve had not reached. They would
  // leave the sets of curves all of whose nodes slide.
  bool grow_more_fingers()
  {
    if(m_runner.end() || slides_somewhere()) return false;
    return m_runner.decide_in_time([this] {
      if(!m_unfilled.is_much(curve(), m_thickness)) return false;
      const bool have_grown = grow_tree(m_guard, m_survey);
      m_watch.begin(Run_stage::FLOWING); // again
      return have_grown;
    });
  }

  bool slides_somewhere() const
  {
    for(const std::size_t c : curve().components())
      if(slides_everywhere(curve(), c)) return true;
    return false;
  }

  void settle()
  {
    settle_strands(true);
    if(!(m_parameters.length > 0)) return;
    for(int k = 0; k < max_corrections_of_thickness && !m_runner.end(); ++k) {
      const double ratio = m_runner.decide([&] { return flow().length() / m_parameters.length; });
      const bool is_hard = k >= corrections_to_try;
      if(std::abs(ratio - 1) < (is_hard ? promised_tolerance : length_tolerance)) return;
      if(!correct_thickness(ratio)) return;
      // steps that shrink follow a large change of the thickness too slowly
      if(std::abs(ratio - 1) > excess_to_open_for) run(Filling_stage::opening());
      settle_strands(false);
    }
  }

  // Adapts the thickness to the ratio of lengths, as the cross sections of the strands fill the
  // volume. Returns whether it changes; it stays above the minimum for the required shape, and
  // below the maximum.
  bool correct_thickness(double ratio)
  {
    const double former = m_thickness.number();
    const double min = min_thickness_for(m_parameters);
    const double max = (std::max)(min, m_survey.max_thickness_of_length());
    m_thickness.set_number(std::clamp(std::sqrt(ratio) * m_thickness.number(), min, max));
    return m_thickness.number() != former;
  }

  // Lets the strands settle, with round bends if a shape is required.
  void settle_strands(bool can_thin)
  {
    if(m_shape.is_given()) return round_bends();
    run(Filling_stage::settling());
    if(can_thin && thin_in_narrow_regions()) run(Filling_stage::settling());
    run(Filling_stage::refining());
  }

  // Bends the curve, densely if possible, and less densely if it has jammed.
  void round_bends()
  {
    const bool is_dense = can_be_dense();
    run(is_dense ? Filling_stage::bending() : Filling_stage::bending_in_full());
    if(grows_without_end()) return;
    run(Filling_stage::polishing());
    if(is_dense) {
      if(!is_jammed(true)) return;
      bend_again(Filling_stage::bending_in_full());
    }
    for(int k = 0; k < max_loosenings && is_jammed(false); ++k)
      bend_again(Filling_stage::loosening());
  }

  void bend_again(const Filling_stage& stage)
  {
    run(stage);
    run(Filling_stage::polishing());
  }

  // Polishing would push a dense curve to a boundary that it is to keep clear of, and has no room
  // for it in a tiny domain: in a ball of radius 2.5 r, 10 of 16 curves of length 25 r missed their
  // limits, in one of 2.9 r none of length 37 r (2026-11-28).
  bool can_be_dense() const
  {
    constexpr double min_length = 30; // expected, in units of the thickness
    const double r = m_thickness.number();
    return m_parameters.wall == Wall::COVER && m_survey.size().length(r) > min_length * r;
  }

  // Whether the curve has been bent in vain, and would grow further.
  bool grows_without_end()
  {
    if(m_runner.end()) return false;
    return m_runner.decide(
               [this] { return m_runner.growth() > Filling_stage::bending().max_growth; }) != 0;
  }

  // Whether the curve is too dense for its bends and strands. A few local excesses do not justify
  // loosening the whole curve: for one fold, a bunny of 727,559 nodes was filled to 76 instead of
  // 92 %, in 1.4 times the time (2026-11-26).
  //
  // If limits are out of reach, a dense curve is bent in full, which costs density only, unless it
  // has a length to reach, which would change; it is not loosened.
  bool is_jammed(bool is_dense)
  {
    if(m_runner.end()) return false;
    return m_runner.decide([this, is_dense] {
      constexpr double few = 1e-4; // of the nodes
      const Polishing_record& polishing = m_runner.polishing();
      const bool can_bend_in_full = is_dense && !(m_parameters.length > 0);
      const bool can_change = can_bend_in_full || !polishing.are_limits_out_of_reach();
      return polishing.last() > few && can_change;
    }) != 0;
  }

  // Thins the curve along paths to points that it does not reach, since the domain is too thin
  // there for the required thickness. Returns whether there are such points. A curve with a
  // required shape stays as thick as required: thinned, its bends kept half of their radius in one
  // of three fillings of the anapsidea.
  bool thin_in_narrow_regions()
  {
    if(m_runner.end()) return false;
    const Thickness pushed = pushed_share * m_thickness;
    const auto points = [&] {
      return m_unfilled.paths_to(m_unfilled.unreached_points(curve(), pushed), curve(),
                                 m_thickness.number(), m_watch);
    };
    const auto paths = std::make_shared<const Thinned_paths>(
        m_unfilled.cell_of_paths * m_thickness.number(), m_runner.decide_points(points));
    if(paths->are_empty()) return false;
    m_thinning = [paths, last = m_thinning](const Point_3& p) {
      return (std::min)(paths->thinning(p, kept_thinness), last ? last(p) : 1);
    };
    return true;
  }

  void run(const Filling_stage& stage, double factor = 1)
  {
    m_runner.run(stage, (factor * m_thickness).thinned(m_thinning));
  }

  const Flow& flow() const { return m_runner.flow(); }
  const Network& curve() const { return flow().curve(); }

  bool misses_length() const
  {
    return m_parameters.length > 0 &&
           !(std::abs(flow().length() / m_parameters.length - 1) <= promised_tolerance);
  }

  Filling_status status_of_settled(const Result& result) const
  {
    if(misses_length()) return Filling_status::LENGTH_NOT_REACHED;
    if(!result.shape_excesses.empty()) return Filling_status::CONSTRAINT_NOT_REACHED;
    return is_partial(result) ? Filling_status::PARTIAL : Filling_status::CONVERGED;
  }

  // A curve that nobody had time to measure has not reached its goal.
  Result result() const
  {
    const Watched_scope scope(nullptr); // a watch may cut measuring short, but not the result
    Result result;
    bool is_measured = false;
    measure_filling(result, m_unfilled, curve(), m_thickness, m_watch, [&] {
      if(m_shape.is_given())
        result.shape_excesses = shape_excesses<Point_3>(
            flow().check_shape(m_shape, m_thickness.at_each(curve().points())), curve().traits());
      is_measured = true;
    });
    if(m_runner.end()) {
      result.status = *m_runner.end();
    } else if(is_measured) {
      result.status = status_of_settled(result);
    } else {
      result.status =
          m_watch.is_interrupted() ? Filling_status::INTERRUPTED : Filling_status::LIMIT;
      m_watch.checkpoint(Run_watch::Checkpoint::END);
    }
    // the flow's may be that of a stage
    result.thickness = m_thickness.averaged_at(curve().points()).number();
    result.medial_radius =
        flow().mean_medial_radius(Filling_stage::settling().max_radius * result.thickness);
    result.gradient_norm = flow().gradient_norm();
    result.statistics = flow().statistics();
    return result;
  }

  Guard& m_guard;
  const Survey& m_survey;
  const Filling_parameters<Point_3>& m_parameters;
  const Shape_goal m_shape; // may be empty
  Run_watch& m_watch;
  const Unfilled_space<Network, typename Survey::Samples, typename Flow::Concurrency_tag>
      m_unfilled;
  Thickness m_thickness; // required, or adapted to the required length
  Filling_stage_runner<Flow> m_runner;
  typename Thickness::Field m_thinning; // where the domain is too thin
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLER_H
