// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H
#define CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/certificate/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/curve/network_of_polylines.h>
#include <CGAL/Volume_filling_curves/internal/domain/domain_concepts.h>
#include <CGAL/Volume_filling_curves/internal/parameters/watched.h>
#include <CGAL/Volume_filling_curves/internal/polylines/polyline_ranges.h>
#include <CGAL/Volume_filling_curves/internal/replay/Certificate_verifier.h>
#include <CGAL/Volume_filling_curves/internal/replay/Enclosure.h>
#include <CGAL/Volume_filling_curves/internal/replay/Mesh_enclosure.h>
#include <CGAL/Volume_filling_curves/internal/text/number_text.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// The result of `verify_certificate()`.
struct Certificate_verdict
{
  bool is_valid = false; ///< whether the certificate proves the curves to be ambient isotopic

  /// the number, from 1, of the invalid operation or of the operation where the record breaks off;
  /// 0 if the fault is elsewhere
  std::size_t operation = 0;

  std::string message; ///< the fault; empty if there is none

  std::size_t number_of_operations = 0; ///< the number of verified operations

  bool has_domain = false; ///< whether a domain was given; if `is_valid`, the curve never left it

  /// returns the verdict as a sentence with the names of the curves and the domain, for example
  /// "verified: 20 operations; the end is ambient isotopic to the start and never left the domain",
  /// or "rejected: operation 7: " and the message.
  std::string sentence(const std::string& start = "the start",
                       const std::string& end = "the end",
                       const std::string& domain = "the domain") const
  {
    if(is_valid)
      return "verified: " + internal::counted(number_of_operations, "operation") + "; " + end +
             " is ambient isotopic to " + start +
             (has_domain ? " and never left " + domain : std::string());
    return "rejected: " +
           (operation > 0 ? "operation " + std::to_string(operation) + ": " : std::string()) +
           message;
  }
};

namespace internal {

// A network itself, or the network of one or more polylines.
template <typename Curve>
decltype(auto) network_of(const Curve& curve)
{
  if constexpr(is_range_of_items<Curve>)
    return network_of_polylines_t<Curve, CGAL::parameters::Default_named_parameters>(curve);
  else
    return (curve);
}

template <typename Start, typename End>
Certificate_verdict verdict_of(replay::Certificate_verifier& verifier,
                               const Start& start,
                               const End& end)
{
  Certificate_verdict verdict;
  verdict.is_valid = verifier(Canonical_curve(network_of(start)), Canonical_curve(network_of(end)));
  verdict.operation = verifier.wrong_operation();
  verdict.message = verifier.message();
  verdict.number_of_operations = verifier.number_of_operations();
  return verdict;
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief verifies that a certificate proves the curves `start` and `end` to be ambient isotopic.
 *
 * All operations are replayed by an implementation that shares no geometric code with
 * `Isotopy_guard_3`, only the format of the bytes and the order of the nodes in it; questions that
 * `double` arithmetic cannot settle are decided with rational numbers. A certificate that was
 * altered, truncated or made for other curves is rejected. So is a forged one with matching hashes,
 * unless its operations are a valid proof all the same.
 *
 * The numbering of nodes, the direction of edges and pins do not matter; nodes without an edge do
 * not count. Domains are ignored; the overload below takes one.
 *
 * Takes constant time per operation if edges have similar lengths: one or two microseconds.
 *
 * \tparam Start a class with the functions `nodes()`, `edges()`, `point()`, `source()` and
 * `target()` of `Curve_network_3`, or one or more polylines: a range of points, or a range of such
 * ranges. A polyline is closed if its last point repeats the first
 * \tparam End as `Start`
 *
 * \param certificate the certificate
 * \param start the curve at the start
 * \param end the curve at the end
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns whether the certificate is valid, and otherwise the fault
 *
 * \throws std::invalid_argument if a polyline has too few distinct points, or a coordinate that is
 * not finite or beyond 1e150; for other classes, if a coordinate is not finite, or if an edge has a
 * node that is not among `nodes()`
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Start,
          typename End,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<internal::Are_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
[[nodiscard]] Certificate_verdict verify_certificate(
    const Isotopy_certificate& certificate,
    const Start& start,
    const End& end,
    const NamedParameters& np = parameters::default_values())
{
  return internal::watched(Run_stage::VERIFYING, np, [&](internal::Run_watch* watch) {
    internal::replay::Certificate_verifier verifier(certificate.bytes(), nullptr, watch);
    return internal::verdict_of(verifier, start, end);
  });
}

namespace internal {
namespace replay {

template <typename Domain>
auto enclosure_of(const Domain& domain)
{
  if constexpr(Is_domain<Domain>::value)
    return Domain_enclosure<Domain>(domain);
  else
    return Mesh_enclosure(faces_of_closed_mesh(domain));
}

} // namespace replay
} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief verifies that a certificate proves the curves `start` and `end` to be ambient isotopic, by
 * a motion that never leaves a domain.
 *
 * In addition to the conditions without a domain, the start curve must lie strictly inside, and so
 * must every triangle that an operation sweeps. For a mesh this is decided by an implementation
 * that shares no code with `Triangle_mesh_domain_3`: \cgal's AABB tree finds faces, and questions
 * that `double` arithmetic cannot settle are decided with rational numbers. For any other domain it
 * is as certain as the domain's own answers. A certificate of `fill()` is valid for the domain that
 * was filled, or, for polygons, their `Polygon_domain_3`; if no curve was given, its start is
 * `Filling_result::start`.
 *
 * Takes a few microseconds per operation.
 *
 * \tparam Start a class with the functions `nodes()`, `edges()`, `point()`, `source()` and
 * `target()` of `Curve_network_3`, or one or more polylines: a range of points, or a range of such
 * ranges. A polyline is closed if its last point repeats the first
 * \tparam End as `Start`
 * \tparam Domain a model of `FaceListGraph`, or of `VolumeFillingDomain_3` with points that are
 * constructed from three `double`s
 *
 * \param certificate the certificate
 * \param start the curve at the start
 * \param end the curve at the end
 * \param domain a domain, or a closed triangle mesh that bounds one
 * \param np \vfcNamedParams{Progress_signature}
 *
 * \returns whether the certificate is valid, and otherwise the fault
 *
 * \pre no two faces of a mesh meet elsewhere than in a common vertex or a common edge
 *
 * \throws std::invalid_argument like the overload without a domain, and if a mesh has no faces, is
 * not closed, or has a face that is not a triangle or a coordinate that is not finite
 * \throws Run_interrupted if `progress` returns `false`
 */
template <typename Start,
          typename End,
          typename Domain,
          typename NamedParameters = CGAL::parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!internal::Are_named_parameters<Domain>::value, int> = 0
#endif
          >
[[nodiscard]] Certificate_verdict verify_certificate(
    const Isotopy_certificate& certificate,
    const Start& start,
    const End& end,
    const Domain& domain,
    const NamedParameters& np = parameters::default_values())
{
  return internal::watched(Run_stage::VERIFYING, np, [&](internal::Run_watch* watch) {
    const auto enclosure = internal::replay::enclosure_of(domain);
    internal::replay::Certificate_verifier verifier(certificate.bytes(), &enclosure, watch);
    Certificate_verdict verdict = internal::verdict_of(verifier, start, end);
    verdict.has_domain = true;
    return verdict;
  });
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H
