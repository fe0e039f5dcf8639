// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/coverage.h>
#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/domain/Least_depth.h>
#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/measures/Crowding.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Filling_result.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Thickness_fit.h>

#include <cstddef>
#include <functional>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Proof that only passages narrower than r lead from a curve to a point: a breadth-first search on
// a grid would find a path of a ball of radius r / 2 from the point to within r of the curve. A
// search that ends without one is the proof; one that takes too long proves nothing. Linear in the
// number of visited cells, which is limited.
template <typename Network, typename Domain>
class Neck_search
{
  using Traits = typename Network::Traits;

public:
  // The search ends without a proof once `must_stop` returns true.
  Neck_search(const Network& curve, const Domain& domain, std::function<bool()> must_stop)
      : m_curve(curve),
        m_paths(domain, curve.traits(), max_cells),
        m_must_stop(std::move(must_stop))
  {}

  // returns whether every passage from a point to the curve is proved to be narrower than r.
  // \pre the ball of radius r / 2 around the point lies inside
  bool is_behind_neck(const Vector& point, double r)
  {
    const auto is_end = [&](const Vector& p) {
      return m_cells_left-- <= 1 || m_curve.distance(p) < r || m_must_stop();
    };
    return m_cells_left > 0 && !m_paths.search(point, max_cell * r, is_end);
  }

private:
  // In units of r. If the center of a ball of radius r / 2 lies in a cell of size s, the center of
  // the cell is at least r / 2 - 0.87 s from the boundary; the search requires 0.55 s.
  static constexpr double max_cell = 0.35;
  static constexpr std::size_t max_cells = 300000;

  const Distance_to_curve m_curve;
  Path_search<Domain, Traits> m_paths;
  const std::function<bool()> m_must_stop;
  std::size_t m_cells_left = max_cells;
};

// Reason, in English, why more of a domain than tolerated is farther than 2 r from the curve, or
// more of the curve nearer than r to another strand.

// returns whether there must be one
template <typename Result>
bool is_partial(const Result& result)
{
  return result.unfilled_fraction > tolerated_unfilled_fraction ||
         result.crowded_fraction > tolerated_crowded_fraction;
}

// returns the number with three digits
inline std::string rounded(double number)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(3) << number;
  return out.str();
}

inline std::string too_thin(const Thickness_fit& fit)
{
  return "walls are too thin for r = " + rounded(fit.thickness) + " in " +
         rounded(100 * fit.thin_fraction) +
         " % of the volume, r = " + rounded(fit.fitting_thickness) + " would fit";
}

// Names a thickness that fits, if there is one and none is named yet.
template <typename Result>
std::string crowded(const Result& result, double fitting_thickness, bool is_named)
{
  const std::string text = "strands are nearer than r along " +
                           rounded(100 * result.crowded_fraction) + " % of the length";
  if(is_named || !(fitting_thickness < result.thickness_fit.thickness)) return text;
  return text + ", r = " + rounded(fitting_thickness) + " would leave them room";
}

// The empty regions in those parts of the inside that hold a curve.
struct Missed_regions
{
  std::size_t behind_necks = 0; // proved to be
  std::size_t others = 0;
};

// Also takes the thickness with which strands keep their distance, used if the curve is crowded.
template <typename Point_3>
std::string unfilled_reason(const Filling_result<Point_3>& result,
                            const Missed_regions& missed,
                            double uncrowded_thickness)
{
  std::string reason;
  const auto add = [&](const std::string& text) { reason += (reason.empty() ? "" : "; ") + text; };
  if(result.status == Filling_status::STALLED) add("no step could be certified any more");
  if(result.unreachable_parts > 0)
    add("no curve was started in " + std::to_string(result.unreachable_parts) + " of " +
        counted(result.parts, "part") + " of the inside");
  const bool is_thin = result.thickness_fit.thin_fraction > tolerated_unfilled_fraction;
  if(is_thin) add(too_thin(result.thickness_fit));
  if(result.crowded_fraction > tolerated_crowded_fraction)
    add(crowded(result, uncrowded_thickness, is_thin));
  if(missed.behind_necks > 0)
    add("the curve did not get through a neck narrower than r to " +
        counted(missed.behind_necks, "empty region"));
  if(missed.others > 0) add("the curve did not reach " + counted(missed.others, "empty region"));
  return reason.empty() ? "gaps between strands or along the boundary are wide" : reason;
}

// Returns the reason of LENGTH_NOT_REACHED.
inline std::string length_reason(double length, double required_length)
{
  return "the length is " + rounded(length) + ", not " + rounded(required_length);
}

// Measures where a curve comes closest to itself and to the boundary of its domain.
template <typename ConcurrencyTag,
          typename Result,
          typename Network,
          typename Domain,
          typename Thickness>
void measure_shape(Result& result,
                   const Network& curve,
                   const Domain& domain,
                   const Thickness& thickness)
{
  const auto point = [&](const Vector& p) { return to_point(p, curve.traits()); };
  const Corner tightest = tightest_corner(curve);
  result.min_bend_radius = tightest.bend_radius;
  result.tightest_node = tightest.node;
  const Crowding crowding(curve, thickness);
  result.crowded_fraction = crowding.template fraction<ConcurrencyTag>();
  const auto strands = crowding.closest();
  result.min_strand_distance = strands.distance;
  result.closest_points = {point(strands.points[0]), point(strands.points[1])};
  const auto nearest = Least_depth<ConcurrencyTag, Network, Domain>(curve, domain)();
  result.min_wall_distance = nearest.distance;
  result.point_nearest_to_wall = point(nearest.point);
}

// Measures the coverage of a curve and its shape, as far as time allows. A run that is
// to stop has a tenth of a second for that, enough for 50,000 nodes. A share that is not measured
// is not a number.
template <typename Result, typename Unfilled, typename Network, typename Thickness>
void measure_filling(Result& result,
                     const Unfilled& unfilled,
                     const Network& curve,
                     const Thickness& thickness,
                     Run_watch& watch)
{
  constexpr double seconds_to_measure = 0.1;
  watch.begin(Run_stage::MEASURING);
  watch.grant(seconds_to_measure);
  const Watched_scope scope(&watch);
  result.unfilled_fraction = result.uncovered_fraction = std::numeric_limits<double>::quiet_NaN();
  try {
    const std::vector<double> distances = unfilled.distances(curve);
    result.coverage = coverage(unfilled.samples(), distances, thickness);
    result.unfilled_fraction = unfilled.fraction(distances, thickness);
    result.uncovered_fraction = unfilled_fraction(unfilled.samples(), distances, thickness);
    measure_shape<typename Unfilled::Concurrency_tag>(result, curve, unfilled.samples().domain(),
                                                      thickness);
    result.empty_regions = unfilled.regions(curve, distances, thickness);
    result.are_empty_regions_known = true;
  } catch(const Run_stopped&) {
  }
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_UNFILLED_REASON_H
