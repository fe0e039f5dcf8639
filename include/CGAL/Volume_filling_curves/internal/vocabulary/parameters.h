// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

// Named parameters of this package, and those of CGAL that its functions take, in one chain in any
// order: `parameters::thickness(0.1).visitor(my_visitor).tolerance(1e-3)`. CGAL's class of
// parameters has only CGAL's names; this one derives from it and adds ours, and CGAL's functions
// find both. The members of the structs that they fill, such as Untangling_parameters, document
// them.

// Applies a macro to the name of each parameter: this package's own ones, and all.
#define CGAL_VFC_OWN_PARAMETERS(X) \
  X(bend_radius)                   \
  X(build_name)                    \
  X(certificate)                   \
  X(check_mesh)                    \
  X(checkpoint)                    \
  X(clearance)                     \
  X(closure)                       \
  X(closures)                      \
  X(coupling)                      \
  X(direction_field)               \
  X(direction_weight)              \
  X(find_core)                     \
  X(junctions)                     \
  X(keep_length)                   \
  X(length)                        \
  X(lower_ropelength)              \
  X(max_displacement)              \
  X(max_distance)                  \
  X(max_radius)                    \
  X(medial_weight)                 \
  X(number_of_chains)              \
  X(number_of_directions)          \
  X(number_of_sides)               \
  X(origins)                       \
  X(ports)                         \
  X(preconditioner)                \
  X(progress)                      \
  X(resume_from)                   \
  X(round_bends)                   \
  X(screening)                     \
  X(spacing)                       \
  X(start)                         \
  X(stop_at_proof)                 \
  X(strand_distance)               \
  X(strategy)                      \
  X(stride)                        \
  X(thickness)                     \
  X(time_limit)                    \
  X(time_step)                     \
  X(tolerance)                     \
  X(volume_shares)                 \
  X(wall)                          \
  X(wall_distance)

#define CGAL_VFC_PARAMETERS(X) \
  CGAL_VFC_OWN_PARAMETERS(X)   \
  X(number_of_iterations)      \
  X(point_map)                 \
  X(random_seed)               \
  X(vertex_point_map)          \
  X(visitor)

namespace CGAL {
namespace Volume_filling_curves {

// The tags, each the type `name_t`.
namespace internal_np {

#define CGAL_VFC_PARAMETER(name) enum name##_t{name};
CGAL_VFC_OWN_PARAMETERS(CGAL_VFC_PARAMETER)
#undef CGAL_VFC_PARAMETER

using CGAL::internal_np::number_of_iterations_t;
using point_map_t = CGAL::internal_np::point_t;
using CGAL::internal_np::random_seed_t;
using vertex_point_map_t = CGAL::internal_np::vertex_point_t;
using CGAL::internal_np::visitor_t;

// The name of a parameter in messages, at run time and at compile time.
#define CGAL_VFC_PARAMETER(name)                                                       \
  constexpr const char* name_of(name##_t)                                              \
  {                                                                                    \
    return #name;                                                                      \
  }                                                                                    \
  template <bool is_known, bool is_usable, typename WantedTypes, typename Given>       \
  constexpr void check(name##_t)                                                       \
  {                                                                                    \
    static_assert(is_known, "this function does not take the named parameter " #name); \
    static_assert(is_usable, "the value of the named parameter " #name                 \
                             " does not convert to any of WantedTypes");               \
  }
CGAL_VFC_PARAMETERS(CGAL_VFC_PARAMETER)
#undef CGAL_VFC_PARAMETER

template <bool is_known, bool is_usable, typename WantedTypes, typename Given, typename Tag>
constexpr void check(Tag)
{
  static_assert(is_known, "this function does not take the named parameter with this Tag");
}

} // namespace internal_np

/// \cond SKIP_IN_MANUAL
// The type of a value as it is kept: string literals are pointers, since CGAL wraps references to
// arrays, which set no member.
template <typename Value>
using Kept_value = std::decay_t<const Value&>;

template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;
  using Pack::Pack;

#define CGAL_VFC_PARAMETER(name)                                                           \
  template <typename Value>                                                                \
  auto name(const Value& value) const                                                      \
  {                                                                                        \
    return Named_parameters<Kept_value<Value>, internal_np::name##_t, Pack>(value, *this); \
  }
  CGAL_VFC_PARAMETERS(CGAL_VFC_PARAMETER)
#undef CGAL_VFC_PARAMETER
};
/// \endcond

/// The named parameters of this package, and those of \cgal that its functions take.
namespace parameters {

/// \cond SKIP_IN_MANUAL
#define CGAL_VFC_PARAMETER(name)                                              \
  template <typename Value>                                                   \
  auto name(const Value& value)                                               \
  {                                                                           \
    return Named_parameters<Kept_value<Value>, internal_np::name##_t>(value); \
  }
CGAL_VFC_PARAMETERS(CGAL_VFC_PARAMETER)
#undef CGAL_VFC_PARAMETER
/// \endcond

/*!
 * \ingroup PkgVolumeFillingCurvesRef
 * \headerfile CGAL/Volume_filling_curves/untangle.h
 *
 * \brief combines two sequences of named parameters into one, which can be continued.
 *
 * A sequence that starts in the namespace `CGAL::parameters` can only continue with \cgal's
 * parameters. This function appends parameters of this package:
 * `combine(CGAL::parameters::vertex_point_map(map), parameters::thickness(0.1)).time_limit(60)`.
 * All parameters of the package's functions are also in this namespace, and can follow one another
 * in any order.
 *
 * \tparam First a sequence of named parameters, of \cgal or of this package
 *
 * \param first the sequence that comes first
 * \param second another sequence, with none of the parameters of the first
 */
template <typename First, typename T, typename Tag, typename Base>
auto combine(const First& first, const CGAL::Named_function_parameters<T, Tag, Base>& second)
{
  if constexpr(std::is_same_v<Base, CGAL::internal_np::No_property>)
    return Named_parameters<T, Tag, typename First::self>(second.v, first);
  else {
    const auto rest = combine(first, static_cast<const Base&>(second));
    return Named_parameters<T, Tag, typename decltype(rest)::self>(second.v, rest);
  }
}

/// returns an empty set of parameters.
inline auto default_values()
{
  return CGAL::parameters::default_values();
}

} // namespace parameters
} // namespace Volume_filling_curves
} // namespace CGAL

#undef CGAL_VFC_OWN_PARAMETERS
#undef CGAL_VFC_PARAMETERS

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_VOCABULARY_PARAMETERS_H
