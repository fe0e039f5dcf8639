// Copyright (c) 2026 The Volume_filling_curves authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Volume_filling_curves authors

#ifndef CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
#define CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H

#include <CGAL/license/Volume_filling_curves.h>

#include <CGAL/Volume_filling_curves/internal/parameters/check_parameters.h>
#include <CGAL/Volume_filling_curves/internal/parameters/parameter_tables.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Default_curve_flow_visitor.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/Polyline_conventions.h>
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Translation of named parameters to a struct, by its table. The `Signature` of a function lists
// its parameters: the members of a struct, minus those in `Without`, plus tags that set no member,
// such as the visitor. The compiler rejects a named parameter that the function does not take, or
// whose value has an unsuitable type.

template <typename... Tags>
struct Tag_list
{
  template <typename Tag>
  static constexpr bool has = (std::is_same_v<Tags, Tag> || ...);
  template <typename>
  static constexpr bool lacks = false;
};

template <typename... Tags>
struct Without
{
  template <typename>
  static constexpr bool has = false;
  template <typename Tag>
  static constexpr bool lacks = (std::is_same_v<Tags, Tag> || ...);
};

template <typename Parameters_, typename... Lists>
struct Signature
{
  using Parameters = Parameters_;

  template <typename Tag>
  static constexpr bool has = (Lists::template has<Tag> || ...);
  template <typename Tag>
  static constexpr bool lacks = (Lists::template lacks<Tag> || ...);
};

// Whether a named parameter with a value of type Given can set a member of type Value.
template <typename Value, typename Given>
constexpr bool can_set()
{
  if constexpr(std::is_integral_v<Value>)
    return std::is_integral_v<Given>;
  else if constexpr(std::is_pointer_v<Value>)
    return std::is_convertible_v<Given, Value> ||
           std::is_same_v<Given, std::reference_wrapper<std::remove_pointer_t<Value>>>;
  else
    return std::is_convertible_v<Given, Value>;
}

// The types of the members that a named parameter sets.
template <typename Tag, typename... Rows>
auto types_of_rows(const std::tuple<Rows...>&) -> decltype(std::tuple_cat(
    std::declval<std::conditional_t<std::is_same_v<typename Rows::Tag, Tag>,
                                    std::tuple<typename Rows::Value>,
                                    std::tuple<>>>()...));

template <typename Signature, typename Tag>
using Row_types = decltype(types_of_rows<Tag>(parameter_table<typename Signature::Parameters>()));

// The types of values that a function takes for a named parameter, or none if any type is allowed.
template <typename Signature, typename Tag>
struct Wanted
{
  using types = Row_types<Signature, Tag>;
};

template <typename Signature>
struct Wanted<Signature, internal_np::closure_t>
{
  using types = std::tuple<Closure>;
};

template <typename Signature>
struct Wanted<Signature, internal_np::check_mesh_t>
{
  using types = std::tuple<bool>;
};

template <typename Signature, typename Tag>
using Wanted_types = typename Wanted<Signature, Tag>::types;

template <typename Signature, typename Tag>
constexpr bool does_know()
{
  if constexpr(std::is_same_v<Tag, CGAL::internal_np::all_default_t>)
    return true;
  else if constexpr(Signature::template lacks<Tag>)
    return false;
  else
    return Signature::template has<Tag> || std::tuple_size_v<Row_types<Signature, Tag>> != 0;
}

template <typename Given, typename... Values>
constexpr bool can_set_one_of(const std::tuple<Values...>*)
{
  return sizeof...(Values) == 0 || (can_set<Values, Given>() || ...);
}

template <typename Signature, typename Tag, typename Given>
constexpr bool does_take_value()
{
  return can_set_one_of<Given>(static_cast<Wanted_types<Signature, Tag>*>(nullptr));
}

// The first named parameter of a sequence, and those after it.
template <typename T, typename Tag_, typename Base>
struct Sequence
{
  using Given = T;
  using Tag = Tag_;
  using Rest = Base;
};

template <typename T, typename Tag, typename Base>
Sequence<T, Tag, Base> as_sequence(const CGAL::Named_function_parameters<T, Tag, Base>&);

// Whether a type is that of a sequence of named parameters.
template <typename T, typename = void>
struct Are_named_parameters : std::false_type
{};

template <typename T>
struct Are_named_parameters<T, std::void_t<decltype(as_sequence(std::declval<T>()))>>
    : std::true_type
{};

// Refuses a sequence of named parameters that a function with a signature does not take.
template <typename Signature, typename NamedParameters>
constexpr void check_named_parameters()
{
  if constexpr(!std::is_same_v<NamedParameters, CGAL::internal_np::No_property>) {
    using First = decltype(as_sequence(std::declval<NamedParameters>()));
    using Tag = typename First::Tag;
    internal_np::check<does_know<Signature, Tag>(),
                       does_take_value<Signature, Tag, typename First::Given>(),
                       Wanted_types<Signature, Tag>, typename First::Given>(Tag());
    check_named_parameters<Signature, typename First::Rest>();
  }
}

template <typename Value, typename Tag, typename Given>
void set_value(Value& member, Tag tag, const Given& given)
{
  if constexpr(std::is_pointer_v<Value> && !std::is_convertible_v<Given, Value>)
    member = &given.get();
  else {
    if constexpr(std::is_integral_v<Value> && std::is_signed_v<Given>)
      if(given < 0) refuse_value(tag, given, "must not be negative");
    member = static_cast<Value>(given);
  }
}

template <typename Parameters, typename Row, typename NamedParameters>
void set_member(Parameters& p, const Row& row, const NamedParameters& np)
{
  const auto given = CGAL::parameters::get_parameter(np, typename Row::Tag());
  using Given = std::remove_const_t<decltype(given)>;
  if constexpr(!std::is_same_v<Given, CGAL::internal_np::Param_not_found>)
    if constexpr(can_set<typename Row::Value, Given>())
      set_value(p.*row.member, typename Row::Tag(), given);
}

// Returns the parameters of a function with a signature.
template <typename Signature, typename NamedParameters>
typename Signature::Parameters get_parameters(const NamedParameters& np)
{
  using Parameters = typename Signature::Parameters;
  check_named_parameters<Signature, NamedParameters>();
  Parameters p;
  std::apply([&](const auto&... row) { (set_member(p, row, np), ...); },
             parameter_table<Parameters>());
  return p;
}

// Returns the visitor, or a reference to it if one was given.
template <typename NamedParameters>
auto get_visitor(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return choose_parameter(get_parameter(np, CGAL::internal_np::visitor_t()),
                          Default_curve_flow_visitor());
}

// Access to a visitor, which may be passed by reference.
template <typename Visitor>
Visitor& unwrapped(Visitor& visitor)
{
  return visitor;
}

template <typename Visitor>
Visitor& unwrapped(std::reference_wrapper<Visitor>& visitor)
{
  return visitor;
}

} // namespace internal
} // namespace Volume_filling_curves
} // namespace CGAL

#endif // CGAL_VOLUME_FILLING_CURVES_INTERNAL_PARAMETERS_NAMED_PARAMETERS_H
