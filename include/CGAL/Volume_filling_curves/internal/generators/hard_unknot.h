// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_HARD_UNKNOT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_HARD_UNKNOT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/generators/polygons.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/elementary_functions.h>
#include <CGAL/Volume_filling_curves/internal/guard/halve_edge.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Generator that tangles a curve inside the unit ball by certified random moves, which keep its
// type. The curve starts coarse, with edges as long as the ball, where every move passes many other
// strands; then edges are halved, and moves continue at half the scale, until there are enough
// nodes.
template <typename Traits>
class Random_tangler
{
public:
  // Sets the clearance of the guard.
  Random_tangler(Isotopy_guard_3<Traits>& guard, std::uint64_t seed)
      : m_guard(guard), m_curve(guard.curve()), m_random(seed)
  {
    m_guard.set_clearance(clearance);
  }

  // Proposes `number_of_moves` moves by at most `reach`, each of a random node.
  void tangle(std::size_t number_of_moves, double reach)
  {
    for(std::size_t k = 0; k < number_of_moves; ++k) {
      check_run();
      const std::size_t v = m_random.index(m_curve.number_of_nodes());
      const Vector direction = m_random.direction(); // before the distance, with every compiler
      const Vector target =
          to_vector(m_curve.point(v)) + reach * cube_root(m_random.real()) * direction;
      if(target.squaredNorm() < 1) m_guard.move_node(v, to_point(target, m_curve.traits()));
    }
  }

  // Halves edges in the order of the nodes until there are `number_of_nodes`.
  void refine(std::size_t number_of_nodes)
  {
    const std::size_t n = m_curve.number_of_edges();
    for(std::size_t e = 0; e < n && m_curve.number_of_nodes() < number_of_nodes; ++e) {
      check_run();
      halve_edge(m_guard, e);
    }
    m_guard.collect_garbage();
  }

private:
  static constexpr double clearance = 0.01; // of the ball's radius

  Isotopy_guard_3<Traits>& m_guard;
  const Curve_network_3<Traits>& m_curve;
  Random_source m_random;
};

// Returns an unknot that does not look like one, in the unit ball: a circle after `number_of_moves`
// random moves, certified, and hence an unknot by construction.
// \throws std::invalid_argument for fewer than 3 nodes
inline Polygons hard_unknot(std::size_t number_of_nodes,
                            std::size_t number_of_moves,
                            std::uint64_t seed)
{
  constexpr std::size_t max_coarse_nodes = 32;
  constexpr double radius = 0.5; // of the circle
  if(number_of_nodes < 3) throw std::invalid_argument("an unknot needs at least 3 nodes");
  std::size_t coarse_nodes = number_of_nodes, number_of_levels = 1;
  for(; coarse_nodes > max_coarse_nodes; coarse_nodes = (coarse_nodes + 1) / 2) ++number_of_levels;
  Curve_network_3<> curve = closed_network({regular_polygon(coarse_nodes, radius)});
  Isotopy_guard_3<> guard(curve);
  Random_tangler<Curve_flow_traits_3<>> tangler(guard, seed);
  double reach = 2 * radius;
  for(std::size_t level = 0; level < number_of_levels; ++level, reach /= 2) {
    if(level > 0) tangler.refine(number_of_nodes);
    tangler.tangle(number_of_moves / number_of_levels, reach);
  }
  Polygon result;
  for(std::size_t v = 0; v < curve.number_of_nodes(); ++v)
    result.push_back(to_vector(curve.point(v)));
  return Polygons(1, result);
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_GENERATORS_HARD_UNKNOT_H
