// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/bending/Shape_goal.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Stage of the growth of a curve, and its stop rule. Figures found on the domains of the benchmarks
// (2026-11-23).
struct Filling_stage
{
  static constexpr double any_change = std::numeric_limits<double>::infinity();
  static constexpr std::size_t any = (std::numeric_limits<std::size_t>::max)();

  double screening = 1;           // in units of the parameter
  double max_radius = 2;          // at most, in units of the thickness
  double max_displacement = 0.1;  // likewise
  double direction_weight = 1;    // in units of the parameter
  double cooling = 1;             // factor of the largest displacement in each step
  double spacing = 0;             // at least, in units of the thickness
  double separation = 0;          // distance to which strands are moved apart, likewise
  std::size_t directions = any;   // of the medial spheres, at most
  std::size_t window = 10;        // the stage ends if over that many iterations
  double change_of_length = 1e-2; // the length changed by less than this fraction of it
  double max_growth = any_change; // of the length; a curve that grows more does not fit
  double thickness = 1;           // of the flow, in units of the required one
  double coupling = 1;            // in units of the parameter
  double roundness = 1;           // of bends, in units of the required bend radius
  Shape_phase phase = Shape_phase::NONE;

  // Half as many nodes as with the default spacing, and longer steps: from a circle the bunny is
  // filled in 3.3 instead of 7.5 s, with 0.4 it ends too thin.
  static constexpr double coarse_spacing = 0.3;

  // Until the strands have settled. With 16 until then domains are filled to 1 % less in
  // a tenth more time; with 4, or 6, strands come closer together than r, or stay farther apart.
  static constexpr std::size_t few_directions = 8;

  // With the screening of the parameters, the bunny takes 400 iterations instead of 80 to come
  // within 2 % of its length.
  static Filling_stage growth()
  {
    Filling_stage stage;
    stage.screening = 30;
    stage.direction_weight = 4; // now, while strands move far, it costs less coverage than later
    stage.max_radius = 6;
    stage.max_displacement = 0.5;
    stage.spacing = coarse_spacing;
    stage.directions = few_directions;
    return stage;
  }

  // with a multiple of the thickness
  static Filling_stage coarse_growth()
  {
    Filling_stage stage = growth();
    stage.change_of_length = 2e-2;
    return stage;
  }

  // Six iterations fill what fingers have reached; more of them do not space the strands more
  // evenly.
  static Filling_stage opening()
  {
    Filling_stage stage = growth();
    stage.max_radius = 3;
    stage.max_displacement = 1; // with 0.5 the bunny is filled to 77 % instead of 79 %
    stage.spacing = 0; // with 0.3 the fingers' corners are cut, and 78 % of the bunny are filled
    stage.window = 6;
    stage.change_of_length = any_change;
    return stage;
  }

  // Each step is a fifth smaller than the one before, until nodes move no farther than 0.06 r.
  // Without that the length of the torus keeps oscillating by 0.4 %. Continuing until the length
  // changes by less than 0.1 % over 20 iterations takes 20 more of them, for the same coverage.
  //
  // Strands that fingers brought close together, about one in a thousand nodes, part in two
  // iterations.
  static Filling_stage settling()
  {
    Filling_stage stage;
    stage.screening = 3;
    stage.max_displacement = 0.6;
    stage.spacing = coarse_spacing; // with 0.4 flat domains and corners end too thin
    stage.directions = few_directions;
    stage.separation = 0.7; // with 0.9 thick curves are pushed out of shape between the walls
    stage.cooling = 0.8;    // with 0.7 small domains end too dense
    stage.window = 10;
    stage.change_of_length = any_change;
    return stage;
  }

  // With edges of the required length, the strands become slightly more even.
  static Filling_stage refining()
  {
    Filling_stage stage = settling();
    stage.spacing = 0;
    stage.directions = any;
    stage.max_displacement = 0.1;
    stage.window = 5;
    return stage;
  }

  // Bends the curve within its limits, from the opened fingers; settling first would be undone
  // here. With the required thickness the curve would contract as its bends open; with 0.3 of it
  // the medial spheres, of up to 1.8 r, push strands apart until their required distance holds
  // them. Two directions, to both sides in the plane of each bend, push it outwards twice as hard
  // as eight around the curve: five domains are filled to 88 instead of 83 %. Without coupling the
  // matrix has three diagonals; projections couple the strands.
  //
  // Bends get 0.8 of their radius here, and the rest from polishing, which keeps the length of the
  // curve; bent further, the curve shortens, and leaves ears and spikes. Nine domains, two
  // thicknesses, three seeds: 93 instead of 89 % filled; with 0.7, one of 132 runs jammed, none
  // with 0.8 (2026-11-28).
  static Filling_stage bending()
  {
    Filling_stage stage = bending_in_full();
    stage.roundness = 0.8;
    stage.window = 12; // with 16 and a cooling of 0.9, five domains are filled to 0.3 % more
    stage.cooling = 0.87;
    return stage;
  }

  // Bends with the whole radius, which leaves the curve less dense: one that has jammed, or that
  // cannot be dense. Of 150 arcs between two ports of a cube of side 8 r, eight jam, none of them
  // again after this stage (2026-11-28).
  static Filling_stage bending_in_full() { return bending_with(0.3, 2); }

  // Bends a curve that has jammed again, less dense still.
  static Filling_stage loosening() { return bending_with(0.6, few_directions); }

  // Projections alone, until the limits are kept: one or two steps of at most five motions on nine
  // domains.
  static Filling_stage polishing()
  {
    Filling_stage stage;
    stage.phase = Shape_phase::POLISHING;
    stage.spacing = coarse_spacing;
    stage.directions = few_directions;
    stage.window = 20;
    stage.change_of_length = any_change;
    return stage;
  }

private:
  static Filling_stage bending_with(double thickness, std::size_t directions)
  {
    Filling_stage stage;
    stage.phase = Shape_phase::BENDING;
    stage.thickness = thickness;
    stage.coupling = 0;
    stage.max_radius = 1.8 / thickness;
    stage.max_displacement = 0.3 / thickness;
    stage.cooling = 0.83;
    stage.spacing = coarse_spacing / thickness;
    stage.directions = directions;
    stage.window = 16; // with 12 one of 36 fillings kept strands too close (2026-11-26)
    stage.change_of_length = any_change;
    stage.max_growth = 2; // exceeded between pinned nodes without room; others grow by 1.2
    return stage;
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_FILLING_FILLING_STAGE_H
