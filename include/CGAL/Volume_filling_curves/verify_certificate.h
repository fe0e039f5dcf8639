// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H
#define CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/Isotopy_certificate.h>
#include <CGAL/Volume_filling_curves/internal/replay/Certificate_verifier.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_filling_curves {

/// \ingroup PkgVolumeFillingCurvesRef
///
/// What `verify_certificate()` has found out.
struct Certificate_verdict
{
  bool is_valid = false; ///< whether the certificate proves that the curves are ambient isotopic

  /// the number of the operation, from 1, that is wrong or at which the record ends, or 0 if it is
  /// none of them
  std::size_t operation = 0;

  std::string message; ///< what is wrong; empty if nothing is

  std::size_t number_of_operations = 0; ///< how many operations were verified
};

namespace internal {

template <typename Curve>
Certificate_verdict verdict_of(replay::Certificate_verifier& verifier,
                               const Curve& start,
                               const Curve& end)
{
  Certificate_verdict verdict;
  verdict.is_valid = verifier(Canonical_curve(start), Canonical_curve(end));
  verdict.operation = verifier.wrong_operation();
  verdict.message = verifier.message();
  verdict.number_of_operations = verifier.number_of_operations();
  return verdict;
}

} // namespace internal

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 *
 * \brief verifies that a certificate proves that the curve `end` is ambient isotopic to the curve
 * `start`.
 *
 * All operations are carried out again, by an implementation that shares nothing with
 * `Isotopy_guard_3`: what arithmetic with `double` cannot prove is decided with rational numbers.
 * A certificate that was altered, cut off or made for other curves is refused. So is one that was
 * forged, with hashes that fit, unless what it tells is a proof in spite of that.
 *
 * How the nodes of the curves are numbered, the direction of edges and pins do not matter.
 * Nodes need not be pinned where they were, and a domain is not considered: the overload in
 * `verify_certificate_in_domain.h` does that.
 *
 * Takes constant time per operation if edges have similar lengths: a microsecond or two.
 *
 * \tparam Curve a class with the functions `nodes()`, `edges()`, `point()`, `source()` and
 * `target()` of `Curve_network_3`
 *
 * \param certificate the certificate
 * \param start the curve at the start
 * \param end the curve at the end
 *
 * \returns whether the certificate is valid, and if not, why not
 */
template <typename Curve>
Certificate_verdict verify_certificate(const Isotopy_certificate& certificate,
                                       const Curve& start,
                                       const Curve& end)
{
  internal::replay::Certificate_verifier verifier(certificate.bytes());
  return internal::verdict_of(verifier, start, end);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_H
