// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_GROW_FINGERS_H
#define CGAL_VOLUME_FILLING_CURVES_GROW_FINGERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Finger_parameters.h>
#include <CGAL/Volume_filling_curves/Isotopy_guard_3.h>
#include <CGAL/Volume_filling_curves/internal/fingers/Finger_tree.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/signatures.h>
#include <CGAL/Volume_filling_curves/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What `grow_fingers()` returns.
struct Finger_growth
{
  std::size_t number_of_places = 0;  ///< well-spaced points that were to be reached
  std::size_t number_of_fingers = 0; ///< of those, how many were
};

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief lets curves reach out all over a domain: the start of `fill()`, for those who go on in
 * their own way.
 *
 * Points that are 2.9 r apart are scattered in the domain, at least r/2 from its boundary, or r/8
 * where it is narrow. Along a random spanning tree of them, which begins at the curves, fingers
 * grow: an edge of the curve is halved, and one half is pulled out to the next point, with a blunt
 * tip that is 1.4 r wide. These are three insertions of nodes that the guard certifies, so that the
 * result is ambient isotopic to what it was: the outline of a tree, in place of a small circle. To
 * points that no straight finger gets to, ways with room for a ball of radius r/14 are searched,
 * and thin fingers are led along them, through necks and around corners. The time is near linear in
 * the number of points.
 *
 * Of several components the one that has got least of the volume grows first, so that they share
 * it. Pinned nodes stay where they are; networks keep their graph. The curves are numbered again.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam Domain a model of `VolumeFillingDomain_3` with the same point type, bounded
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param guard the guard of the curves, in their domain
 * \param np an optional sequence of the named parameters `thickness`, a number or a function of
 * `Point_3`, `direction_field`, `direction_weight`, `random_seed` and `time_limit`, see
 * `Finger_parameters`
 *
 * \returns how many points there are, and how many of them were reached
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a parameter has a value that it must not have, if there is no
 * thickness, or if the direction field is not finite somewhere, with its name in the message
 */
template <typename Traits,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Finger_growth grow_fingers(Isotopy_guard_3<Traits, Domain>& guard,
                           const NamedParameters& np = parameters::default_values())
{
  using Point_3 = typename Traits::Point_3;
  CGAL_precondition_msg(!guard.curve().has_garbage(), "the network has no garbage");
  const auto parameters = internal::get_parameters<internal::Finger_signature<Point_3>>(np);
  internal::check_parameters(parameters);
  if(!parameters.thickness_field && !(parameters.thickness > 0))
    throw std::invalid_argument("thickness: there is none, and fingers have no default");
  const auto thickness = [&](const Point_3& p) {
    return parameters.thickness_field ? parameters.thickness_field(p) : parameters.thickness;
  };
  Real_timer timer;
  timer.start();
  const internal::Deadline deadline(timer, parameters.time_limit);
  auto tree = internal::finger_tree(guard, guard.walls().domain(), thickness,
                                    parameters.random_seed, deadline);
  tree.follow(parameters.direction_field, parameters.direction_weight);
  tree.grow();
  return {tree.number_of_places(), tree.number_of_fingers()};
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_GROW_FINGERS_H
