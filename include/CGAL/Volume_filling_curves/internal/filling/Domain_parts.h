// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_PARTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_PARTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Domain_samples_3.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/filling/Boundary_distances.h>
#include <CGAL/Volume_filling_curves/internal/filling/Widest_ball.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/measures/Linked_samples.h>
#include <CGAL/Volume_filling_curves/internal/support/Disjoint_sets.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Connected parts of the inside of a domain, and a wide ball in each. A domain with a surface knows
// its parts, as a mesh does by its shells, including parts too small to hold a sample. For other
// domains, parts are the connected components of nearby samples; an isolated cluster is merged with
// the samples in the largest ball reached from it by ascent, and with those that the center of that
// ball sees: in a thin domain, the ball may hold no others. Hence samples of one part are certainly
// connected; a part with a passage narrower than the distance between samples may count as two.
// Near-linear in the number of samples, but quadratic if most of them are isolated.
template <typename Traits, typename Domain>
class Domain_parts
{
  using Point_3 = typename Traits::Point_3;
  using Samples = Domain_samples_3<Traits, Domain>;
  using Space = Space_of<Domain>;

public:
  using Widest = Widest_ball<Domain, Traits>;

  // Takes the distances of the samples to the boundary. A run that is to stop looks for no further
  // parts.
  Domain_parts(const Samples& samples,
               const Boundary_distances<Domain>& distances,
               Run_watch& watch)
      : m_samples(samples), m_watch(watch)
  {
    if(has_surface(samples.domain())) {
      ask_domain(distances.up_to_limit());
      find_widest(distances.limit());
    } else {
      link_samples(distances.up_to_limit());
      find_widest(distances.limit());
      unite_around_balls();
    }
  }

  // the widest ball of each part, in the order of the parts' first samples
  const std::vector<Widest>& widest_balls() const { return m_widest; }

  double max_radius() const
  {
    double largest = 0;
    for(const Widest& widest : m_widest) largest = (std::max)(largest, widest.radius());
    return largest;
  }

  // returns the part of a point inside, `widest_balls().size()` if it is unknown
  std::size_t part(const Point_3& p) const
  {
    if constexpr(Has_surface<Domain>::value)
      if(has_surface(m_samples.domain())) {
        const auto found = m_numbers.find(m_samples.domain().part(p));
        return found == m_numbers.end() ? m_widest.size() : found->second;
      }
    return part_of_visible_sample(p);
  }

private:
  // The samples of a part, and their distances to the boundary, up to a limit.
  struct Part_samples
  {
    std::vector<Point_3> points;
    std::vector<double> distances;
  };

  void ask_domain([[maybe_unused]] const std::vector<double>& distances)
  {
    if constexpr(Has_surface<Domain>::value) {
      const std::vector<Point_3>& points = m_samples.points();
      for(std::size_t k = 0; k < points.size(); ++k)
        add(m_samples.domain().part(points[k]), points[k], distances[k]);
      look_for_small_parts();
    }
  }

  void add(std::size_t label, const Point_3& p, double distance)
  {
    const std::size_t number = m_numbers.insert({label, m_numbers.size()}).first->second;
    if(number == m_parts.size()) m_parts.emplace_back();
    m_parts[number].points.push_back(p);
    m_parts[number].distances.push_back(distance);
  }

  // Random points in its box find a part without samples, unless it is very thin.
  void look_for_small_parts()
  {
    const auto& boxes = m_samples.domain().part_boxes();
    for(std::size_t label = 0; label < boxes.size(); ++label)
      if(m_numbers.count(label) == 0) look_for_part(label, boxes[label]);
  }

  void look_for_part(std::size_t label, const CGAL::Bbox_3& box)
  {
    const Domain& domain = m_samples.domain();
    Random_source random(label);
    for(std::size_t k = 0; k < points_per_box && !m_watch.must_stop(); ++k) {
      const Point_3 p = to_point(Space::random_point(box, random), m_samples.traits());
      if(domain.is_inside(p) && domain.part(p) == label) add(label, p, domain.distance(p));
    }
  }

  void link_samples(const std::vector<double>& distances)
  {
    const std::vector<Point_3>& points = m_samples.points();
    const double n = static_cast<double>(points.size());
    Linked_samples<Domain> linked(m_samples.domain(), points, Space::side(m_samples.volume() / n));
    for(std::size_t k = 0; k < points.size(); ++k)
      add(linked.sets().find(k), points[k], distances[k]);
  }

  void find_widest(double limit)
  {
    for(const Part_samples& part : m_parts)
      m_widest.emplace_back(m_samples.domain(), part.points, part.distances, limit,
                            m_samples.traits());
  }

  // Unites the sets of samples in the same ball inside, which is connected, or seen from its
  // center. The ball of the largest set is left out: balls of other sets reach that one.
  void unite_around_balls()
  {
    Disjoint_sets sets(m_parts.size());
    const auto most =
        std::max_element(m_parts.begin(), m_parts.end(), [](const auto& a, const auto& b) {
          return a.points.size() < b.points.size();
        });
    for(std::size_t k = 0; k < m_parts.size(); ++k) {
      if(sets.number_of_sets() == 1 || m_watch.must_stop()) break;
      if(&m_parts[k] == &*most) continue;
      unite_within_ball(k, sets);
      unite_with_visible(k, sets);
    }
    regroup(sets);
  }

  void unite_within_ball(std::size_t k, Disjoint_sets& sets) const
  {
    const auto is_in_ball = [&](const Point_3& p) {
      return (to_vector(p) - m_widest[k].center()).norm() < m_widest[k].radius();
    };
    for(std::size_t j = 0; j < m_parts.size(); ++j) {
      const auto& points = m_parts[j].points;
      if(sets.find(j) != sets.find(k) && std::any_of(points.begin(), points.end(), is_in_ball))
        sets.unite(j, k);
    }
  }

  void unite_with_visible(std::size_t k, Disjoint_sets& sets) const
  {
    const Point_3 center = to_point(m_widest[k].center(), m_samples.traits());
    const auto is_apart = [&](std::size_t j) { return sets.find(j) != sets.find(k); };
    for(const Neighbor& neighbor : nearest_samples(center, is_apart))
      if(is_apart(neighbor.part) && is_visible(neighbor, center)) sets.unite(neighbor.part, k);
  }

  // United parts keep the widest ball.
  void regroup(Disjoint_sets& sets)
  {
    std::map<std::size_t, std::size_t> widest; // of the parts with the same root
    for(std::size_t k = 0; k < m_parts.size(); ++k) {
      std::size_t& best = widest.insert({sets.find(k), k}).first->second;
      if(m_widest[k].radius() > m_widest[best].radius()) best = k;
    }
    std::vector<Widest> balls;
    std::map<std::size_t, std::size_t> numbers;
    for(const auto& [root, best] : widest) {
      numbers[root] = balls.size();
      balls.push_back(m_widest[best]);
    }
    std::vector<Part_samples> parts(balls.size());
    for(std::size_t k = 0; k < m_parts.size(); ++k) {
      auto& points = parts[numbers[sets.find(k)]].points;
      points.insert(points.end(), m_parts[k].points.begin(), m_parts[k].points.end());
    }
    m_parts = std::move(parts);
    m_widest = std::move(balls);
  }

  struct Neighbor
  {
    double squared_distance;
    std::size_t part;
    Point_3 point;
  };

  // Samples of the parts for which `is_wanted(part)` holds, from the nearest one.
  template <typename Predicate>
  std::vector<Neighbor> nearest_samples(const Point_3& p, const Predicate& is_wanted) const
  {
    std::vector<Neighbor> neighbors;
    for(std::size_t k = 0; k < m_parts.size(); ++k)
      if(is_wanted(k))
        for(const Point_3& q : m_parts[k].points)
          neighbors.push_back({(to_vector(q) - to_vector(p)).squaredNorm(), k, q});
    const std::size_t n = (std::min)(tried_samples, neighbors.size());
    const auto end = neighbors.begin() + static_cast<std::ptrdiff_t>(n);
    std::partial_sort(neighbors.begin(), end, neighbors.end(), [](const auto& a, const auto& b) {
      return a.squared_distance < b.squared_distance;
    });
    neighbors.erase(end, neighbors.end());
    return neighbors;
  }

  bool is_visible(const Neighbor& neighbor, const Point_3& from) const
  {
    return m_samples.domain().is_triangle_inside(from, neighbor.point, neighbor.point);
  }

  // The part of the nearest sample that is visible from p.
  std::size_t part_of_visible_sample(const Point_3& p) const
  {
    for(const Neighbor& neighbor : nearest_samples(p, [](std::size_t) { return true; }))
      if(is_visible(neighbor, p)) return neighbor.part;
    return m_widest.size();
  }

  static constexpr std::size_t points_per_box = 1000; // miss 1 % of a box with probability 4e-5
  static constexpr std::size_t tried_samples = 64;    // each costs a query of the domain

  const Samples& m_samples;
  Run_watch& m_watch;
  std::map<std::size_t, std::size_t> m_numbers; // of the parts, by their labels in the domain
  std::vector<Part_samples> m_parts;
  std::vector<Widest> m_widest;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_DOMAIN_PARTS_H
