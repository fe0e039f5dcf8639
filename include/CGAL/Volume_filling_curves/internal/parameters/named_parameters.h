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
#include <CGAL/Volume_filling_curves/internal/vocabulary/parameters.h>

#include <functional>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Volume_filling_curves {
namespace internal {

// Named parameters fill a struct by its table. The parameters of a function are its Signature: the
// members of a struct, tags that are no members, such as the visitor, and members that mean nothing
// to it. A named parameter that a function does not take, or whose value has a type that it cannot
// use, is refused at compile time.

template <typename... Tags>
struct Tag_list
{
  template <typename Tag>
  static constexpr bool has = (std::is_same_v<Tags, Tag> || ...);
};

template <typename Parameters_, typename Others_ = Tag_list<>, typename Unused_ = Tag_list<>>
struct Signature
{
  using Parameters = Parameters_;
  using Others = Others_;
  using Unused = Unused_;
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

template <typename Tag, typename Given, typename... Rows>
constexpr bool is_set_by(const std::tuple<Rows...>&)
{
  return ((std::is_same_v<typename Rows::Tag, Tag> && can_set<typename Rows::Value, Given>()) ||
          ...);
}

template <typename Tag, typename... Rows>
constexpr bool has_row(const std::tuple<Rows...>&)
{
  return (std::is_same_v<typename Rows::Tag, Tag> || ...);
}

template <typename Signature, typename Tag>
constexpr bool does_know()
{
  if constexpr(std::is_same_v<Tag, CGAL::internal_np::all_default_t>)
    return true;
  else if constexpr(Signature::Unused::template has<Tag>)
    return false;
  else
    return Signature::Others::template has<Tag> ||
           has_row<Tag>(parameter_table<typename Signature::Parameters>());
}

template <typename Signature, typename Tag, typename Given>
constexpr bool does_take_value()
{
  constexpr auto table = parameter_table<typename Signature::Parameters>();
  return !has_row<Tag>(table) || is_set_by<Tag, Given>(table);
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

// Whether a function with a signature takes a sequence of named parameters.
template <typename Signature, typename NamedParameters>
constexpr bool does_take()
{
  if constexpr(std::is_same_v<NamedParameters, CGAL::internal_np::No_property>)
    return true;
  else {
    using First = decltype(as_sequence(std::declval<NamedParameters>()));
    return does_know<Signature, typename First::Tag>() &&
           does_take_value<Signature, typename First::Tag, typename First::Given>() &&
           does_take<Signature, typename First::Rest>();
  }
}

// The same as an error, which says at the end of its first line which of them it is.
template <typename Signature, typename Tag, typename Given>
struct Check_named_parameter
{
  static_assert(does_know<Signature, Tag>(),
                "this function does not take the named parameter with this Tag");
  static_assert(does_take_value<Signature, Tag, Given>(),
                "the value of the named parameter with this Tag has a type that cannot be used");
};

template <typename Signature, typename NamedParameters>
constexpr void check_named_parameters()
{
  if constexpr(!std::is_same_v<NamedParameters, CGAL::internal_np::No_property>) {
    using First = decltype(as_sequence(std::declval<NamedParameters>()));
    (void)sizeof(Check_named_parameter<Signature, typename First::Tag, typename First::Given>);
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

// Access to a visitor that may be given by reference.
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
