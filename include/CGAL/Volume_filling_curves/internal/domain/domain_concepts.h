// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_CONCEPTS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_CONCEPTS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/geometry/Vector.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Concepts of domains, detected by the members of a type, and the rays that a domain with a surface
// shortens.

// Rays from a point in directions of a plane, each with a length, in one array per coordinate.
struct Planar_rays
{
  Vector source, normal;
  std::vector<double> x, y, z; // of the directions, unit vectors orthogonal to the normal
  std::vector<double> lengths; // 0 for rays that do not matter

  std::size_t size() const { return lengths.size(); }
  double longest() const { return *std::max_element(lengths.begin(), lengths.end()); }
  Vector direction(std::size_t l) const { return {x[l], y[l], z[l]}; }

  void set_direction(std::size_t l, const Vector& direction)
  {
    for(auto* values : {&x, &y, &z}) values->resize(size());
    x[l] = direction.x();
    y[l] = direction.y();
    z[l] = direction.z();
  }
};

// `VolumeFillingDomain_3`: a domain, and not a mesh
template <typename Domain, typename = void>
struct Is_domain : std::false_type
{};

template <typename Domain>
struct Is_domain<Domain,
                 std::void_t<decltype(std::declval<const Domain&>().is_inside(
                     std::declval<const typename Domain::Point_3&>()))>> : std::true_type
{};

// `ScalableVolumeFillingDomain_3`
template <typename Domain, typename = void>
struct Is_scalable : std::false_type
{};

template <typename Domain>
struct Is_scalable<Domain, std::void_t<decltype(std::declval<const Domain&>().scaled(double()))>>
    : std::is_same<Domain, std::decay_t<decltype(std::declval<const Domain&>().scaled(double()))>>
{};

// `VolumeFillingDomainWithSurface_3`
template <typename Domain, typename = void>
struct Has_surface : std::false_type
{};

template <typename Domain>
struct Has_surface<
    Domain,
    std::void_t<decltype(std::declval<const Domain&>().distance_up_to(
                    std::declval<const typename Domain::Point_3&>(), double())),
                decltype(std::declval<const Domain&>().shorten(std::declval<Planar_rays&>())),
                decltype(std::declval<const Domain&>().part(
                    std::declval<const typename Domain::Point_3&>())),
                decltype(std::declval<const Domain&>().part_boxes())>> : std::true_type
{};

// a domain that stands for domains of several kinds
template <typename Domain, typename = void>
struct Stands_for_others : std::false_type
{};

template <typename Domain>
struct Stands_for_others<Domain, std::void_t<decltype(std::declval<const Domain&>().has_surface())>>
    : std::true_type
{};

// Returns whether a domain has a surface; one that stands for others knows it at run time only.
template <typename Domain>
bool has_surface([[maybe_unused]] const Domain& domain)
{
  if constexpr(Stands_for_others<Domain>::value)
    return domain.has_surface();
  else
    return Has_surface<Domain>::value;
}

// a domain that is the inside of a mesh
template <typename Domain, typename = void>
struct Has_corners : std::false_type
{};

template <typename Domain>
struct Has_corners<Domain, std::void_t<decltype(std::declval<const Domain&>().corners())>>
    : std::true_type
{};

// a domain that measures the distance of whole segments to its boundary
template <typename Domain, typename = void>
struct Measures_segments : std::false_type
{};

template <typename Domain>
struct Measures_segments<Domain,
                         std::void_t<decltype(std::declval<const Domain&>().distance_of_segment(
                             std::declval<const typename Domain::Point_3&>(),
                             std::declval<const typename Domain::Point_3&>()))>> : std::true_type
{};

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_DOMAIN_DOMAIN_CONCEPTS_H
