// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H
#define CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_of_polylines.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identification.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>
#include <CGAL/Volume_filling_curves/internal/identification/Curve_identification.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/assertions.h>

#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * \brief names the knot, or computes the invariants of the link, that a diagram shows.
 *
 * The diagram is simplified by Reidemeister moves and cut into the pieces whose connected sum it
 * is. HOMFLY-PT and the colored Jones polynomial of dimension 3 of each piece are looked up in a
 * table of the prime knots of up to 10 crossings and their sums of up to three factors. Two chiral knots, 9_42 and 10_71, have both polynomials in
 * common with their mirror images; the one of dimension 4 tells these apart.
 *
 * A knot of 10 crossings takes milliseconds. A polynomial that would take more than about a second
 * is left out: typically of more than 100 crossings for HOMFLY-PT, and 25 for names.
 *
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param diagram the diagram
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Link_identity identify(const Planar_diagram& diagram,
                                     const NamedParameters& np = parameters::default_values())
{
  internal::check_planar_diagram(diagram);
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::Link_identification(internal::simplified_diagram(diagram, watch), watch)();
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * \brief names the knot, or computes the invariants of the link, that closed curves form.
 *
 * A copy of the curves is simplified by certified operations, and projected along 20 directions
 * with exact predicates, of which the diagram with the fewest crossings is taken; see the overload
 * for a `Planar_diagram`. So a proof of the name holds for the curves themselves. A knot whose
 * diagram keeps more than 10 crossings, though it may have fewer, is brought to fewer edges by the
 * search of `untangle()`, if it has at most 200.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, or not all closed, or branch
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Link_identity identify(const Curve_network_3<Traits>& curves,
                                     const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    return internal::Curve_identification<Curve_network_3<Traits>>(curves, *watch)();
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * names the knot, or computes the invariants of the link, of a polyline or several. Closed ones
 * repeat their first point, by \cgal's habit. See the overload for `Curve_network_3`.
 *
 * \tparam Polylines a range of points, or of such ranges
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines
 * \param np \vfcNamedParams{Measure_polylines_signature}
 *
 * \throws std::invalid_argument as that overload and that constructor
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Polylines,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polylines>, int> = 0
#endif
          >
[[nodiscard]] Link_identity identify(const Polylines& polylines,
                                     const NamedParameters& np = parameters::default_values())
{
  const auto given = internal::get_parameters<internal::Measure_polylines_signature>(np);
  return identify(internal::network_of_polylines_t<Polylines, NamedParameters>(polylines, np),
                  parameters::progress(given.progress));
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H
