// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_EMPTY_REGION_SEARCH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_EMPTY_REGION_SEARCH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/measures/Linked_samples.h>
#include <CGAL/Volume_filling_curves/internal/search/Distance_to_curve.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Search for regions that the curve has not reached. Samples farther than 2 r from the curve form
// regions, joined where they are close and the segment between them lies inside. From the sample
// with the largest clearance, a ball grows by moving its center, always within the previous ball,
// so that it stays in the same part of the domain; the samples in it also belong to the region. A
// region counts if its ball has a radius of at least r / 2. Linear in the number of samples, and
// near-linear in the number of empty ones, for each of at most 256 balls.
template <typename Traits, typename Domain, typename BoundaryDistance, typename Thickness>
class Empty_region_search
{
public:
  struct Region
  {
    Vector center;
    double radius; // of the ball
    std::size_t number_of_samples;
  };

  // `distances` are those of the samples from the curve. `boundary_distance` is a function of the
  // sample's number, `thickness` one of the point; `spacing` is the edge of the cube, or square,
  // that holds one sample on average. All but samples and distances must outlive the search.
  Empty_region_search(const Distance_to_curve& curve,
                      const Domain& domain,
                      const Thickness& thickness,
                      const std::vector<typename Traits::Point_3>& samples,
                      const std::vector<double>& distances,
                      const BoundaryDistance& boundary_distance,
                      double spacing,
                      const Traits& traits,
                      Run_watch* watch = nullptr)
      : m_curve(curve),
        m_domain(domain),
        m_thickness(thickness),
        m_boundary_distance(boundary_distance),
        m_spacing(spacing),
        m_traits(traits),
        m_watch(watch)
  {
    for(std::size_t i = 0; i < samples.size(); ++i) {
      const double gap = distances[i] - 2 * m_thickness(samples[i]);
      if(gap > 0) m_empty.push_back({samples[i], to_vector(samples[i]), gap, i});
    }
    std::stable_sort(m_empty.begin(), m_empty.end(),
                     [](const Sample& a, const Sample& b) { return a.gap > b.gap; });
  }

  // returns the regions, the one with most samples first. \throws Run_stopped
  std::vector<Region> run()
  {
    link();
    std::vector<std::pair<std::size_t, Region>> balls; // with a sample of the region
    for(const Start& start : samples_with_max_clearance()) {
      const Region ball = ascend(m_empty[start.sample].position);
      if(ball.radius < m_thickness(to_point(ball.center, m_traits)) / 2) continue;
      unite_samples_in(ball, start.sample);
      balls.push_back({start.sample, ball});
    }
    return regions_with(balls);
  }

private:
  struct Sample
  {
    typename Traits::Point_3 point;
    Vector position;
    double gap; // how much farther than 2 r the curve is
    std::size_t number;
  };

  // An empty sample to ascend from.
  struct Start
  {
    std::size_t sample;
    double clearance;
  };

  static constexpr std::size_t max_ascents = 256; // each visits all empty samples
  static constexpr double ascent_end = 1. / 16;   // of r: shorter steps end an ascent
  static constexpr double min_gain = 1e-3;        // of the step: with less, the step is halved

  void link()
  {
    std::vector<typename Traits::Point_3> points;
    for(const Sample& sample : m_empty) points.push_back(sample.point);
    Linked_samples<Domain> linked(m_domain, points, m_spacing, m_watch);
    m_link = linked.link();
    m_sets = std::move(linked.sets());
  }

  // In the order of their first members, each in the order of the samples. The root of a set is its
  // first member, see Disjoint_sets.
  std::vector<std::vector<std::size_t>> sets()
  {
    std::vector<std::vector<std::size_t>> result;
    std::vector<std::size_t> position(m_empty.size());
    for(std::size_t k = 0; k < m_empty.size(); ++k) {
      const std::size_t root = m_sets.find(k);
      if(root == k) {
        position[k] = result.size();
        result.emplace_back();
      }
      result[position[root]].push_back(k);
    }
    return result;
  }

  // One sample of each set. If there are very many sets, such as single samples in a thin plate,
  // those with the largest clearance.
  std::vector<Start> samples_with_max_clearance()
  {
    std::vector<Start> starts;
    for(const auto& members : sets()) starts.push_back(sample_with_max_clearance(members));
    if(starts.size() <= max_ascents) return starts;
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.clearance > b.clearance; });
    starts.resize(max_ascents);
    return starts;
  }

  // The gaps are sorted: the distance to the boundary is measured for few samples.
  Start sample_with_max_clearance(const std::vector<std::size_t>& members) const
  {
    Start best{members.front(), -1};
    for(const std::size_t k : members) {
      if(m_empty[k].gap <= best.clearance) break;
      check(m_watch);
      const double clearance = (std::min)(m_empty[k].gap, m_boundary_distance(m_empty[k].number));
      if(clearance > best.clearance) best = {k, clearance};
    }
    return best;
  }

  // Radius of the largest ball around the center that is inside and farther than 2 r from the
  // curve; not positive if there is none.
  double clearance(const Vector& center) const
  {
    const auto point = to_point(center, m_traits);
    check(m_watch);
    if(!m_domain.is_inside(point)) return 0;
    return (std::min)(m_curve.distance(center) - 2 * m_thickness(point), m_domain.distance(point));
  }

  // Ascends along the axes to a larger clearance, with steps that shrink where there is none.
  Region ascend(const Vector& start) const
  {
    Region ball{start, clearance(start), 0};
    double step = m_link;
    while(step > ascent_end * m_thickness(to_point(ball.center, m_traits))) {
      Region next = ball;
      const double length = (std::min)(step, (std::max)(ball.radius, 0.));
      for(int i = 0; i < 6; ++i) {
        Vector trial = ball.center;
        trial[i / 2] += i % 2 == 0 ? length : -length;
        const double clearance_there = clearance(trial);
        if(clearance_there > next.radius) next = {trial, clearance_there, 0};
      }
      const double gain = next.radius - ball.radius;
      if(!(gain > min_gain * length)) step /= 2;
      ball = next;
    }
    return ball;
  }

  void unite_samples_in(const Region& ball, std::size_t start)
  {
    for(std::size_t k = 0; k < m_empty.size(); ++k)
      if((m_empty[k].position - ball.center).squaredNorm() < ball.radius * ball.radius)
        m_sets.unite(k, start);
  }

  // Keeps the largest of the balls that turned out to lie in the same region.
  std::vector<Region> regions_with(const std::vector<std::pair<std::size_t, Region>>& balls)
  {
    std::map<std::size_t, Region> best;
    for(const auto& [k, ball] : balls) {
      Region& region = best.insert({m_sets.find(k), ball}).first->second;
      if(ball.radius > region.radius) region = ball;
    }
    for(std::size_t k = 0; k < m_empty.size(); ++k)
      if(const auto found = best.find(m_sets.find(k)); found != best.end())
        ++found->second.number_of_samples;
    std::vector<Region> regions;
    for(const auto& [set, region] : best) regions.push_back(region);
    std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
      return a.number_of_samples > b.number_of_samples;
    });
    return regions;
  }

  const Distance_to_curve& m_curve;
  const Domain& m_domain;
  const Thickness& m_thickness;
  const BoundaryDistance& m_boundary_distance;
  double m_spacing;
  const Traits& m_traits;
  Run_watch* m_watch;          // none if null
  std::vector<Sample> m_empty; // by gap, the largest first
  double m_link = 0;           // the largest distance of samples that are linked
  Disjoint_sets m_sets{0};     // of the indices of m_empty
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_MEASURES_EMPTY_REGION_SEARCH_H
