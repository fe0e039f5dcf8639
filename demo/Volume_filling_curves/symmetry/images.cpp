// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "symmetry/images.h"

#include "options/numbers.h"
#include "reports/containment.h"
#include "session/interruption.h"

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_measures.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vfc {
namespace {

namespace curves = CGAL::Volume_filling_curves;

using Point = Symmetry::Point;
using Concurrency = CGAL::Parallel_if_available_tag;
using Samples = curves::Domain_samples_3<Curve::Traits, Domain>;

// The part of the whole that no strand is near. It is more than that of the sectors, since an arc
// keeps clear of their ends as of the boundary.
double unfilled_fraction_of_whole(const Samples& samples,
                                  const std::vector<double>& distances,
                                  double thickness,
                                  const Filling_parameters& parameters)
{
  using Distances = curves::internal::Boundary_distances<Domain>;
  const bool are_depths_needed =
      parameters.wall == curves::Wall::KEEP_CLEAR || parameters.wall_distance > 0;
  const Distances depths(samples.domain(), samples.points(),
                         are_depths_needed ? Distances::no_limit : 0, nullptr, Concurrency());
  const curves::internal::Unfilled_space<Curve, Samples, Concurrency> unfilled(
      samples, depths, parameters.wall, parameters.wall_distance);
  return unfilled.fraction(distances, [=](const Point&) { return thickness; });
}

void measure_coverage(Filling_result& result,
                      const Curve& curve,
                      const Domain& domain,
                      const Filling_parameters& parameters,
                      curves::internal::Run_watch& watch)
{
  const auto go_further = [&] {
    watch.check();
    return true;
  };
  const Samples samples(domain, Samples::default_number, 0, Curve::Traits(), go_further);
  const auto distances = curves::sample_distances<Concurrency>(curve, samples);
  result.coverage = curves::coverage(samples, distances, result.thickness);
  result.uncovered_fraction = curves::unfilled_fraction(samples, distances, result.thickness);
  result.unfilled_fraction =
      unfilled_fraction_of_whole(samples, distances, result.thickness, parameters);
}

// Those of the arc do not hold for the curve.
void forget_measures(Filling_result& result)
{
  const Filling_result unknown;
  result.coverage = unknown.coverage;
  result.uncovered_fraction = result.unfilled_fraction = std::numeric_limits<double>::quiet_NaN();
  result.are_empty_regions_known = false;
  result.empty_regions.clear();
  result.necks.clear();
  result.min_bend_radius = unknown.min_bend_radius;
  result.min_strand_distance = unknown.min_strand_distance;
  result.min_wall_distance = unknown.min_wall_distance;
  result.crowded_fraction = unknown.crowded_fraction;
}

bool has_settled(const Filling_result& result)
{
  return result.status == curves::Filling_status::CONVERGED ||
         result.status == curves::Filling_status::PARTIAL;
}

void end_early(Filling_result& result)
{
  result.status = is_interruption_requested() ? curves::Filling_status::INTERRUPTED
                                              : curves::Filling_status::LIMIT;
  result.reason = "there was no time to measure the curve of all images";
}

// What is tolerable in a sector may not be so in the whole.
void compare_with_tolerances(Filling_result& result)
{
  using namespace curves::internal;
  if(result.status != curves::Filling_status::CONVERGED || !is_partial(result)) return;
  result.status = curves::Filling_status::PARTIAL;
  if(result.unfilled_fraction > tolerated_unfilled_fraction)
    result.reason = "the images of the arc leave gaps at the planes of --symmetry";
  if(result.crowded_fraction > tolerated_crowded_fraction)
    result.reason += (result.reason.empty() ? "" : "; ") + crowded(result, result.thickness, true);
}

// Strands of different images may be nearer to one another than the limits of a sector allow.
void compare_with_limits(Filling_result& result,
                         const Curve& curve,
                         const Filling_parameters& parameters)
{
  const auto goal = curves::internal::shape_goal(parameters);
  if(!goal.is_given()) return;
  const std::vector<double> thickness(curve.number_of_nodes(), result.thickness);
  const curves::internal::Shape_check check(Concurrency(), curve,
                                            curves::internal::Shape_limits(curve, goal, thickness));
  result.shape_excesses = curves::internal::shape_excesses<Point>(check, curve.traits());
  if(result.shape_excesses.empty()) return;
  result.status = curves::Filling_status::CONSTRAINT_NOT_REACHED;
  result.reason = curves::internal::shape_reason(result.shape_excesses) +
                  (result.reason.empty() ? "" : "; ") + result.reason;
}

void compare_with_wall(Filling_result& result, const Filling_parameters& parameters)
{
  if(result.min_wall_distance >= parameters.wall_distance) return;
  result.status = curves::Filling_status::CONSTRAINT_NOT_REACHED;
  result.reason = "the curve comes within " + to_text(result.min_wall_distance) +
                  " of the boundary, not " + to_text(parameters.wall_distance) +
                  (result.reason.empty() ? "" : "; ") + result.reason;
}

} // namespace

Curve closed_up(const Curve& arc,
                const Ports& ports,
                const Symmetry& symmetry,
                const Domain& domain,
                const std::string& file)
{
  std::vector<Point> nodes(arc.points().begin(), arc.points().end()), loop;
  if(CGAL::squared_distance(nodes.front(), ports.front().point) >
     CGAL::squared_distance(nodes.back(), ports.front().point))
    std::reverse(nodes.begin(), nodes.end());
  for(std::size_t k = 0; k < symmetry.order(); ++k) {
    for(const Point& p : nodes) loop.push_back(symmetry.image(p, k));
    if(symmetry.is_mirror() && k == 1)
      std::reverse(loop.begin() + static_cast<std::ptrdiff_t>(nodes.size()), loop.end());
  }
  loop.push_back(loop.front());
  Curve curve(std::vector<std::vector<Point>>{std::move(loop)});
  Defects outside = to_defects(containment(curve, domain), curve, file);
  if(!outside.empty()) throw Input_error(std::move(outside), "a symmetric mesh around all images");
  if(!is_embedded(curve)) throw std::runtime_error("the images of the arc meet");
  return curve;
}

void measure_again(Filling_result& result,
                   const Curve& curve,
                   const Domain& domain,
                   const Filling_parameters& parameters,
                   const Progress_function& progress)
{
  forget_measures(result);
  const auto np = curves::parameters::progress(progress);
  try {
    curves::internal::measured(np, [&](curves::internal::Run_watch* watch) {
      const curves::internal::Watched_scope scope(watch);
      measure_coverage(result, curve, domain, parameters, *watch);
      curves::internal::measure_shape<Concurrency>(result, curve, domain, result.thickness);
      compare_with_tolerances(result);
      if(!has_settled(result)) return;
      compare_with_limits(result, curve, parameters);
      compare_with_wall(result, parameters);
    });
  } catch(const curves::Run_interrupted&) {
    if(has_settled(result)) end_early(result);
  }
}

} // namespace vfc
