// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/lengths_and_turning.h>
#include <CGAL/Volume_filling_curves/internal/knots/Link_triviality.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// largest number of edges with which every closed polygon is an unknot (Randell 1994)
inline constexpr std::size_t edges_of_unknots = 5;

// Proof that component c is an unknot, if it is too simple for a knot, which has at least 6 edges
// (Randell 1994) and a total curvature above 4 pi (Fary 1949, Milnor 1950). Linear.
template <typename Network>
Unknot_proof unknot_proof(const Network& curve, std::size_t c)
{
  // 4 pi is the infimum for the trefoil; the margin is far above the rounding of a sum of angles
  constexpr double unknotted_curvature = 4 * CGAL_PI - 1e-6;
  if(!curve.is_closed(c)) return Unknot_proof::NONE;
  if(curve.first_node(c + 1) - curve.first_node(c) <= edges_of_unknots) return Unknot_proof::EDGES;
  return total_curvature(curve, c) < unknotted_curvature ? Unknot_proof::TOTAL_CURVATURE
                                                         : Unknot_proof::NONE;
}

// Proofs that the components of a moving curve are unknots, and that their link is trivial or not.
// Curves only change by isotopies, hence a proof, once found, remains valid.
struct Unknot_proofs
{
  // searches for further proofs with the current curves
  template <typename Network>
  void update(const Network& curves)
  {
    component_proofs.resize(curves.number_of_components(), Unknot_proof::NONE);
    for(std::size_t c = 0; c < component_proofs.size(); ++c)
      if(component_proofs[c] == Unknot_proof::NONE) component_proofs[c] = unknot_proof(curves, c);
    if(are_unknots()) update_link(curves);
  }

  // whether the curves are proved to be an unknot or a trivial link
  bool is_proved() const
  {
    return link == Link_status::TRIVIAL || (component_proofs.size() == 1 && are_unknots());
  }

  // Stores the proofs, and whether the components are linked, which no run needs before its end.
  template <typename Network>
  void write(const Network& curves, Untangling_result& result)
  {
    update_link(curves);
    result.proofs = component_proofs;
    result.link = link;
  }

  std::vector<Unknot_proof> component_proofs;
  Link_status link = Link_status::UNDECIDED;

private:
  bool are_unknots() const
  {
    return !component_proofs.empty() && std::find(component_proofs.begin(), component_proofs.end(),
                                                  Unknot_proof::NONE) == component_proofs.end();
  }

  template <typename Network>
  void update_link(const Network& curves)
  {
    if(link == Link_status::UNDECIDED) link = Link_triviality<Network>(curves)(component_proofs);
  }
};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_KNOTS_UNKNOT_PROOFS_H
