// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Corner_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Length_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Projected_nodes.h>
#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_pairs.h>
#include <CGAL/Volume_filling_curves/internal/bending/Strand_projection.h>
#include <CGAL/Volume_filling_curves/internal/bending/Wall_planes.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>

#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Projection of the nodes of a curve towards the limits of its shape, constraint by constraint
// (position based dynamics; Mueller et al. 2007): edges get their lengths, strands move apart,
// nodes leave the walls, and corners open. Each sweep visits the constraints in the order of the
// curve. Displacements are linear combinations of differences of positions and of the walls'
// normals, hence do not depend on the frame. Linear time; sweeps leave out stretches of the curve
// in which all nodes are held.
class Shape_projection
{
public:
  // The limits, the pairs and the walls must outlive the projection.
  template <typename Network>
  Shape_projection(const Network& curve,
                   const Shape_limits& limits,
                   const Strand_pairs& pairs,
                   const Wall_planes& walls)
      : m_nodes(curve), m_limits(limits), m_pairs(pairs), m_walls(walls)
  {}

  // Holds the other nodes where they are.
  void move_only(const std::vector<bool>& moving) { m_nodes.move_only(moving); }

  // Sweeps over nodes at x. A tense curve keeps its length; otherwise its edges are evened. Corners
  // open by a multiple of their excess (successive over-relaxation) but in the last quarter of the
  // sweeps: where limits conflict, they would keep oscillating.
  void operator()(std::vector<Vector>& x, int sweeps, bool is_tense, double relaxation = 1) const
  {
    std::vector<Length_projection> lengths;
    std::vector<Corner_projection> corners;
    for(const auto& path : m_nodes.paths()) {
      lengths.emplace_back(m_nodes, m_limits, path, is_tense);
      corners.emplace_back(m_nodes, m_limits, path, margin);
    }
    Strand_projection strands(m_nodes, m_pairs, margin);
    for(int k = 0; k < sweeps; ++k) {
      if(k % sweeps_per_search == 0) strands.find_contacts(x);
      const double factor = 4 * k < 3 * sweeps ? relaxation : 1;
      check_run();
      for(const Length_projection& project : lengths) project(x);
      check_run();
      strands(x);
      check_run();
      m_walls.push_inside(x, m_nodes.mobility());
      for(const Corner_projection& project : corners) project(x, factor);
    }
  }

private:
  // Projections converge from outside, hence aim slightly beyond the limits, by this factor.
  // With 1.02 domains are filled to 0.7 % less (2026-11-26).
  static constexpr double margin = 1.01;

  // Sweeps between searches for close strands. If they visited all pairs, a cube of side 20 r would
  // take 1.2 times as long (2026-11-25); with rarer searches, more strands come close unseen.
  static constexpr int sweeps_per_search = 8;

  Projected_nodes m_nodes;
  const Shape_limits& m_limits;
  const Strand_pairs& m_pairs;
  const Wall_planes& m_walls;
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_BENDING_SHAPE_PROJECTION_H
