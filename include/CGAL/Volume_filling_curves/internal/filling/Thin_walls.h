// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THIN_WALLS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THIN_WALLS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/depth.h>
#include <CGAL/Volume_filling_curves/internal/filling/filling_estimates.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Radius of the ball that a curve needs, in units of its thickness: plates fill up to a thickness
// of 1.5 times half their own, rods up to 1.2 times (2026-11-22).
constexpr double needed_width = 0.8;

// The same for strands that keep r from one another: in plates of thickness 2 r, 2 to 8 % of the
// length has nearer strands, in those of 2.5 r 1 %; in square rods of width 2 r 72 %, of 2.5 r
// none.
constexpr double uncrowded_width = 1.1;

// Share of a domain that is too thin for a thickness. For each of some samples, the largest ball
// around a nearby sample ascends; if it stays smaller than a curve needs, the sample lies between
// walls that are too thin. Needs hardly any query of the domain where it is wide, and up to some
// hundred per sample where it is not.
template <typename Samples>
class Thin_walls
{
  using Point_3 = typename Samples::Point_3;
  using Domain = std::decay_t<decltype(std::declval<const Samples&>().domain())>;
  static constexpr bool is_plane = Space_of<Domain>::is_plane;

public:
  // Takes the distances of the samples to the boundary, those up to `needed_width` times the
  // largest thickness at least, the thickness as a function of the point, and the radius of the
  // ball that a curve needs, in units of the thickness. Once the run is to stop no further samples
  // are looked at.
  Thin_walls(const Samples& samples,
             const std::vector<double>& distances,
             const Thickness<Point_3>& thickness,
             Run_watch& watch,
             double width = needed_width)
      : m_samples(samples),
        m_thickness(thickness),
        m_watch(watch),
        m_width(width),
        m_reach(reach_of_ball * width)
  {
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return distances[i] > distances[j]; });
    for(const std::size_t i : order)
      m_balls.push_back({to_vector(samples.points()[i]), distances[i]});
  }

  // returns the share of the volume that is too thin for `scale` times the thickness
  double fraction(double scale) const
  {
    const std::size_t n = (std::min)(number_of_probes, m_samples.points().size());
    std::size_t thin = 0, all = 0;
    for(; all < n && (all == 0 || !m_watch.must_stop()); ++all) {
      const Point_3& p = m_samples.points()[all];
      if(!fits(to_vector(p), scale * m_thickness(p))) ++thin;
    }
    return static_cast<double>(thin) / static_cast<double>(all);
  }

  // returns by how much the thickness must be multiplied to fit nearly everywhere, the largest of
  // 0.71, 0.5, 0.35, ..., found by bisection. \pre the thickness itself does not fit
  double fitting_scale() const
  {
    int too_large = 0, small = halvings;
    while(small - too_large > 1 && !m_watch.must_stop()) {
      const int middle = (too_large + small) / 2;
      (fraction(scale(middle)) > tolerated_unfilled_fraction ? too_large : small) = middle;
    }
    return scale(small);
  }

private:
  // The center of a ball that touches the walls of a corner is 1.73 of its radii from it.
  static constexpr double reach_of_ball = 1.5 / 0.8; // in units of its radius
  // If none of `many` balls around samples has the share `hopeful` of the needed width, none will.
  static constexpr int many = 8;
  static constexpr double hopeful = 0.6;
  // The standard error of the tolerated share of 1 % is then 0.6 %; a probe takes up to about a
  // hundred queries.
  static constexpr std::size_t number_of_probes = 300;
  static constexpr int halvings = 32;      // of the square of the thickness, at most
  static constexpr double last_step = 0.1; // of the ascent, in units of r
  static constexpr double min_gain = 1e-3; // of a radius, relative; ends the ascent

  struct Ball
  {
    Vector center;
    double radius;
  };

  static double scale(int k) { return std::sqrt(std::ldexp(1., -k)); }

  bool fits(const Vector& p, double r) const
  {
    const auto is_near = [&](const Ball& ball) { return (ball.center - p).norm() <= m_reach * r; };
    auto near = std::find_if(m_balls.begin(), m_balls.end(), is_near);
    Ball ball = *near; // p itself is among them
    const double needed = m_width * r;
    if(ball.radius >= needed) return true;
    for(int k = 1; k < many && near != m_balls.end(); ++k)
      near = std::find_if(near + 1, m_balls.end(), is_near);
    if(near != m_balls.end() && ball.radius < hopeful * needed) return false;
    for(double step = r / 2; step > last_step * r && ball.radius < needed;)
      if(!ascend(ball, p, step, m_reach * r)) step /= 2;
    return ball.radius >= needed;
  }

  // Moves the center, within the ball, along an axis or a diagonal of space to a larger ball;
  // returns whether there is one.
  bool ascend(Ball& ball, const Vector& p, double step, double farthest) const
  {
    for(int k = 0; k < 27; ++k) {
      const Vector offset(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      const bool is_excluded = is_plane ? offset.z() != 0 : offset.squaredNorm() == 2;
      if(offset.squaredNorm() == 0 || is_excluded) continue;
      const Vector direction = offset.normalized();
      const Ball next = ball_at(ball.center + (std::min)(step, ball.radius) * direction);
      if((next.center - p).norm() > farthest) continue;
      if(!(next.radius > (1 + min_gain) * ball.radius)) continue;
      ball = next;
      return true;
    }
    return false;
  }

  Ball ball_at(const Vector& center) const
  {
    const Point_3 p = to_point(center, m_samples.traits());
    return {center, depth(m_samples.domain(), p)};
  }

  const Samples& m_samples;
  const Thickness<Point_3>& m_thickness;
  Run_watch& m_watch;
  const double m_width, m_reach; // in units of the thickness
  std::vector<Ball> m_balls;     // around the samples, the largest first
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_THIN_WALLS_H
