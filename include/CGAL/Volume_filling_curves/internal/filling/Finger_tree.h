// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_TREE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_TREE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/filling/Finger_connections.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_reach.h>
#include <CGAL/Volume_filling_curves/internal/filling/Finger_stations.h>
#include <CGAL/Volume_filling_curves/internal/filling/Path_search.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Space.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/guard/Clearance_rule.h>
#include <CGAL/Volume_filling_curves/internal/parameters/Thickness.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Tree of fingers that grow from curves through a whole domain before the flow. They follow a
// random spanning tree of well-spaced points that starts from all points of the curves (Prim's
// algorithm). A small circle becomes the outline of a tree, isotopic to it. The component with the
// least volume per share grows next. Points that no straight finger reaches, for example behind a
// neck, are reached by thin fingers along paths from a search. Near-linear in the number of points,
// but for the search among edges, which the tree of boxes holds in the order of their growth:
// 13,000, 102,000 and 270,000 points of a box take 0.5, 7 and 35 s.
template <typename Guard, typename Domain>
class Finger_tree
{
  using Network = typename Guard::Curve_network;
  using Traits = typename Network::Traits;
  using Stations = Finger_stations<Guard, Domain>;
  using Connections = Finger_connections<Stations, Traits>;
  using Paths = Path_search<Domain, Traits>;

public:
  // A run that is to stop grows no more fingers.
  Finger_tree(Guard& guard,
              const Domain& domain,
              const Thickness<typename Guard::Point_3>& thickness,
              std::size_t seed,
              Run_watch& watch)
      : m_guard(guard),
        m_domain(domain),
        m_thickness(thickness),
        m_watch(watch),
        m_random(seed),
        m_reach_out(guard, domain)
  {}

  // Makes the tree prefer connections along a field, if there is one and the weight is not 0.
  void follow(const typename Connections::Direction_field& field, double weight)
  {
    if(!field || !(weight > 0)) return;
    m_direction_field = field;
    m_detour = detour_over_weight * weight;
    m_spacing = spacing_along_field;
  }

  // Divides the volume among the components in the proportion of the shares, if there are any.
  void divide_volume(const std::vector<double>& shares) { m_shares = shares; }

  // Grows all fingers, and renumbers the nodes. Fingers need not keep the clearance of the guard:
  // the flow moves their strands apart.
  void grow()
  {
    const Clearance_scope<Guard> scope(m_guard, 0);
    Stations& stations = m_stations.emplace(m_guard, m_domain, m_thickness, m_spacing, m_watch);
    m_connections.emplace(stations, m_random, m_guard.curve().traits());
    m_connections->follow(m_direction_field, m_detour);
    m_volumes.resize(m_guard.curve().number_of_components(), 0);
    if(m_shares.empty()) m_shares.assign(m_volumes.size(), 1);
    CGAL_precondition_msg(m_shares.size() == m_volumes.size(), "each component has a share");
    stations.add_targets(m_random.bits());
    for(std::size_t s = 0; s < stations.number_of_roots(); ++s) reach(s, stations[s].component);
    for(std::size_t c = 0; c < m_volumes.size(); ++c) enqueue(c);
    grow_all();
    reach_rest();
    m_guard.collect_garbage();
  }

  // the number of points that the curves do not pass at the start. \pre grow() has been called
  std::size_t number_of_targets() const { return m_stations->number_of_targets(); }
  std::size_t number_of_fingers() const { return m_number_of_fingers; }

private:
  // In units of the thickness. A finger consists of two strands, which lie side by side in the
  // plane, and among six others in space. Planar fillings end alike from 3.4 to 4.6: with 92.8 to
  // 94.7 % of the area within r, and strands 1.84 to 1.94 r apart (medians).
  static constexpr double spacing = Space_of<Domain>::is_plane ? 4 : 2.9; // of the stations
  // Strands side by side leave longer gaps: with 2.9 the bunny ends with p99 1.43 (2026-11-22).
  static constexpr double spacing_along_field = Space_of<Domain>::is_plane ? 3.65 : 2.65;
  static constexpr double cell_sizes[] = {0.5, 0.25, 0.125};
  static constexpr double detour_over_weight = 20; // see m_detour; twice that changes little
  // The cells visited by all searches together take less time than the flow.
  static constexpr std::size_t min_cells = 100000, cells_per_target = 200;
  static constexpr std::size_t max_tries = 4;  // from one search
  static constexpr std::size_t max_nearby = 4; // stations near a cell

  // Records that a component has reached a station.
  void reach(std::size_t s, std::size_t component)
  {
    (*m_stations)[s].component = component;
    if(m_stations->is_target(s)) ++m_number_of_fingers;
    // A root is a stretch with one strand, a finger has two. With whole roots, an arc with a share
    // of 0.17 ended with 0.04 of the length (2026-11-27).
    const double fingers = m_stations->is_root(s) ? 0.5 : 1;
    m_volumes[component] += fingers * Space_of<Domain>::content(m_stations->spacing(s));
    m_connections->add_from(s);
  }

  void grow_all()
  {
    while(!m_smallest_first.empty() && !m_watch.must_stop()) grow_smallest();
  }

  double fraction_done() const
  {
    return static_cast<double>(m_number_of_fingers) /
           static_cast<double>(m_stations->number_of_targets());
  }

  // Grows a finger from the component with the smallest volume per share.
  void grow_smallest()
  {
    const std::size_t component = m_smallest_first.top().second;
    m_smallest_first.pop();
    while(const auto connection = m_connections->take(component)) {
      if(m_watch.must_stop(fraction_done())) return;
      Finger_station& to = (*m_stations)[connection->to];
      if(!m_reach_out((*m_stations)[connection->from], to)) continue;
      reach(connection->to, component);
      return enqueue(component);
    }
  }

  void enqueue(std::size_t component)
  {
    m_smallest_first.push({m_volumes[component] / m_shares[component], component});
  }

  // Leads fingers along paths to the remaining targets, wide paths first.
  void reach_rest()
  {
    const std::size_t end = m_stations->number_of_roots() + m_stations->number_of_targets();
    Paths paths(m_domain, m_guard.curve().traits(),
                min_cells + cells_per_target * m_stations->number_of_targets());
    for(const double cell : cell_sizes)
      for(std::size_t s = m_stations->number_of_roots(); s < end; ++s)
        if(m_watch.must_stop())
          return;
        else if(!(*m_stations)[s].is_reached() && reach_along_path(s, cell, paths))
          grow_all();
  }

  // Returns whether a finger reaches the station.
  bool reach_along_path(std::size_t s, double cell, Paths& paths)
  {
    std::size_t tries = 0;
    paths.search((*m_stations)[s].position, cell * (*m_stations)[s].thickness,
                 [&](const Vector& p) {
                   for(const std::size_t t : reached_near(p)) {
                     if(!paths.sees((*m_stations)[t].position, p)) continue;
                     const double max_step = Connections::reach * m_stations->spacing(t);
                     const auto path = paths.path_from((*m_stations)[t].position, max_step);
                     if(grow_along(path, t, s) || ++tries == max_tries) return true;
                   }
                   return m_watch.must_stop();
                 });
    return (*m_stations)[s].is_reached();
  }

  // the reached stations nearest to p
  std::vector<std::size_t> reached_near(const Vector& p)
  {
    const double distance = Connections::reach * m_spacing * thickness_at(p);
    std::vector<std::pair<double, std::size_t>> nearest;
    for(const std::size_t t : m_stations->within(distance, p))
      if((*m_stations)[t].is_reached())
        nearest.push_back({((*m_stations)[t].position - p).squaredNorm(), t});
    std::sort(nearest.begin(), nearest.end());
    nearest.resize((std::min)(nearest.size(), max_nearby));
    std::vector<std::size_t> stations;
    for(const auto& [d, t] : nearest) stations.push_back(t);
    return stations;
  }

  double thickness_at(const Vector& p) const
  {
    return m_thickness(to_point(p, m_guard.curve().traits()));
  }

  // Grows a finger along a path, whose last point is the station `to`.
  bool grow_along(const std::vector<Vector>& path, std::size_t from, std::size_t to)
  {
    const std::size_t component = (*m_stations)[from].component;
    for(std::size_t k = 0; k < path.size(); ++k) {
      const std::size_t next = k + 1 == path.size() ? to : m_stations->add_waypoint(path[k]);
      Finger_station &here = (*m_stations)[from], &there = (*m_stations)[next];
      if(!m_reach_out(here, there) && !m_reach_out.squeeze(here, there)) return false;
      reach(next, component);
      from = next;
    }
    enqueue(component);
    return true;
  }

  Guard& m_guard;
  const Domain& m_domain;
  const Thickness<typename Guard::Point_3> m_thickness;
  Run_watch& m_watch;
  Random_source m_random;
  Finger_reach<Guard, Domain> m_reach_out;
  typename Connections::Direction_field m_direction_field; // null without a field
  double m_detour = 0; // by how much more length across the field counts
  double m_spacing = spacing;
  std::size_t m_number_of_fingers = 0;
  std::vector<double> m_shares; // of the volume, of the components

  // of grow()
  std::optional<Stations> m_stations;
  std::optional<Connections> m_connections;
  std::vector<double> m_volumes; // of the components so far

  using Volume = std::pair<double, std::size_t>; // per share of a component, and its index
  std::priority_queue<Volume, std::vector<Volume>, std::greater<Volume>> m_smallest_first;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FINGER_TREE_H
