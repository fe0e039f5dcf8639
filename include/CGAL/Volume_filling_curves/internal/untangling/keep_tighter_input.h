// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_KEEP_TIGHTER_INPUT_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_KEEP_TIGHTER_INPUT_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/curve_measures.h>
#include <CGAL/Volume_filling_curves/internal/curve/curve_walks.h>
#include <CGAL/Volume_filling_curves/internal/knots/unknot_proof.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_parameters.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Untangling_result.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// A curve that comes tight must not go looser: the flow ends about 16 % above the ideal ropelength,
// and a curve that was tightened otherwise may be below that. Then the input is the better result,
// if it is as simple, too. Near linear time.

template <typename Network>
std::vector<Unknot_proof> unknot_proofs(const Network& curves)
{
  std::vector<Unknot_proof> proofs;
  for(std::size_t c = 0; c < curves.number_of_components(); ++c)
    proofs.push_back(unknot_proof(curves, c));
  return proofs;
}

// Whether the first curves have a lower ropelength than the second ones, and about as few
// crossings: tight curves have up to 5 % more of them than the same ones a bit loose. What is
// proved of the second ones must be provable of the first ones.
template <typename Network>
bool is_tighter(const Network& first,
                const Network& second,
                Untangling_status status,
                Run_watch& watch)
{
  constexpr double most_crossings = 1.1; // of one, in units of the other's
  watch.check();
  if(!(ropelength(first) < ropelength(second))) return false;
  watch.check();
  const std::vector<Unknot_proof> proofs = unknot_proofs(first);
  if(status == Untangling_status::UNKNOTTED &&
     std::find(proofs.begin(), proofs.end(), Unknot_proof::NONE) != proofs.end())
    return false;
  return average_crossing_number(first, 1, &watch) <=
         most_crossings * average_crossing_number(second, 1, &watch);
}

// likewise; if the run must stop before that is known, they are not
template <typename Network>
bool is_known_to_be_tighter(const Network& first,
                            const Network& second,
                            Untangling_status status,
                            Run_watch& watch)
{
  try {
    return is_tighter(first, second, status, watch);
  } catch(const Run_stopped&) {
    return false;
  }
}

// Puts the input in the place of the result if that is looser, with an empty record of changes.
// A result with a given thickness has that thickness, and stays.
template <typename Network>
void keep_tighter_input(Network&& input,
                        const Untangling_parameters& parameters,
                        Run_watch& watch,
                        Network& curves,
                        Untangling_result& result)
{
  if(parameters.strategy != Untangling_strategy::AUTO || parameters.thickness > 0 ||
     result.status == Untangling_status::INTERRUPTED || !is_closed_everywhere(input) ||
     !is_known_to_be_tighter(input, curves, result.status, watch))
    return;
  curves = std::move(input);
  result.is_input = true;
  result.is_round = false;
  result.is_ropelength_lowered = false;
  result.thickness = 2 * polygonal_thickness(curves); // the distance that strands keep
  if(result.status == Untangling_status::UNKNOTTED) result.proofs = unknot_proofs(curves);
  if(!parameters.certificate) return;
  Isotopy_guard_3 guard(curves);
  guard.start_recording();
  *parameters.certificate = guard.certificate();
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_UNTANGLING_KEEP_TIGHTER_INPUT_H
