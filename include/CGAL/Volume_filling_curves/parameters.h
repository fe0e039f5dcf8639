// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Named_function_parameters.h>

// The named parameters of this package and those of CGAL that its functions take, in one chain in
// any order: `parameters::thickness(0.1).visitor(my_visitor).tolerance(1e-3)`. CGAL's class of
// parameters knows CGAL's names only; this one derives from it and adds ours, so that CGAL's
// machinery finds both.

namespace CGAL {
namespace Volume_filling_curves {

namespace internal_np {

#define CGAL_VFC_PARAMETER(name) enum name##_t{name};
#include <CGAL/Volume_filling_curves/internal/parameters_interface.h>
#undef CGAL_VFC_PARAMETER

} // namespace internal_np

/// \cond SKIP_IN_MANUAL
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;
  using Pack::Pack;

#define CGAL_VFC_PARAMETER(name)                                               \
  template <typename Value>                                                    \
  auto name(const Value& value) const                                          \
  {                                                                            \
    return Named_parameters<Value, internal_np::name##_t, Pack>(value, *this); \
  }
#include <CGAL/Volume_filling_curves/internal/parameters_interface.h>
#undef CGAL_VFC_PARAMETER

#define CGAL_VFC_PARAMETER(name, tag)                                           \
  template <typename Value>                                                     \
  auto name(const Value& value) const                                           \
  {                                                                             \
    return Named_parameters<Value, CGAL::internal_np::tag, Pack>(value, *this); \
  }
  CGAL_VFC_PARAMETER(number_of_iterations, number_of_iterations_t)
  CGAL_VFC_PARAMETER(point_map, point_t)
  CGAL_VFC_PARAMETER(random_seed, random_seed_t)
  CGAL_VFC_PARAMETER(visitor, visitor_t)
#undef CGAL_VFC_PARAMETER
};
/// \endcond

/// The named parameters of this package, and those of \cgal that its functions take.
namespace parameters {

/// \cond SKIP_IN_MANUAL
#define CGAL_VFC_PARAMETER(name)                                  \
  template <typename Value>                                       \
  auto name(const Value& value)                                   \
  {                                                               \
    return Named_parameters<Value, internal_np::name##_t>(value); \
  }
#include <CGAL/Volume_filling_curves/internal/parameters_interface.h>
#undef CGAL_VFC_PARAMETER

#define CGAL_VFC_PARAMETER(name, tag)                              \
  template <typename Value>                                        \
  auto name(const Value& value)                                    \
  {                                                                \
    return Named_parameters<Value, CGAL::internal_np::tag>(value); \
  }
CGAL_VFC_PARAMETER(number_of_iterations, number_of_iterations_t)
CGAL_VFC_PARAMETER(point_map, point_t)
CGAL_VFC_PARAMETER(random_seed, random_seed_t)
CGAL_VFC_PARAMETER(visitor, visitor_t)
#undef CGAL_VFC_PARAMETER
/// \endcond

/// returns an empty set of parameters.
inline auto default_values()
{
  return CGAL::parameters::default_values();
}

} // namespace parameters
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_PARAMETERS_H
