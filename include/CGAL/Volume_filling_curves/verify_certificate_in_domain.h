// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_IN_DOMAIN_H
#define CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_IN_DOMAIN_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/domain/Is_domain.h>
#include <CGAL/Volume_filling_curves/internal/replay/Enclosure.h>
#include <CGAL/Volume_filling_curves/internal/replay/Mesh_enclosure.h>
#include <CGAL/Volume_filling_curves/verify_certificate.h>

namespace CGAL {
namespace Volume_filling_curves {

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
 * \brief verifies that a certificate proves that the curve `end` is ambient isotopic to the curve
 * `start`, and that the curve has been inside a domain all the time.
 *
 * In addition to what `verify_certificate()` does without a domain, the curve at the start must lie
 * strictly inside, and so must every triangle that an operation sweeps. Of a mesh this is decided
 * by an implementation that shares nothing with `Triangle_mesh_domain_3`: CGAL's AABB tree finds
 * faces, and what arithmetic with `double` cannot prove is decided with rational numbers. Of any
 * other domain it is as certain as the domain's own answers. A certificate of `fill()` is valid for
 * the domain that was filled.
 *
 * Takes a few microseconds per operation.
 *
 * \tparam Curve a class with the functions `nodes()`, `edges()`, `point()`, `source()` and
 * `target()` of `Curve_network_3`
 * \tparam Domain a model of `FaceListGraph`, or of `VolumeFillingDomain_3` with points that are
 * constructed from three `double`s
 *
 * \param certificate the certificate
 * \param start the curve at the start
 * \param end the curve at the end
 * \param domain a closed triangle mesh, whose inside it is, or a domain
 *
 * \returns whether the certificate is valid, and if not, why not
 *
 * \pre no two faces of a mesh meet elsewhere than in a common vertex or a common edge
 *
 * \throws std::invalid_argument if a mesh is not closed, has a face that is no triangle or a
 * coordinate that is not finite
 */
template <typename Curve, typename Domain>
Certificate_verdict verify_certificate(const Isotopy_certificate& certificate,
                                       const Curve& start,
                                       const Curve& end,
                                       const Domain& domain)
{
  const auto enclosure = internal::replay::enclosure_of(domain);
  internal::replay::Certificate_verifier verifier(certificate.bytes(), &enclosure);
  return internal::verdict_of(verifier, start, end);
}

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_VERIFY_CERTIFICATE_IN_DOMAIN_H
