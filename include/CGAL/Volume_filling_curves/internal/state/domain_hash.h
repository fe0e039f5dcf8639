// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_DOMAIN_HASH_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_DOMAIN_HASH_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Random_source.h>
#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>
#include <CGAL/Volume_filling_curves/internal/state/State_writer.h>
#include <CGAL/Volume_filling_curves/internal/state/run_fingerprint.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Whether a domain tells the corners of all of its faces.
template <typename Domain, typename = void>
constexpr bool has_corners = false;

template <typename Domain>
constexpr bool has_corners<Domain, std::void_t<decltype(std::declval<const Domain&>().corners())>> =
    true;

// A hash by which to know a domain again: of all corners of a mesh, and of other domains, whose
// insides are unknown, of the answers to a few random questions.
template <typename Domain, typename Traits>
std::string domain_hash(const Domain& domain, const Traits& traits)
{
  constexpr std::size_t number_of_questions = 1000;
  State_writer answers;
  if constexpr(has_corners<Domain>) answers(domain.corners());
  const auto box = domain.bbox();
  answers(box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax());
  Random_source random(0);
  for(std::size_t k = 0; k < number_of_questions; ++k) {
    const double x = random.real(), y = random.real(), z = random.real();
    const auto p = to_point(Vector(box.xmin() + x * box.x_span(), box.ymin() + y * box.y_span(),
                                   box.zmin() + z * box.z_span()),
                            traits);
    const bool is_inside = domain.is_inside(p);
    answers(is_inside, is_inside ? domain.distance(p) : 0);
  }
  return to_hex(sha256(answers.bytes()));
}

} // namespace internal

} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_STATE_DOMAIN_HASH_H
