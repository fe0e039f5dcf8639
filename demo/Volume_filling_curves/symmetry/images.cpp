// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#include "symmetry/images.h"

#include "reports/containment.h"

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Unfilled_space.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_shape.h>
#include <CGAL/Volume_filling_curves/internal/filling/unfilled_reason.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
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
  using curves::Filling_status;
  const auto goal = curves::internal::shape_goal(parameters);
  const bool has_settled =
      result.status == Filling_status::CONVERGED || result.status == Filling_status::PARTIAL;
  if(!goal.is_given() || !has_settled) return;
  const std::vector<double> thickness(curve.number_of_nodes(), result.thickness);
  const curves::internal::Shape_check check(Concurrency(), curve,
                                            curves::internal::Shape_limits(curve, goal, thickness));
  result.shape_excesses = curves::internal::shape_excesses<Point>(check, curve.traits());
  if(result.shape_excesses.empty()) return;
  result.status = Filling_status::CONSTRAINT_NOT_REACHED;
  result.reason = curves::internal::shape_reason(result.shape_excesses) +
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
                   const Filling_parameters& parameters)
{
  const Samples samples(domain);
  const auto distances = curves::sample_distances<Concurrency>(curve, samples);
  result.coverage = curves::coverage(samples, distances, result.thickness);
  result.uncovered_fraction = curves::unfilled_fraction(samples, distances, result.thickness);
  result.are_empty_regions_known = false;
  result.empty_regions.clear();
  result.necks.clear();
  const auto bend = curves::tightest_bend(curve);
  result.min_bend_radius = bend.radius;
  result.tightest_node = bend.node;
  const auto strands = curves::min_strand_distance(curve, result.thickness);
  result.min_strand_distance = strands.distance;
  result.closest_points = strands.points;
  const auto wall = curves::min_wall_distance<Concurrency>(curve, domain);
  result.min_wall_distance = wall.distance;
  result.point_nearest_to_wall = wall.point;
  result.crowded_fraction = curves::crowded_fraction<Concurrency>(curve, result.thickness);
  result.unfilled_fraction =
      unfilled_fraction_of_whole(samples, distances, result.thickness, parameters);
  compare_with_tolerances(result);
  compare_with_limits(result, curve, parameters);
}

} // namespace vfc
