// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_SHAPED_STEP_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_SHAPED_STEP_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_check.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/bending/Wall_planes.h>
#include <CGAL/Volume_filling_curves/internal/flow/Node_set.h>
#include <CGAL/Volume_filling_curves/internal/flow/Strand_separator.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector_field.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Steps of a curve towards the limits of its shape. A bending step follows the direction of the
// flow, which presses the curve outwards; sweeps of projections then bring the targets towards the
// limits. A polishing step consists of projections alone, and is the last kind: polishing ends once
// the limits are kept. The guard may shorten displacements, hence limits are measured, not assumed.
template <typename Guard, typename ConcurrencyTag>
class Shaped_step
{
public:
  Shaped_step(Guard& guard, const Shape_goal& goal, const std::vector<double>& thickness)
      : m_guard(guard), m_limits(guard.curve(), goal, thickness)
  {
    for(std::size_t v = 0; v < thickness.size(); ++v)
      m_units.push_back(m_limits.strand_distance[v] > 0 ? m_limits.strand_distance[v]
                                                        : 2 * m_limits.bend_radius[v]);
  }

  // Takes the direction of each node, the longest displacement of a motion, and the number of steps
  // so far. Returns whether any node moved.
  bool bend(const Vector_field& direction, double max_motion, std::size_t number_of_steps)
  {
    bool has_moved = false;
    for(int k = 0; k < motions_to_bend; ++k) {
      std::vector<Vector> x = positions();
      find_surroundings(x);
      for(std::size_t v = 0; v < x.size(); ++v) {
        const Vector u = row(direction, v);
        const double length = u.norm();
        x[v] += length > max_motion ? Vector(max_motion / length * u) : u;
      }
      has_moved = project(std::move(x), sweeps_of_step(number_of_steps), false, 1) || has_moved;
    }
    return has_moved;
  }

  // Moves nodes near those where a limit is exceeded, along a curve that keeps its length if it is
  // tense. Returns whether any moved; none does if the limits are kept.
  bool polish(bool is_tense)
  {
    find_surroundings(positions());
    const Shape_check check(m_guard.curve(), m_limits, *m_pairs);
    if(check.is_passed()) return false;
    return project(positions(), sweeps_to_polish, is_tense, relaxation_to_polish,
                   nodes_near(m_guard.curve(), *m_pairs, check.exceeding_nodes));
  }

private:
  // Figures found on six domains, with a bend radius of 0.85 r and a strand distance of 1.6 r
  // (2026-11-24).
  static constexpr double slack = 0.25; // in strand distances: two nodes go half of that each
  static constexpr double first_sweeps = 2, growth_of_sweeps = 1.2, max_sweeps = 40;
  static constexpr double parting_distance = 0.25; // of held strands, in units of the node
  static constexpr double wall_distance = 1. / 16; // likewise

  // With a direction and surroundings of its own for each motion torus and cube take 1.5 times as
  // long (2026-11-25). With three motions domains are filled to 0.5 % more in 1.3 times the time,
  // with one to 1.3 % less in 0.8 times (2026-11-26).
  static constexpr int motions_to_bend = 2;

  // With 20, which take as long altogether, a tight turn of a bunny of 43,000 nodes held out for 20
  // steps, so that all of it was loosened, to 76 instead of 92 % within r; arcs between ports of
  // boxes and balls came within r of 80 instead of 85 % (2026-11-27).
  static constexpr int sweeps_to_polish = 200;
  // Of corners. Without it, polishing takes 1.7 times as long; strands, relaxed likewise, crumple
  // (2026-11-28).
  static constexpr double relaxation_to_polish = 1.6;

  // First the curve opens, then it settles within its limits.
  static int sweeps_of_step(std::size_t k)
  {
    double sweeps = first_sweeps;
    for(; k > 0 && sweeps < max_sweeps; --k) sweeps *= growth_of_sweeps;
    return static_cast<int>((std::min)(sweeps, max_sweeps));
  }

  std::vector<Vector> positions() const
  {
    std::vector<Vector> x;
    for(const auto& p : m_guard.curve().points()) x.push_back(to_vector(p));
    return x;
  }

  // Finds pairs and walls near the nodes at x, unless no node has moved far since the last time.
  void find_surroundings(const std::vector<Vector>& x)
  {
    if(m_pairs && !has_any_moved_far(x)) return;
    m_found_at = x;
    m_pairs.emplace(ConcurrencyTag(), m_guard.curve(), m_limits, slack);
    std::vector<double> wall_distances = m_units;
    for(double& distance : wall_distances) distance *= wall_distance;
    m_walls.find(m_guard.curve(), m_guard.boundary(), wall_distances);
  }

  bool has_any_moved_far(const std::vector<Vector>& x) const
  {
    for(std::size_t v = 0; v < x.size(); ++v)
      if((x[v] - m_found_at[v]).norm() > slack / 2 * m_units[v]) return true;
    return false;
  }

  // Projects the nodes that may move, all of them if none is named.
  bool project(std::vector<Vector> x,
               int sweeps,
               bool is_tense,
               double relaxation,
               const std::vector<bool>& moving = {})
  {
    const std::vector<Vector> former = positions();
    Shape_projection projection(m_guard.curve(), m_limits, *m_pairs, m_walls);
    if(!moving.empty()) projection.move_only(moving);
    projection(x, sweeps, is_tense, relaxation);
    Vector_field targets(static_cast<Eigen::Index>(x.size()), 3);
    for(std::size_t v = 0; v < x.size(); ++v) set_row(targets, v, x[v]);
    project_targets(m_guard.curve(), m_guard.boundary(), targets);
    const std::vector<double> fractions = m_guard.template advance_nodes<ConcurrencyTag>(targets);
    const bool is_any_held = std::find(fractions.begin(), fractions.end(), 0.) != fractions.end();
    const bool have_strands_parted = is_any_held && part_strands();
    bool has_moved = have_strands_parted;
    for(std::size_t v = 0; v < x.size(); ++v)
      has_moved = has_moved || (fractions[v] > 0 && x[v] != former[v]);
    return has_moved;
  }

  // Moves strands that block one another apart before the next projection: nodes whose projection
  // is refused cannot move in other directions, either.
  bool part_strands()
  {
    double unit = std::numeric_limits<double>::infinity(); // the least; closing rays have none
    for(const double u : m_units)
      if(u > 0) unit = (std::min)(unit, u);
    const double distance = parting_distance * unit;
    return Strand_separator<Guard, ConcurrencyTag>(m_guard, distance, distance)();
  }

  Guard& m_guard;
  const Shape_limits m_limits;
  std::vector<double> m_units; // of each node: the strand distance, or the diameter of a bend
  std::optional<Strand_pairs> m_pairs;
  Wall_planes m_walls;
  std::vector<Vector> m_found_at; // positions for which pairs and walls were found
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FLOW_SHAPED_STEP_H
