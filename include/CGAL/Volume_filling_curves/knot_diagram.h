// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_KNOT_DIAGRAM_H
#define CGAL_VOLUME_FILLING_CURVES_KNOT_DIAGRAM_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/curve/Curve_network_3.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Gauss_code_reader.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Goeritz_form.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Knottedness.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Pd_code_reader.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/Planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/alexander_polynomial.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_codes.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/diagram_of_curve.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/is_planar_diagram.h>
#include <CGAL/Volume_filling_curves/internal/diagrams/simplified_diagram.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {

/// \addtogroup PkgVolumeFillingCurvesKnots
/// @{

/*!
 * returns a diagram with few crossings of the knot or link formed by closed curves.
 *
 * The curves are projected along 20 directions, and the diagram with the fewest crossings is
 * simplified. Every crossing rests on exact predicates, and every step of the simplification is a
 * sequence of Reidemeister moves; hence the result is certainly a diagram of the curves. 128
 * tangled prime knots of up to 10 crossings reach their crossing number. Takes near-linear time in
 * the number of nodes and crossings; calling `simplify_curves()` first makes it faster.
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
    const auto polygons = internal::closed_polygons(curves);
    return internal::simplified_diagram(internal::best_diagram(polygons, directions, watch), watch);
  });
}

/*!
 * searches for a proof that the link of a diagram is trivial or that it is not.
 *
 * If all crossings can be removed, the link is trivial. If its determinant, Alexander polynomial or
 * HOMFLY-PT polynomial differs from that of the trivial link, it is not. The HOMFLY-PT polynomial
 * is skipped if it would take more than about a second. Takes milliseconds up to some hundred
 * crossings.
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
 * Litherland. Takes milliseconds for 600 crossings.
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
[[nodiscard]] inline std::string pd_code(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::pd_code(diagram);
}

/// returns the signed Gauss code: the passes of each component in order, such as
/// `O1+U2+O3+U1+O2+U3+`, with ` / ` between components and `-` for one without crossings.
[[nodiscard]] inline std::string gauss_code(const Planar_diagram& diagram)
{
  internal::check_planar_diagram(diagram);
  return internal::gauss_code(diagram);
}

/// returns the Dowker-Thistlethwaite code of a knot, such as `4 6 2`, with a minus if the even pass
/// is the upper one. It does not distinguish a knot from its mirror image.
/// \throws std::invalid_argument unless there is one component
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

#endif // CGAL_VOLUME_FILLING_CURVES_KNOT_DIAGRAM_H
