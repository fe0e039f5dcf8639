// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H
#define CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/curve/Self_contacts.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_of_polylines.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Gauss_code_reader.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Goeritz_form.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knottedness.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identification.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Link_identity.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Pd_code_reader.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_codes.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>
#include <CGAL/Volume_filling_curves/internal/identification/Chain_identification.h>
#include <CGAL/Volume_filling_curves/internal/identification/Curve_identification.h>
#include <CGAL/Volume_filling_curves/internal/identification/chain_closures.h>
#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/named_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/support/Run_watch.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Chain_identity.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * \brief names the knot, or computes the invariants of the link, that a diagram shows.
 *
 * The diagram is simplified by Reidemeister moves and cut into the pieces of a connected sum. The
 * HOMFLY-PT polynomial and the colored Jones polynomial of dimension 3 of each piece are looked up
 * in a table of the prime knots of up to 10 crossings and their sums of up to three factors. Two
 * chiral knots, 9_42 and 10_71, share both polynomials with their mirror images; the colored Jones
 * polynomial of dimension 4 distinguishes them.
 *
 * A knot of 10 crossings takes milliseconds. Polynomials that would take more than about a second
 * are left out: HOMFLY-PT typically above 100 crossings, and the colored Jones polynomials, without
 * which a knot has no name, above 25.
 *
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param diagram the diagram
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns the name, proofs and invariants
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code, or if there are
 * more than 10,000 components
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Link_identity identify(const Planar_diagram& diagram,
                                     const NamedParameters& np = parameters::default_values())
{
  internal::check_planar_diagram(diagram);
  constexpr std::size_t max_components = 10000; // their linking matrix takes 400 MB
  const std::size_t n = internal::number_of_components(diagram);
  if(n > max_components)
    throw std::invalid_argument("links of more than 10,000 components are not identified; this one "
                                "has " +
                                std::to_string(n));
  return internal::measured(np, [&](internal::Run_watch* watch) {
    const internal::Watched_scope scope(watch);
    return internal::Link_identification(internal::simplified_diagram(diagram))();
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * \brief names the knot, or computes the invariants of the link, that closed curves form.
 *
 * A copy of the curves is simplified by certified operations and projected along 20 directions with
 * exact predicates. The diagram with the fewest crossings is identified, see the overload for a
 * `Planar_diagram`. Hence a proof of the name holds for the curves themselves. If a diagram with
 * fewer crossings may prove the name, and the simplified curves have at most 200 edges, the search
 * of `untangle()` reduces the number of edges, and the result is identified likewise.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns the name, proofs and invariants
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, if their size is below 1e-150, or
 * if a component is open or has a junction
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Link_identity identify(const Curve_network_3<Traits>& curves,
                                     const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  return internal::measured(np, [&](internal::Run_watch* watch) {
    const internal::Watched_scope scope(watch);
    return internal::Curve_identification<Curve_network_3<Traits>>(curves, *watch)();
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * names the knot, or computes the invariants of the link, that one or several polylines form. A
 * closed polyline repeats its first point, as usual in \cgal. See the overload for
 * `Curve_network_3`.
 *
 * \tparam Polylines a range of points, or of such ranges
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polylines the polylines
 * \param np \vfcNamedParams{Measure_polylines_signature}
 *
 * \returns the name, proofs and invariants
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines
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

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * \brief names the knots that an open chain, such as a protein, forms when it is closed.
 *
 * An open chain has no knot type, but each closure has. The chain is closed by extending both ends
 * along one direction to infinity, for many directions spread evenly on the sphere; the result
 * lists the knots with their frequencies. Further closures are the segment between the ends and the
 * minimally interfering one. Each closure is exact, and named as by `identify()`; the frequencies
 * are estimates.
 *
 * If wanted, the core of the knot and the knots of all sections (the fingerprint), with slipknots,
 * follow. A closure of a protein of 331 residues takes 0.4 ms, and one of its sections 0.07 ms on
 * average; the core takes 20 times as long as the chain. The result does not depend on the number
 * of threads.
 *
 * \tparam ConcurrencyTag enables parallel closures: `Sequential_tag` (default), `Parallel_tag` or
 * `Parallel_if_available_tag`
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves
 * \param component the number of the component that is the chain
 * \param np \vfcNamedParams{Chain_signature}
 *
 * \returns the knots of the closures and, if wanted, the core and the fingerprint
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if the curves are not embedded, their size is below 1e-150, the
 * component does not exist, is closed or branches, or a parameter is out of its range
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Traits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Chain_identity identify_chain(
    const Curve_network_3<Traits>& curves,
    std::size_t component,
    const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  const auto given = internal::get_parameters<internal::Chain_signature>(np);
  internal::check_parameters(given);
  return internal::measured(parameters::progress(given.progress), [&](internal::Run_watch* watch) {
    const internal::Watched_scope scope(watch);
    internal::check_embedded(curves);
    return internal::Chain_identification<ConcurrencyTag>(
        internal::points_of_chain(curves, component), given, *watch)();
  });
}

/*!
 * \ingroup PkgVolumeFillingCurvesKnots
 *
 * names the knots that an open polyline forms when it is closed. See the overload for
 * `Curve_network_3`.
 *
 * \tparam ConcurrencyTag enables parallel closures
 * \tparam Polyline a range of points
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param polyline the polyline
 * \param np \vfcNamedParams{Chain_polyline_signature}
 *
 * \returns the knots of the closures and, if wanted, the core and the fingerprint
 *
 * \throws std::invalid_argument like that overload and the constructor of `Curve_network_3` from
 * polylines
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename ConcurrencyTag = Sequential_tag,
          typename Polyline,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::is_range_of_items<Polyline>, int> = 0
#endif
          >
[[nodiscard]] Chain_identity identify_chain(
    const Polyline& polyline, const NamedParameters& np = parameters::default_values())
{
  static_assert(!internal::is_range_of_ranges<Polyline>,
                "identify_chain() takes one polyline, a range of points");
  const auto given = internal::get_parameters<internal::Chain_polyline_signature>(np);
  return identify_chain<ConcurrencyTag>(
      internal::network_of_polylines_t<Polyline, NamedParameters>(polyline, np), 0,
      parameters::closures(given.closures)
          .random_seed(given.random_seed)
          .find_core(given.find_core)
          .stride(given.stride)
          .progress(given.progress));
}

/// \addtogroup PkgVolumeFillingCurvesKnots
/// @{

/*!
 * returns a diagram with few crossings of the knot or link formed by closed curves.
 *
 * The curves are projected along 20 directions, and the diagram with the fewest crossings is
 * simplified. Every crossing rests on exact predicates, and every step of the simplification is a
 * sequence of Reidemeister moves; hence the result is certainly a diagram of the curves. The unknot
 * and 127 prime knots of up to 10 crossings, all tangled, reach their crossing number. Takes nearly
 * linear time in the number of nodes and crossings; calling `simplify_curves()` first makes it
 * faster.
 *
 * \tparam Traits a model of `CurveFlowTraits_3`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param curves the curves
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \pre the network has no garbage
 *
 * \throws std::invalid_argument if a component is open or has a junction, or if the curves are not
 * embedded
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Planar_diagram knot_diagram(const Curve_network_3<Traits>& curves,
                                          const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition_msg(!curves.has_garbage(), "the network has no garbage");
  constexpr std::size_t directions = 20;
  return internal::measured(np, [&](internal::Run_watch* watch) {
    const internal::Watched_scope scope(watch);
    const auto polygons = internal::closed_polygons(curves);
    return internal::simplified_diagram(internal::best_diagram(polygons, directions));
  });
}

/*!
 * searches for a proof that the link of a diagram is trivial or that it is not.
 *
 * If all crossings can be removed, the link is trivial. If two components have a linking number
 * other than 0, or the determinant, Alexander polynomial or HOMFLY-PT polynomial differs from that
 * of the trivial link, it is not. The HOMFLY-PT polynomial is skipped if it would take more than
 * about a second. Takes milliseconds up to some hundred crossings.
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 */
[[nodiscard]] inline Knottedness knottedness(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::knottedness(internal::simplified_diagram(diagram));
}

/*!
 * returns the coefficients of the Alexander polynomial, from the lowest power: 1, -1, 1 for the
 * trefoil; none if the polynomial is 0. For a knot their sum is 1. Takes 0.7 s for 257 crossings.
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 */
[[nodiscard]] inline std::vector<Exact_integer> alexander_polynomial(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::alexander_polynomial(diagram);
}

/*!
 * returns the determinant of a link, which is the absolute value of the Alexander polynomial at -1,
 * from the Goeritz form. Takes 0.2 s for 2,600 crossings.
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 */
[[nodiscard]] inline Exact_integer determinant(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::Goeritz_form(diagram).determinant();
}

/*!
 * returns the signature of a link, -2 for the right-handed trefoil, by the formula of Gordon and
 * Litherland \cgalCite{vfc:gl-osl-78}. Takes milliseconds for 600 crossings.
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 */
[[nodiscard]] inline int signature(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::Goeritz_form(diagram).signature();
}

/*!
 * returns the sum of the signs of the crossings.
 *
 * \throws std::invalid_argument if the crossings are not a planar diagram code
 */
[[nodiscard]] inline int writhe(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::writhe(diagram);
}

/// returns the planar diagram code in the form of KnotTheory, with arcs numbered from 1: `PD[X[1,
/// 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]`; a component without crossings is `Loop[7]`.
/// \throws std::invalid_argument if the crossings are not a planar diagram code
[[nodiscard]] inline std::string pd_code(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::pd_code(diagram);
}

/// returns the signed Gauss code: the passes of each component in order, such as
/// `O1+U2+O3+U1+O2+U3+`, with ` / ` between components and `-` for one without crossings.
/// \throws std::invalid_argument if the crossings are not a planar diagram code
[[nodiscard]] inline std::string gauss_code(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::gauss_code(diagram);
}

/// returns the Dowker-Thistlethwaite code of a knot, such as `4 6 2`, with a minus if the even pass
/// is the upper one. It does not distinguish a knot from its mirror image.
/// \throws std::invalid_argument if the crossings are not a planar diagram code, or if there is not
/// exactly one component
[[nodiscard]] inline std::string dt_code(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::dt_code(diagram);
}

/// returns the diagram with a planar diagram code, as written by `pd_code()` or in any other
/// notation with four numbers per crossing, from 0 or 1.
/// \throws std::invalid_argument if the code is invalid; the message gives the reason
[[nodiscard]] inline Planar_diagram diagram_of_pd_code(const std::string& text)
{
  return internal::Pd_code_reader(text)();
}

/// returns the diagram with a signed Gauss code, as written by `gauss_code()`.
/// \throws std::invalid_argument if the code is invalid; the message gives the reason
[[nodiscard]] inline Planar_diagram diagram_of_gauss_code(const std::string& text)
{
  return internal::Gauss_code_reader(text)();
}

/// @}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_IDENTIFY_H
